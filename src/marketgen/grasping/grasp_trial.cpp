#include "grasping/grasp_trial.h"

#include <algorithm>
#include <cmath>

#include "grasping/grasp_hold.h"
#include "physics/settle/bulk_model.h"

namespace marketgen::grasping {
namespace {

// ---- The motion: seconds and metres. Speeds as the grasp probe's (0.05 to 0.1 m/s on a shelf).
// ----
constexpr double settle_s = 0.4, close_s = 1.0, seal_s = 0.1;
constexpr double free_approach_m = 0.10, free_approach_s = 1.0;
constexpr double shelf_approach_m = 0.15, shelf_approach_s = 2.0;
constexpr double free_lift_m = 0.10, free_lift_s = 1.0;
constexpr double shelf_lift_m = 0.008, shelf_lift_s = 0.4, pull_clear_m = 0.05, pull_m_s = 0.1;
constexpr double clear_of_shelf_m = 0.03, clear_of_shelf_s = 0.5, clear_of_rim_m = 0.02;
constexpr double put_down_over_m = 0.001, retreat_s = 0.6, rest_s = 0.5, open_s = 0.4;
// Twice to and fro in 0.8 s along each axis: 2 m/s^2 at the most.
constexpr double shake_m = 0.008, shake_s = 0.8, hold_s = 0.3;

// ---- What counts as what. ----
constexpr double stands_m = 0.010, stands_cosine = 0.985, rests_m_s = 0.02;
constexpr double lean_rad = 0.01745, lean_s = 0.8;     // what a pack must stand: 1 degree
constexpr double stays_m = 0.03, stays_cosine = 0.94;  // where it is put down: 20 degrees
constexpr double touch_n = 0.5, lost_m = 0.02;
constexpr double max_tool_n = 20;  // on shelf or table, mean over 10 ms
constexpr double fallen_m = 0.05, toppled_cosine = 0.70710678118654752;

double upright(const Pose& from, const Pose& to) {
  return dot(rotate(from.rotation, {0, 0, 1}), rotate(to.rotation, {0, 0, 1}));
}

class Trial {
 public:
  Trial(const GraspTrial& trial, GraspHold& hold) : trial_(trial), hold_(hold) {}

  Result<GraspOutcome> run() {
    MARKETGEN_CHECK(hold_.wait(settle_s));
    if (!stands()) return ended(GraspEnd::unstable);
    stood_ = all_poses();
    MARKETGEN_CHECK(approach());
    if (hold_.watch().still_n > max_tool_n) return ended(GraspEnd::collided);
    MARKETGEN_TRY(const bool taken, take());
    if (!taken) return ended(GraspEnd::missed);
    hold_.mark();
    const Vec3 before = hold_.held().position;
    MARKETGEN_CHECK(lift());
    for (const Vec3 axis : {Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{0, 1, 0}})
      MARKETGEN_CHECK(hold_.shake_tool(axis, shake_m, shake_s));
    MARKETGEN_CHECK(hold_.wait(hold_s));
    const Vec3 carried = hold_.held().position - before - travelled_;
    outcome_.squeeze_n = std::min(hold_.watch().pad_n[0], hold_.watch().pad_n[1]);
    const GraspEnd held = end_of_hold(length(carried));
    if (held != GraspEnd::held || trial_.setting != GraspSetting::free) return ended(held);
    MARKETGEN_TRY(const bool stays, put_down());
    return ended(stays ? GraspEnd::held : GraspEnd::fell_over);
  }

 private:
  bool loose() const { return trial_.goods.product.orientation == catalog::Orientation::any; }
  bool in_basket() const { return trial_.setting == GraspSetting::basket; }
  bool on_shelf() const { return trial_.setting != GraspSetting::free && !in_basket(); }

  std::vector<Pose> all_poses() const {
    std::vector<Pose> poses;
    for (std::size_t i = 0; i < hold_.products(); ++i)
      poses.push_back(hold_.product(i));
    return poses;
  }

  // Upright, or as it lay in the basket.
  bool stands() const {
    const Pose now = hold_.product();
    const Pose start = in_basket() ? trial_.basket->container_from_product[0] : Pose{};
    if (hold_.speed() > rests_m_s) return false;
    if (in_basket()) return length(now.position - start.position) < stands_m;
    return loose() || (length(now.position) < stands_m && upright(start, now) > stands_cosine);
  }

  // The tool comes to where it sees the product (of a soft pack, the part it is to take), with its
  // error.
  Result<void> approach() {
    Stream draw = trial_.seed.child("tool").stream();
    const auto error = [&](double most) { return draw.uniform(-most, most); };
    const Pose& aimed = trial_.grasp.product_from_tool;
    Pose seen = hold_.part(hold_.part_near(aimed * trial_.tool.pad_center));
    seen.position += Vec3{error(tool_error_m), error(tool_error_m), error(tool_error_m)};
    seen.rotation = rotation_about({0, 0, 1}, error(tool_error_rad)) * seen.rotation;
    const bool shelved = on_shelf();
    const double way = shelved ? shelf_approach_m : free_approach_m;
    Pose goal = seen * aimed;
    ahead_ = rotate(goal.rotation, {0, 0, 1});
    goal.position += ahead_ * -way;
    hold_.put_tool(goal);
    hold_.open_fingers(trial_.grasp.opening_m);
    return hold_.move_tool(ahead_ * way, shelved ? shelf_approach_s : free_approach_s);
  }

  Result<bool> take() {
    if (trial_.tool.kind == robots::ToolKind::suction) {
      const bool sealed = hold_.seal();
      MARKETGEN_CHECK(hold_.wait(seal_s));
      return sealed && hold_.sealed();
    }
    MARKETGEN_CHECK(hold_.squeeze(trial_.grasp.force_n, close_s));
    return hold_.watch().pad_n[0] > touch_n && hold_.watch().pad_n[1] > touch_n;
  }

  Result<void> move(Vec3 by, double seconds) {
    travelled_ += by;
    return hold_.move_tool(by, seconds);
  }

  Result<void> lift() {
    if (on_shelf()) return lift_off_shelf();
    if (in_basket()) return lift_out_of_basket();
    return move({0, 0, free_lift_m}, free_lift_s);
  }

  // Until the lowest corner of the pack's box is clear of the rim.
  Result<void> lift_out_of_basket() {
    const Pose now = hold_.product();
    const Vec3 middle = now * Vec3{0, 0, trial_.goods.product.height_m() / 2};
    const double lowest =
        middle.z - physics::turned_half_extents(trial_.goods.product, now.rotation).z;
    const double by =
        std::max(free_lift_m, trial_.basket->container.height_m + clear_of_rim_m - lowest);
    return move({0, 0, by}, by / pull_m_s);
  }

  Result<void> lift_off_shelf() {
    MARKETGEN_CHECK(move({0, 0, shelf_lift_m}, shelf_lift_s));
    const double pull = trial_.goods.product.depth_m() + pull_clear_m;
    MARKETGEN_CHECK(move({0, -pull, 0}, pull / pull_m_s));
    return move({0, 0, clear_of_shelf_m}, clear_of_shelf_s);
  }

  GraspEnd end_of_hold(double strayed_m) const {
    const GraspWatch& watch = hold_.watch();
    const bool gripper = trial_.tool.kind == robots::ToolKind::gripper;
    const bool touched =
        gripper ? watch.pad_n[0] > touch_n && watch.pad_n[1] > touch_n : hold_.sealed();
    if (!touched || strayed_m > lost_m) return GraspEnd::dropped;
    if (watch.slip_m > max_slip_m) return GraspEnd::slipped;
    if (watch.still_n > max_tool_n) return GraspEnd::collided;
    if (!in_basket() && neighbour_toppled()) return GraspEnd::toppled;
    return watch.neighbour_n > max_neighbour_n ? GraspEnd::pressed : GraspEnd::held;
  }

  // On a shelf. In a basket what lies round about may be moved, as long as it is not pressed hard.
  bool neighbour_toppled() const {
    for (std::size_t i = 1; i < hold_.products(); ++i) {
      const Pose now = hold_.product(i);
      const bool fell = stood_[i].position.z - now.position.z > fallen_m;
      if (fell || (!loose() && upright(stood_[i], now) < toppled_cosine)) return true;
    }
    return false;
  }

  // Where it was taken up; true when it stays there once the tool has gone.
  Result<bool> put_down() {
    MARKETGEN_CHECK(move({0, 0, put_down_over_m - free_lift_m}, free_lift_s));
    MARKETGEN_CHECK(hold_.release(open_s));
    MARKETGEN_CHECK(hold_.move_tool(ahead_ * -free_approach_m, retreat_s));
    MARKETGEN_CHECK(hold_.wait(rest_s));
    const Pose now = hold_.product();
    if (loose()) return now.position.z < stood_[0].position.z + stays_m;
    return length(now.position - stood_[0].position) < stays_m &&
           std::min(upright(stood_[0], now), upright(stood_[0], hold_.part(1))) > stays_cosine;
  }

  GraspOutcome ended(GraspEnd end) {
    outcome_.end = end;
    outcome_.slip_m = hold_.watch().slip_m;
    outcome_.turned_rad = hold_.watch().turned_rad;
    outcome_.neighbour_n = hold_.watch().neighbour_n;
    return outcome_;
  }

  const GraspTrial& trial_;
  GraspHold& hold_;
  std::vector<Pose> stood_;
  Vec3 ahead_{}, travelled_{};
  GraspOutcome outcome_;
};

}  // namespace

Result<bool> stands_alone(const physics::GoodsBody& goods,
                          const robots::GraspTool& tool,
                          const physics::SoftPack* soft) {
  if (goods.product.orientation == catalog::Orientation::any) return true;
  GraspTrial alone{goods, tool, robots::Grasp{}};
  alone.soft = soft;
  MARKETGEN_TRY(GraspHold hold, GraspHold::start(alone));
  for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, -1, 0}}) {
    hold.lean_product(axis, lean_rad);
    MARKETGEN_CHECK(hold.wait(lean_s));
    if (upright({}, hold.product()) < stands_cosine) return false;
  }
  return true;
}

Result<GraspOutcome> try_grasp(const GraspTrial& trial) {
  MARKETGEN_TRY(GraspHold hold, GraspHold::start(trial));
  return Trial(trial, hold).run();
}

}  // namespace marketgen::grasping
