#include "policy/highest_first.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/rotation_axes.h"
#include "perception/mask_source.h"
#include "policy/checkout_sight.h"
#include "skills/basket_moves.h"
#include "skills/hand_reach.h"

namespace marketgen::policy {
namespace {

constexpr double min_height_m = 0.015;                  // over the basket's floor
constexpr double patch_m = 0.04, patch_depth_m = 0.02;  // about the highest point, and below it
constexpr double left_alone_m = 0.03;
constexpr double finger_depth_m = 0.03;  // of the pads below the highest point
constexpr double floor_gap_m = 0.01;     // of the pads over the basket's floor
constexpr std::array opening_shares{1.0, 0.7, 0.45};
constexpr double max_overlap_m = 0.006;
constexpr double grip_n = 40, shut_m = 0.004;
constexpr double let_go_s = 0.35;
constexpr double place_step_m = 0.1;    // between the places on the area
constexpr double let_go_over_m = 0.02;  // the counter, of what hangs below the pads
constexpr double min_time_left_s = 8;   // no new grasp with less time left
constexpr int max_failed = 6;           // grasps

const std::string camera = "scene_camera";

bool is_near(Vec3f point, Vec3 place, double within_m) {
  return std::hypot(static_cast<double>(point.x) - place.x,
                    static_cast<double>(point.y) - place.y) < within_m;
}

// Half a circle in quarters, from the narrow direction of the points on: fingers close along it.
std::vector<Quaternion> hands_down(const std::vector<Vec3f>& patch, Vec3 middle) {
  double xx = 0, xy = 0, yy = 0;
  for (const Vec3f& p : patch) {
    const Vec3 d = to_double(p) - middle;
    xx += d.x * d.x;
    xy += d.x * d.y;
    yy += d.y * d.y;
  }
  const double narrow = std::atan2(2 * xy, xx - yy) / 2 + std::numbers::pi / 2;
  std::vector<Quaternion> turns;
  for (const double turn : {0.0, 0.5, 0.25, 0.75}) {
    const double angle = narrow + turn * std::numbers::pi;
    turns.push_back(rotation_with_axes({std::cos(angle), std::sin(angle), 0}, {0, 0, -1}));
  }
  return turns;
}

Vec3 middle_of(const std::vector<Vec3f>& points) {
  Vec3 sum;
  for (const Vec3f& p : points)
    sum += to_double(p);
  return sum / static_cast<double>(points.size());
}

class HighestFirst : public agent::Policy {
 public:
  HighestFirst(HighestFirstSetup setup, skills::ArmExecutor arm, Seed seed)
      : setup_(std::move(setup)), arm_(std::move(arm)), seed_(seed), walls_(setup_.place) {}

  Result<void> begin(const agent::Task& task, const agent::Observation& first) override {
    limit_s_ = task.limit_s;
    for (const agent::TaskGoal& goal : task.goals)
      wanted_ += goal.count;
    arm_.start(first);
    return {};
  }

  Result<agent::Action> act(const agent::Observation& now) override {
    now_ = now;
    if (arm_.idle() && !done_) MARKETGEN_CHECK(decide());
    agent::Action action = arm_.next(now);
    action.stop = done_;
    return action;
  }

  std::string failure() const override { return failure_; }
  agent::Subtask subtask() const override { return arm_.subtask(); }

 private:
  Result<void> decide() {
    const bool has_grasped = std::exchange(grasped_, false);
    if (arm_.take_stop()) {
      pass_over("Collision");
      return {};
    }
    if (has_grasped) {
      put_down();
      return {};
    }
    if (brought_ >= wanted_ || failed_ >= max_failed || now_.time_s + min_time_left_s > limit_s_) {
      done_ = true;
      return {};
    }
    return take_highest();
  }

  Result<void> take_highest() {
    MARKETGEN_TRY(agent::View view, setup_.eyes->look(camera));
    const perception::ViewCloud cloud(std::move(view));
    const std::vector<std::uint8_t> goods =
        perception::goods_in_basket(cloud, setup_.place, setup_.place.base_from_basket);
    std::vector<Vec3f> points;
    for (std::size_t pixel = 0; pixel < cloud.size(); ++pixel)
      if (goods[pixel] != 0) points.push_back(cloud.point(pixel));
    points = without_robot(points, *setup_.robot, now_);
    const std::vector<Vec3f> patch = highest_patch(points, setup_.place, left_alone_);
    if (patch.empty()) {
      failure_ = "NotFound";
      done_ = true;
      return {};
    }
    tried_ = middle_of(patch);
    const Walls walls = walls_.at(setup_.place.base_from_basket);
    for (const OpenHand& hand : hands_over(patch, points, walls))
      if (grasp(hand, walls)) return {};
    pass_over("NoGrasp");
    return {};
  }

  using Walls = std::vector<skills::PlacedBody>;
  struct OpenHand {
    Pose base_from_tip;
    double opening_m = 0;
    double overlap_m = 0;  // with what is seen, at most
  };

  // Round the patch from above, with most room first.
  std::vector<OpenHand> hands_over(const std::vector<Vec3f>& patch,
                                   const std::vector<Vec3f>& points,
                                   const Walls& walls) const {
    const double floor = setup_.place.base_from_basket.position.z + floor_gap_m;
    const Vec3 at{tried_.x, tried_.y, std::max(tried_.z - finger_depth_m, floor)};
    std::vector<OpenHand> hands;
    for (const Quaternion& turn : hands_down(patch, tried_)) {
      for (const double share : opening_shares) {
        OpenHand open{{at, turn}, share * setup_.tool.opening_m};
        const auto hand = skills::open_hand(setup_.tool, open.opening_m);
        open.overlap_m = skills::hand_overlap(hand, open.base_from_tip, points);
        if (open.overlap_m < max_overlap_m && !skills::is_near(hand, open.base_from_tip, walls, 0))
          hands.push_back(open);
      }
    }
    std::ranges::stable_sort(hands, {}, &OpenHand::overlap_m);
    return hands;
  }

  bool grasp(const OpenHand& open, const Walls& walls) {
    arm_.set_subtask(agent::Subtask::reach);
    const std::vector<robots::ToolSolid> hand = skills::open_hand(setup_.tool, open.opening_m);
    const skills::Surroundings around =
        skills::counter_surroundings(setup_.place, skills::HandAt::basket);
    for (const Pose& tip : skills::either_way_round(arm_, open.base_from_tip)) {
      const skills::ReachRequest request = skills::reach_over_rim(tip, rim_z_m(), open.opening_m);
      if (!skills::is_reached(arm_, request, hand, walls) ||
          !arm_.reach(around, request, next_seed()).ok())
        continue;
      skills::close_hand(arm_, grip_n);
      const Vec3 middle = setup_.place.base_from_basket.position;
      // It may reach down to the basket's floor.
      grasped_ = skills::lift_out(arm_, basket_around(), middle.z, middle, grip_n).ok();
      return grasped_;
    }
    return false;
  }

  // Opens where the hand is, and leaves what it tried alone from now on.
  void pass_over(const std::string& why) {
    failure_ = why;
    ++failed_;
    left_alone_.push_back(tried_);
    arm_.set_subtask(agent::Subtask::retreat);
    arm_.wait(let_go_s, setup_.tool.opening_m, grip_n);
  }

  // At the next of the places that the area has, as far over the counter as the hand was over the
  // basket's floor.
  void put_down() {
    if (now_.openings_m.front() < shut_m) return pass_over("Missed");
    arm_.set_subtask(agent::Subtask::place);
    const agent::WorkArea& area = setup_.place.unloading;
    const int across =
        std::max(1, static_cast<int>((area.high_m[0] - area.low_m[0]) / place_step_m));
    Pose tip = arm_.tip();
    tip.position = {area.low_m[0] + (brought_ % across + 0.5) * place_step_m,
                    area.low_m[1] + (brought_ / across + 0.5) * place_step_m,
                    std::max(tried_.z - finger_depth_m, floor_gap_m) + let_go_over_m};
    const skills::Surroundings around =
        skills::counter_surroundings(setup_.place, skills::HandAt::counter);
    Pose over = tip;
    over.position.z = arm_.tip().position.z;
    const bool comes =
        arm_.straight(around, over, 0, grip_n).ok() && arm_.straight(around, tip, 0, grip_n).ok();
    if (!comes) return pass_over("NoPath");
    arm_.wait(let_go_s, setup_.tool.opening_m, grip_n);
    if (!skills::draw_back(arm_, basket_around(), setup_.tool.opening_m, grip_n).ok())
      failure_ = "NoPath";
    ++brought_;
  }

  double rim_z_m() const { return setup_.place.base_from_basket.position.z + setup_.place.rim_m; }
  skills::BasketSurroundings basket_around() const {
    return {skills::counter_surroundings(setup_.place, skills::HandAt::basket),
            skills::counter_alone(setup_.place),
            rim_z_m()};
  }
  Seed next_seed() { return seed_.child("reach", moves_++); }

  HighestFirstSetup setup_;
  skills::ArmExecutor arm_;
  Seed seed_;
  skills::BasketWalls walls_;
  agent::Observation now_;
  double limit_s_ = 0;
  int wanted_ = 0, brought_ = 0, failed_ = 0;
  Vec3 tried_;                    // middle of what the hand went for last
  std::vector<Vec3> left_alone_;  // where it failed
  bool grasped_ = false;
  std::uint64_t moves_ = 0;
  bool done_ = false;
  std::string failure_ = "Unknown";  // it does not know what it lifts
};

}  // namespace

std::vector<Vec3f> highest_patch(const std::vector<Vec3f>& points,
                                 const agent::Workplace& place,
                                 const std::vector<Vec3>& left_alone) {
  const double floor = place.base_from_basket.position.z;
  const Vec3f* top = nullptr;
  for (const Vec3f& p : points) {
    const bool passed = std::ranges::any_of(
        left_alone, [&](const Vec3& at) { return is_near(p, at, left_alone_m); });
    if (!passed && static_cast<double>(p.z) > floor + min_height_m &&
        (top == nullptr || p.z > top->z))
      top = &p;
  }
  std::vector<Vec3f> patch;
  if (top == nullptr) return patch;
  for (const Vec3f& p : points)
    if (is_near(p, to_double(*top), patch_m) && static_cast<double>(top->z - p.z) < patch_depth_m)
      patch.push_back(p);
  return patch;
}

Result<std::unique_ptr<agent::Policy>> make_highest_first(HighestFirstSetup setup, Seed seed) {
  MARKETGEN_TRY(skills::ArmExecutor arm, skills::ArmExecutor::make(*setup.robot));
  return std::unique_ptr<agent::Policy>(
      std::make_unique<HighestFirst>(std::move(setup), std::move(arm), seed));
}

}  // namespace marketgen::policy
