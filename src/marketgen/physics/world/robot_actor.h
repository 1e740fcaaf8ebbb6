// A robot's body in a World: links with their masses and inertias, joints with limits and rotor
// inertia, drives, and its gravity carried by them.
//
// add_robot() is for WorldOptions::add_actors. Afterwards a RobotActor reads the joints and drives
// them. Vectors have one entry per degree of freedom of the Robot, rad or m; those that follow
// another (second fingers) are read and never driven. Links touch with their capsules, the fingers
// of a gripper with their solids, which are flat where they hold, cups with theirs behind the lip.
// Links that cannot or need not touch one another are left out (pairs_that_may_touch()).
#pragma once
#include <map>
#include <span>
#include <string>
#include <vector>

#include "physics/world/world.h"
#include "robots/setpoint.h"
#include "robots/wheel_drive.h"

namespace marketgen::physics {

// What a control is. `position`: a joint's place, followed by a servo that gives its full effort at
// an error of 0.02 rad or 2 mm (about the gains published for the Panda) and is damped by a tenth
// of its stiffness a second. `torque`: the effort itself, for controllers of one's own. A base that
// drives is pushed by its wheels in both (push_base).
enum class RobotDrive { position, torque };

// With what a gripper touches. `plain`: the hand with its capsules, pads with their flat boxes.
// `fine`: the hand with the boxes of its look, as grasps know it (capsules stand out beyond it by a
// centimetre, which is more than there is between hand and rim of a basket); pads with a grid of
// balls (physics/world/pad_balls.h), which lie on goods any way round. Off shelves `fine` took 1.6
// times as long, and lost two of four episodes in which `plain` took all goods (RM65 grippers).
enum class GripperTouch { plain, fine };

struct RobotActorOptions {
  std::string prefix = {};  // in front of all its names in the model
  Pose world_from_base = {};
  std::vector<double> state = {};  // at the start; empty: neutral_state()
  RobotDrive drive = RobotDrive::position;
  GripperTouch touch = GripperTouch::plain;
  std::string finger_material = "rubber";  // what it holds with, for robot_materials()
};

// Errors: robot.bad_state (state); physics.bad_command for a robot without a moving joint. What
// MuJoCo refuses comes from World::create.
Result<void> add_robot(mjSpec_& spec, const robots::Robot& robot, const RobotActorOptions& options);

// For WorldOptions::actor_materials: the geoms of the fingers.
std::map<std::string, std::string> robot_materials(const robots::Robot& robot,
                                                   const RobotActorOptions& options);

double finger_speed(const robots::Joint& joint);  // of its row, or a usual one; m/s

// Refers to the robot, which must outlive it; holds no state of the World's.
class RobotActor {
 public:
  // Error physics.bad_command: no robot was added under this prefix.
  static Result<RobotActor> find(const World& world,
                                 const robots::Robot& robot,
                                 const std::string& prefix = {});

  std::vector<double> position(const World& world) const;
  std::vector<double> velocity(const World& world) const;
  std::vector<double> effort(const World& world) const;  // of the drives, gravity included

  // Position drive. The servos lead by what their damping would take at the wanted velocity, so
  // that a trajectory is followed without lag, and drive no joint faster than its row says.
  // `effort` is what they give beside: what the motion is known to take (none when empty). Wheels
  // and fingers are left out. Errors: physics.bad_command (the number of values, NaN, a torque
  // drive); the world is then as before. Values beyond a limit stop at it. This is the bare drive:
  // RobotController keeps the other limits.
  Result<void> command(World& world,
                       std::span<const double> position,
                       std::span<const double> velocity,
                       std::span<const double> effort = {}) const;
  // The fingers of a gripper follow `finger`, a place of one of them, and press on what is in their
  // way with at most `force_n` each. To be called before every step, since the force is measured
  // from where they are. Errors: physics.bad_command (NaN, negative, no gripper, more force than
  // the tool has).
  Result<void> grip(World& world,
                    const robots::Tool& tool,
                    const robots::Setpoint& finger,
                    double force_n) const;
  // What its wheels do to a base that drives, until the next call. Error: physics.bad_command.
  Result<void> push_base(World& world, const robots::FloorForce& force) const;
  // Whether command() moves it: no wheel, finger or follower.
  bool follows_position(std::size_t dof) const { return axes_[dof].follows_position; }
  // How far the fingers' servo has to be off to press with this force, m.
  double finger_reach_m(const robots::Tool& tool, double force_n) const;
  // Torque drive: efforts beyond gravity, which is carried already.
  Result<void> apply(World& world, std::span<const double> effort) const;

 private:
  struct Axis {
    int joint_position = 0, joint_velocity = 0;  // addresses in the model's state
    int actuator = -1;                           // none for a follower
    double stiffness = 0, damping = 0;           // of the servo; 0: it takes an effort
    bool follows_position = false;               // its control is a place
    double max_velocity = 0, locking = 0;        // locking: damping of the joint itself
  };
  Result<void> check(std::span<const double> values, bool servo, const char* what) const;
  const Axis* finger_axis(const robots::Tool& tool) const;  // the one that is driven

  const robots::Robot* robot_ = nullptr;
  std::vector<Axis> axes_;  // of the robot's degrees of freedom
  RobotDrive drive_ = RobotDrive::position;
};

}  // namespace marketgen::physics
