// Whether a robot's arm may stand where its joints say: against the world, against the robot itself
// (the other arm, the lift, the head) and with what it carries.
//
// Eight postures are tested at once, one a lane: a motion is cut into eighths that are looked at
// together, so most collisions are found in the first look (as in VAMP; Thomason, Kingston,
// Kavraki, ICRA 2024). Against the world the robot is its links' spheres, made larger by a margin.
// Against itself the spheres only sort out; what is left is decided by exact capsule distances.
//
// Links that no joint of the group moves keep the place that the state gives them; they are tested
// against the arm, but not against the world (the foot of an arm stands on its table).
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "motion/collision_world.h"
#include "motion/rrt_connect.h"
#include "robots/robot.h"
#include "robots/self_collision.h"

namespace marketgen::motion {

// What planning needs to know of a group of joints, made once. Refers to the robot, which must
// outlive it.
struct ArmModel {
  const robots::Robot* robot = nullptr;
  robots::JointGroup group;
  std::vector<robots::LinkPair> pairs;  // of the robot that may touch
  std::vector<double> lower, upper;     // of the group's joints, rad or m
};

// Errors: robot.unknown when there is no such group, motion.bad_configuration when it has no joint,
// more than 16, or one without limits.
Result<ArmModel> make_arm_model(const robots::Robot& robot, std::string_view group);

// Something held: its spheres move with the link and are tested against the world and the robot,
// except the links it may touch (the fingers that hold it).
struct AttachedObject {
  int link = 0;
  std::vector<robots::Sphere> spheres;  // link frame
  std::vector<int> may_touch;           // links
};

struct ArmCheckOptions {
  double margin_m = 0.004;  // every sphere of the robot is this much larger
  std::vector<AttachedObject> attached = {};
  // Links that are tested against `their_world` in place of the world: a hand at work goes where
  // the arm that moves it must not.
  std::vector<int> at_work = {};
  const CollisionWorld* their_world = nullptr;
};

// Refers to the model and the worlds, which must outlive it. Any number of threads may ask.
class ArmChecker {
 public:
  // `state`: every degree of freedom of the robot. Errors: those of check_state,
  // motion.bad_configuration for an attached object that is not finite, has no sphere or is on a
  // link that the group does not move.
  static Result<ArmChecker> make(const ArmModel& model,
                                 std::span<const double> state,
                                 const Pose& world_from_base,
                                 const CollisionWorld& world,
                                 const ArmCheckOptions& options = {});

  bool free(std::span<const double> q) const;  // q: of the group's joints
  // `b` and postures between `a` and `b` that lie at most `step_m` of travel apart. With a step of
  // twice the margin no posture in between can touch the world.
  bool motion_free(std::span<const double> a, std::span<const double> b, double step_m) const;
  double travel_m(std::span<const double> a, std::span<const double> b) const;  // bound, any point
  // What collides first: "link5 with boxes/3"; empty when nothing does.
  std::string collision(std::span<const double> q) const;

  ConfigurationSpace space(double step_m) const;  // refers to this checker
  std::size_t spheres() const { return balls_.size(); }
  const ArmModel& model() const { return *model_; }
  double margin_m() const { return margin_m_; }
  // Every degree of freedom, with `q` for the group's and those that follow them.
  std::vector<double> state_with(std::span<const double> q) const;

 private:
  struct Ball {
    float x = 0, y = 0, z = 0, radius = 0;  // radius with the margin
  };
  struct Part {  // a link or an attached object
    std::string name;
    const CollisionWorld* world = nullptr;
    int link = 0, body = -1;
    Ball bound;                                // holds every ball
    std::size_t first_ball = 0, end_ball = 0;  // body frame; world frame for body -1
  };
  // A rigid body that the group moves. Its frame is turned so that its joint moves it along or
  // about Z.
  struct Body {
    int parent = -1;  // body; -1: what stands still
    bool turns = true;
    std::size_t column = 0;  // of the group's joints
    float ratio = 1, offset = 0;
    std::array<float, 9> rotation{};  // parent_from_body at 0, row by row; from the world at -1
    std::array<float, 3> position{};
    double offset_m = 0;  // length of `position` and of what the joint adds at most
  };
  struct PartPair {
    std::size_t a = 0, b = 0;
    bool exact = true;  // capsules decide, not spheres
  };
  struct Rake;
  struct Hit {
    std::string a, b;
  };

  Rake& scratch() const;
  void place(Rake& rake) const;
  void place_balls(std::size_t part, Rake& rake) const;
  bool hits_world(Rake& rake, Hit* hit) const;
  bool hits_itself(Rake& rake, Hit* hit) const;
  bool hits(Rake& rake, Hit* hit) const;
  bool balls_meet(const PartPair& pair, Rake& rake) const;
  std::uint32_t lanes_that_meet(const PartPair& pair, Rake& rake) const;

  void add_bodies();
  void add_part(int link, const std::vector<robots::Sphere>& spheres, std::string name);
  Result<void> add_attached(const AttachedObject& object, std::size_t index);
  void add_pairs(const std::vector<AttachedObject>& attached);
  void find_reach();

  const ArmModel* model_ = nullptr;
  const CollisionWorld* world_ = nullptr;
  std::vector<double> state_;
  std::vector<Pose> world_from_link_;  // at state_
  double margin_m_ = 0;
  std::vector<Body> bodies_;
  std::vector<int> body_of_link_;
  std::vector<Pose> body_from_link_;
  std::vector<Part> parts_;  // links, then attached objects
  std::size_t links_ = 0;    // of the parts
  std::vector<Ball> balls_;
  std::vector<PartPair> pairs_;
  std::vector<double> reach_;  // how far a point moves for one rad or m of each joint, at most, m
};

}  // namespace marketgen::motion
