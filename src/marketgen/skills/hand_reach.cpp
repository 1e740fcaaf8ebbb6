#include "skills/hand_reach.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

namespace marketgen::skills {
namespace {

constexpr double walls_clear_m = 0.002, look_every_m = 0.03;  // of the open hand on its way in
constexpr double looked_at_m = 0.1;  // of the way, when the grasp was found
constexpr double min_approach_m = 0.08, reach_over_rim_m = 0.04;
constexpr int cup_turns = 8;
constexpr std::size_t max_cup_turns = 3;
// Where a hand leans, its way is longer than the height is; one that leans more begins lower.
constexpr double min_steepness = 0.4;

}  // namespace

std::vector<Pose> either_way_round(const ArmExecutor& arm, const Pose& base_from_tip) {
  Pose other = base_from_tip;
  other.rotation = other.rotation * rotation_about({0, 0, 1}, std::numbers::pi);
  constexpr double never = std::numeric_limits<double>::infinity();
  if (arm.effort_to(other).value_or(never) < arm.effort_to(base_from_tip).value_or(never))
    return {other, base_from_tip};
  return {base_from_tip, other};
}

std::vector<Pose> alike_ways(const ArmExecutor& arm,
                             const Pose& base_from_tip,
                             robots::ToolKind kind) {
  if (kind == robots::ToolKind::gripper) return either_way_round(arm, base_from_tip);
  std::vector<std::pair<double, Pose>> ways;
  for (int i = 0; i < cup_turns; ++i) {
    Pose turned = base_from_tip;
    turned.rotation =
        turned.rotation * rotation_about({0, 0, 1}, 2 * std::numbers::pi * i / cup_turns);
    if (const auto effort = arm.effort_to(turned)) ways.emplace_back(*effort, turned);
  }
  std::ranges::stable_sort(ways, {}, [](const auto& way) { return way.first; });
  std::vector<Pose> best;
  for (std::size_t i = 0; i < std::min(ways.size(), max_cup_turns); ++i)
    best.push_back(ways[i].second);
  return best;
}

ReachRequest reach_over_rim(const Pose& base_from_tip, double rim_z_m, double opening_m) {
  const double steep = std::max(min_steepness, -rotate(base_from_tip.rotation, {0, 0, 1}).z);
  const double way =
      std::max(min_approach_m, (rim_z_m + reach_over_rim_m - base_from_tip.position.z) / steep);
  return {base_from_tip, {0, 0, way}, opening_m};
}

bool is_reached(const ArmExecutor& arm,
                const ReachRequest& request,
                const std::vector<robots::ToolSolid>& hand,
                std::span<const PlacedBody> walls) {
  const Pose& tip = request.base_from_tip;
  if (!arm.effort_to(tip) || !arm.effort_to(tip * Pose{-request.approach, {}})) return false;
  for (double back = looked_at_m; back < request.approach.z; back += look_every_m)
    if (is_near(hand, tip * Pose{{0, 0, -back}, {}}, walls, walls_clear_m)) return false;
  return true;
}

}  // namespace marketgen::skills
