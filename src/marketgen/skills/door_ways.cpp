#include "skills/door_ways.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include <fmt/format.h>

#include "base/interrupt.h"

namespace marketgen::skills {
namespace {

constexpr double radian = std::numbers::pi / 180;

// ---- Where it stands: along the closed door and before it, and how it is turned from looking at
// it, towards the free edge where positive. To open it stands by the free edge, clear of the leaf
// that swings out; to shut it before the open leaf. Found by a search with the robot of the aisles
// on a leaf of 0.62 m, the usual one; on leaves of 0.70 m and more none of them serves: no arm that
// comes with the bar leaves the other room to get behind the leaf. ----
struct Stand {
  double along_m, out_m, turned_rad;  // along_m: to open from the free edge, to shut from the hinge
};
constexpr std::array from_edge_m{-0.07, -0.12, -0.02, 0.03};
constexpr std::array before_m{1.00, 0.95, 1.05};
constexpr std::array turned_rad{15 * radian, 0 * radian, 30 * radian};
std::vector<Stand> opening_stands() {
  std::vector<Stand> stands;
  for (const double turned : turned_rad)
    for (const double along : from_edge_m)
      for (const double out : before_m)
        stands.push_back({along, out, turned});
  return stands;
}
constexpr std::array shutting_stands{
    Stand{0.30, 1.25, 0},
    Stand{0.40, 1.25, 0},
    Stand{0.20, 1.25, 0},
    Stand{0.50, 1.20, 0},
    Stand{0.30, 1.35, 0},
};
// Where a hand that pulls by itself, as far as 62 degrees, is freest to move on its way.
constexpr std::array pulling_stands{
    Stand{-0.12, 1.05, 30 * radian},
    Stand{0.03, 0.95, 0},
    Stand{-0.02, 1.00, 15 * radian},
    Stand{-0.02, 0.95, 0},
    Stand{-0.07, 1.05, 30 * radian},
};
// Heights of the tip over the lift's zero.
constexpr std::array pushing_over_lift_m{0.9, 0.75};
constexpr std::array pulling_over_lift_m{
    0.9, 0.95, 1.0};  // the arm follows from some of them alone

// ---- At the bar. Fingers end before the leaf, which is 2 cm behind the bar's axis: a hand that
// is turned more meets it. ----
constexpr double grip_opening_m = 0.06;
constexpr double tip_behind_bar_m = 0.006;  // of the tool, past the bar's axis
struct Lag {
  double first_rad, last_rad;  // by how much the hand is turned less than the leaf
};
constexpr std::array lags{
    Lag{-25 * radian, 10 * radian}, Lag{-25 * radian, 20 * radian}, Lag{-25 * radian, 30 * radian}};
constexpr double pulled_rad = 65 * radian;

// ---- Pressing on the leaf with fingers that are shut. ----
constexpr double half_finger_m = 0.011;
constexpr double slack_m = 0.015;         // before it is touched
constexpr double touch_rad = 8 * radian;  // of its way until then, at most
constexpr double past_hold_rad = 1.5 * radian;
constexpr double shut_from_there_rad = 62 * radian;  // its spring does the rest
constexpr std::array inside_from_edge_m{0.06, 0.20, 0.30};
constexpr std::array outside_from_edge_m{0.06, 0.10};
constexpr double over_bar_m = 0.07;
struct Aim {
  double first_rad, share;  // how it points, from straight at the closed door; how much of the
                            // leaf's turn it follows
};
// The fingers' tips come nearest to the leaf, from either side.
constexpr std::array inside_aims{Aim{-90 * radian, 0.2}, Aim{-60 * radian, 0.2}};
constexpr std::array outside_aims{
    Aim{0, 0}, Aim{0, 0.5}, Aim{30 * radian, 0.5}, Aim{30 * radian, 0}, Aim{60 * radian, 0}};
constexpr double sweep_step_rad = 5 * radian;

// A tool's tip that points level, turned by `about` from `door.out` reversed, its fingers opening
// level or, `upright`, one over the other.
Pose level_tip(const HingedDoor& door, Vec3 at, double about_rad, bool upright) {
  const double yaw = std::atan2(-door.out.y, -door.out.x) + door.turn() * about_rad;
  const double roll = upright ? std::numbers::pi / 2 : 0;
  return {at,
          rotation_about({0, 0, 1}, yaw) * rotation_about({0, 1, 0}, std::numbers::pi / 2) *
              rotation_about({0, 0, 1}, roll)};
}

class DoorPlanner {
 public:
  DoorPlanner(const robots::Robot& robot, const DoorQuestion& question, Seed seed)
      : robot_(robot), question_(question), door_(question.door), seed_(seed) {}

  Result<void> make_hands() {
    MARKETGEN_TRY(const std::vector<Hand> hands, hands_with(robot_, question_.tool_row));
    for (const Hand& hand : hands) {
      MARKETGEN_TRY(DoorHand made, DoorHand::make(robot_, door_, hand));
      hands_.push_back(std::move(made));
    }
    return {};
  }
  std::size_t hands() const { return hands_.size(); }

  Result<DoorPlan> open() {
    return at_stands(opening_stands(),
                     door_.length_m,
                     {question_.position_rad, door_.open_rad},
                     [&](DoorPlan& plan) { return opened_from(plan); });
  }
  Result<DoorPull> pull() {
    MARKETGEN_TRY(DoorPlan plan,
                  at_stands(pulling_stands,
                            door_.length_m,
                            {question_.position_rad, door_.open_rad},
                            [&](DoorPlan& made) { return pulled_from(made); }));
    return DoorPull{plan.world_from_base, std::move(plan.state), std::move(plan.pulls.front())};
  }
  Result<DoorPlan> shut() {
    return at_stands(shutting_stands, 0, {0, question_.position_rad}, [&](DoorPlan& plan) {
      return shut_from(plan);
    });
  }

 private:
  // Positions of the door between which it will be.
  struct Sweep {
    double from_rad, to_rad;
  };

  template <class Stands, class Try>
  Result<DoorPlan> at_stands(const Stands& stands, double along_m, Sweep sweep, Try attempt) {
    if (question_.world_from_base) return at_base(*question_.world_from_base, sweep, attempt);
    Error error{"collect.no_place", question_.where, "the robot can stand nowhere before the door"};
    for (const Stand& stand : stands) {
      interrupt_point();
      auto made = at_base(base_at(stand, along_m), sweep, attempt);
      if (made.ok()) return made;
      error.message = fmt::format("{:.2f} m from its hinge and {:.2f} m before it: {}",
                                  along_m + stand.along_m,
                                  stand.out_m,
                                  made.error().message);
    }
    return error;
  }

  Pose base_at(const Stand& stand, double along_m) const {
    return {
        door_.point_at(0, along_m + stand.along_m, stand.out_m, 0),
        rotation_about({0, 0, 1},
                       std::atan2(-door_.out.y, -door_.out.x) + door_.turn() * stand.turned_rad)};
  }

  template <class Try>
  Result<DoorPlan> at_base(const Pose& base, Sweep sweep, Try attempt) {
    DoorPlan plan;
    plan.world_from_base = base;
    plan.state = question_.driving;
    if (question_.may_stand) MARKETGEN_CHECK(question_.may_stand(base, plan.state));
    MARKETGEN_CHECK(check_sweep(plan, sweep));
    return attempt(plan);
  }

  // Whether the leaf passes the robot as it stands, between two positions.
  Result<void> check_sweep(const DoorPlan& plan, Sweep sweep) const {
    const double way = sweep.to_rad - sweep.from_rad;
    const int steps = static_cast<int>(std::ceil(std::abs(way) / sweep_step_rad));
    for (int i = 0; i <= steps; ++i) {
      const double position = sweep.from_rad + way * i / std::max(steps, 1);
      if (!is_clear_of_leaf(robot_, plan.state, plan.world_from_base, door_, position))
        return Error{"motion.line_blocked", question_.where, "the door would meet the robot"};
    }
    return {};
  }

  DoorStand stand_of(const DoorPlan& plan) const {
    DoorStand stand{plan.world_from_base, plan.state, question_.around};
    for (const motion::BoxObstacle& box : carried_at(question_.carried, plan.world_from_base))
      stand.around.boxes.push_back(box);
    return stand;
  }

  Seed next_seed(std::string_view of) { return seed_.child(of, tries_++); }

  // ---- Opening ----

  Result<DoorPlan> opened_from(DoorPlan& plan) {
    Error error{"robot.unreachable", question_.where, "no arm reaches the bar"};
    for (const double over : pulling_over_lift_m) {
      const double z = raised_to_bar(plan, over);
      for (std::size_t puller = 0; puller < hands_.size(); ++puller) {
        if (!is_by_the_hinge(hands_[puller].hand())) continue;
        for (const Lag& lag : lags) {
          const auto made = opened_by(plan, puller, lag, z);
          if (made.ok()) return plan;
          error = made.error();
        }
      }
    }
    return error;
  }

  // Returns the height at which the bar is taken.
  double raised_to_bar(DoorPlan& plan, double over_lift_m) const {
    const double z = (door_.bar.low_m + door_.bar.high_m) / 2;
    plan.state = raised_state(robot_, question_.driving, z - over_lift_m, grip_opening_m);
    plan.grip_opening_m = grip_opening_m;
    return z;
  }

  // By the hand and the lag of most worth.
  Result<DoorPlan> pulled_from(DoorPlan& plan) {
    Error error{"robot.unreachable", question_.where, "no arm reaches the bar"};
    const double z = raised_to_bar(plan, pulling_over_lift_m.front());
    for (std::size_t puller = 0; puller < hands_.size(); ++puller) {
      if (!is_by_the_hinge(hands_[puller].hand())) continue;
      for (const Lag& lag : lags) {
        auto made = pulled(plan, puller, lag, z);
        if (!made.ok())
          error = made.error();
        else if (plan.pulls.empty() || made->worth > plan.pulls.front().worth)
          plan.pulls = {std::move(*made)};
      }
    }
    if (plan.pulls.empty()) return error;
    return std::move(plan);
  }

  // An arm that comes with the leaf round its hinge; the other has room on the other side.
  bool is_by_the_hinge(const Hand& hand) const {
    const std::vector<Pose> links = robots::link_poses(robot_, question_.driving);
    return links[static_cast<std::size_t>(hand.arm->base)].position.y * door_.turn() < 0;
  }

  // Adds both hands' ways to the plan.
  Result<void> opened_by(DoorPlan& plan, std::size_t puller, const Lag& lag, double z) {
    MARKETGEN_TRY(HandOnDoor pull, pulled(plan, puller, lag, z));
    MARKETGEN_TRY(plan.push, pushed_on(plan, pull, puller, z));
    MARKETGEN_TRY(pull.leave, let_go(plan, pull, plan.push, puller));
    plan.pulls = {std::move(pull)};
    return {};
  }

  Result<HandOnDoor> pulled(const DoorPlan& plan, std::size_t puller, const Lag& lag, double z) {
    HandSwing swing{question_.position_rad, pulled_rad, question_.min_pulled_rad, {}};
    swing.worth = question_.worth_of_pull;
    swing.world_from_tip = [&, z](double position) {
      const double behind = lag.first_rad + (lag.last_rad - lag.first_rad) * position / pulled_rad;
      const Pose tip = level_tip(door_,
                                 door_.point_at(position, door_.bar.along_m, door_.bar.out_m, z),
                                 position - behind,
                                 false);
      return tip * Pose{{0, 0, tip_behind_bar_m}, {}};
    };
    return hands_[puller].plan(stand_of(plan), swing, next_seed("pull"));
  }

  // By another hand than the one that holds the bar, from behind the leaf.
  Result<HandOnDoor> pushed_on(const DoorPlan& plan,
                               const HandOnDoor& pull,
                               std::size_t puller,
                               double z) {
    Error error{"robot.unreachable", question_.where, "no other arm comes behind the leaf"};
    DoorStand stand = stand_of(plan);
    stand.at_reach = with_arm(*hands_[puller].hand().arm, stand.state, pull.at_end);
    const double to = std::min(door_.hold_rad + past_hold_rad, door_.open_rad);
    for (std::size_t pusher = 0; pusher < hands_.size(); ++pusher) {
      if (pusher == puller) continue;
      for (const double from_edge : inside_from_edge_m) {
        for (const double higher : {-0.15, 0.15}) {
          auto made =
              pressed(stand,
                      pusher,
                      {door_.length_m - from_edge, door_.back_m - half_finger_m, z + higher, -1},
                      inside_aims,
                      pull.end_rad,
                      to);
          if (made.ok()) return made;
          error = made.error();
        }
      }
    }
    return error;
  }

  // The hand at the bar goes home while the other is behind the leaf.
  Result<motion::JointTrajectory> let_go(const DoorPlan& plan,
                                         const HandOnDoor& pull,
                                         const HandOnDoor& push,
                                         std::size_t puller) {
    DoorStand stand = stand_of(plan);
    for (const DoorHand& hand : hands_)
      if (hand.hand().arm->name == push.group)
        stand.state = with_arm(*hand.hand().arm, stand.state, push.at_start);
    return hands_[puller].leave(stand, pull.at_end, pull.end_rad, next_seed("let go"));
  }

  // ---- Pressing ----

  struct Press {
    double along_m, out_m, height_m;  // of the tip, when it touches; from the hinge
    double side;  // along `out`, where the hand is: before the leaf, or behind it
  };

  Result<HandOnDoor> pressed(const DoorStand& stand,
                             std::size_t pusher,
                             const Press& press,
                             std::span<const Aim> aims,
                             double from_rad,
                             double to_rad) {
    Error error{"robot.unreachable", question_.where, "no arm reaches the leaf"};
    for (const Aim& aim : aims) {
      HandSwing swing{from_rad, to_rad, std::abs(to_rad - from_rad), {}};
      swing.world_from_tip = [&, press, from_rad](double position) {
        const double gone = std::min(1.0, std::abs(position - from_rad) / touch_rad);
        return level_tip(door_,
                         door_.point_at(position,
                                        press.along_m,
                                        press.out_m + press.side * slack_m * (1 - gone),
                                        press.height_m),
                         aim.first_rad + aim.share * (position - from_rad),
                         true);
      };
      auto made = hands_[pusher].plan(stand, swing, next_seed("push"));
      if (made.ok()) return made;
      error = made.error();
    }
    return error;
  }

  Result<DoorPlan> shut_from(DoorPlan& plan) {
    Error error{"robot.unreachable", question_.where, "no arm reaches the leaf"};
    for (const double z : {door_.bar.low_m - over_bar_m, door_.bar.high_m + over_bar_m}) {
      if (z < door_.low_m + over_bar_m || z > door_.high_m - over_bar_m) continue;
      for (const double over : pushing_over_lift_m) {
        plan.state = raised_state(robot_, question_.driving, z - over, 0);
        for (std::size_t pusher = 0; pusher < hands_.size(); ++pusher) {
          for (const double from_edge : outside_from_edge_m) {
            auto made = pressed(stand_of(plan),
                                pusher,
                                {door_.length_m - from_edge, door_.face_m + half_finger_m, z, 1},
                                outside_aims,
                                question_.position_rad,
                                shut_from_there_rad);
            if (!made.ok()) {
              error = made.error();
              continue;
            }
            plan.push = std::move(*made);
            return std::move(plan);
          }
        }
      }
    }
    return error;
  }

  const robots::Robot& robot_;
  const DoorQuestion& question_;
  const HingedDoor& door_;
  Seed seed_;
  std::uint64_t tries_ = 0;
  std::vector<DoorHand> hands_;
};

}  // namespace

Result<DoorPlan> plan_open_door(const robots::Robot& robot,
                                const DoorQuestion& question,
                                Seed seed) {
  if (question.door.hold_rad <= 0)
    return Error{"collect.no_door", question.where, "it does not stay open by itself"};
  DoorPlanner planner(robot, question, seed);
  MARKETGEN_CHECK(planner.make_hands());
  if (planner.hands() < 2)
    return Error{
        "robot.unknown", robot.name, fmt::format("it takes two arms with a {}", question.tool_row)};
  return planner.open();
}

Result<DoorPull> plan_pull_door(const robots::Robot& robot,
                                const DoorQuestion& question,
                                Seed seed) {
  DoorPlanner planner(robot, question, seed);
  MARKETGEN_CHECK(planner.make_hands());
  return planner.pull();
}

Result<DoorPlan> plan_shut_door(const robots::Robot& robot,
                                const DoorQuestion& question,
                                Seed seed) {
  DoorPlanner planner(robot, question, seed);
  MARKETGEN_CHECK(planner.make_hands());
  return planner.shut();
}

}  // namespace marketgen::skills
