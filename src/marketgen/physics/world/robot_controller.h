// What stands between a robot's commands and its drives, as a robot's own controller does: whatever
// it is told, joints keep the velocity, acceleration, jerk and effort of their row, fingers theirs,
// wheels their torque and grip; and the robot stops when something presses on it too hard.
//
// Joints are driven by their servos and by what their motion takes (inverse dynamics of the row's
// links: their inertia, what they do to one another, friction; as a computed-torque controller
// does), so that a joint that reverses does not pull its neighbours along. What the robot carries
// is not in it.
//
// Protective stop (Robot::contact_limits): when the forces of all contacts of a limit's links with
// anything else, added as vectors (so that a grip cancels out) and averaged over 10 ms, are more
// than its force, the robot takes no command for the limit's pause: joints stay where they are, and
// give way to what still presses; wheels brake; grippers and cups hold what they hold. Then it goes
// on from there with what it is told.
#pragma once
#include <string>
#include <vector>

#include "physics/world/robot_actor.h"

namespace marketgen::physics {

// What a tool is to do. 0 closes a gripper until it presses.
struct GripReference {
  double opening_m = 0;  // between the pads
  double force_n = 0;    // most, on each pad
};

// What a robot is to do at the end of one step of physics.
struct RobotReference {
  std::vector<robots::Setpoint>
      joints;  // one a degree of freedom; not read: wheels, fingers, followers
  std::vector<GripReference> grips;  // one a tool; not read: cups
  double drive_m_s = 0, turn_rad_s = 0;
};

// Refers to the robot, which must outlive it. Not for a robot with torque drives.
class RobotController {
 public:
  RobotController() = default;
  // The robot stands still, as the world has it. Errors: those of RobotActor::find.
  static Result<RobotController> start(const World& world,
                                       const robots::Robot& robot,
                                       const std::string& prefix = {});

  // Before every step. Errors: those of RobotActor; physics.bad_command for another number of
  // joints or tools.
  Result<void> command(World& world, const RobotReference& reference);
  // After every step: feels what presses.
  void feel(const World& world);

  const RobotActor& actor() const { return actor_; }
  // Where the drives are told to be now; of all degrees of freedom.
  std::vector<robots::Setpoint> setpoints() const;
  const robots::WheelDrive& wheels() const { return wheels_; }
  bool stopped(double time_s) const { return time_s < goes_on_s_; }
  int stops() const { return stops_; }                 // so far
  double max_force_n() const { return max_force_n_; }  // that has pressed, as it feels it
  std::vector<double> external_force_n() const;        // that presses now, one a contact limit

  // What changes; the rest it has from start().
  template <class Archive, class Self>
  static void bytes(Archive& archive, Self& self) {
    archive(self.setpoints_, self.fingers_, self.wheels_, self.felt_);
    archive(self.goes_on_s_, self.stops_, self.max_force_n_);
  }

 private:
  void find_parts(const mjModel_& model, const std::string& prefix);
  Result<void> check(const RobotReference& reference) const;
  void follow(const RobotReference& reference, bool stopped, double step_s);
  void keep_near(const std::vector<double>& q, const std::vector<double>& v);
  std::vector<double> effort_of_motion(const std::vector<double>& q,
                                       const std::vector<double>& v) const;
  robots::FloorForce push(const World& world,
                          const RobotReference& reference,
                          bool stopped,
                          double step_s);
  void follow_finger(std::size_t tool,
                     const GripReference& wanted,
                     const std::vector<double>& q,
                     double step_s);
  void give_way(const World& world);

  const robots::Robot* robot_ = nullptr;
  RobotActor actor_;
  std::vector<int> limit_of_;  // by geom: the contact limit of its link, or -1
  std::vector<robots::SmoothSetpoint> setpoints_;
  std::vector<robots::Setpoint> fingers_;  // one a tool; of cups they stay 0
  robots::WheelDrive wheels_;
  std::vector<Vec3> felt_;  // one a contact limit: mean force, store frame
  double goes_on_s_ = 0;
  int stops_ = 0;
  double max_force_n_ = 0;
};

}  // namespace marketgen::physics
