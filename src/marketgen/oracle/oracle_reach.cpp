#include "oracle/oracle_reach.h"

#include <algorithm>
#include <numbers>

namespace marketgen {
namespace {

constexpr double walls_clear_m = 0.002, look_every_m = 0.03;  // of the open tool on its way in
constexpr double looked_at_m = 0.1;  // of the way, when the grasp was found
constexpr double least_approach_m = 0.08, reach_over_rim_m = 0.04;

}  // namespace

std::vector<Pose> either_way_round(const ArmExecutor& arm, const Pose& station_from_tip) {
  Pose other = station_from_tip;
  other.rotation = other.rotation * rotation_about({0, 0, 1}, std::numbers::pi);
  const double a = arm.effort_to(station_from_tip).value_or(1e9),
               b = arm.effort_to(other).value_or(1e9);
  if (b < a) return {other, station_from_tip};
  return {station_from_tip, other};
}

ReachRequest reach_request(const OracleScene& scene,
                           const Pose& station_from_tip,
                           double opening_m) {
  const double rim = scene.world().station().basket.height_m + reach_over_rim_m;
  const double steep = std::max(0.4, -rotate(station_from_tip.rotation, {0, 0, 1}).z);
  const double way = std::max(least_approach_m, (rim - station_from_tip.position.z) / steep);
  return {station_from_tip, {0, 0, way}, opening_m};
}

bool is_reached(const OracleScene& scene, const ArmExecutor& arm, const ReachRequest& request) {
  const Pose& tip = request.base_from_tip;
  if (!arm.effort_to(tip) || !arm.effort_to(tip * Pose{-request.approach, {}})) return false;
  for (double back = looked_at_m; back < request.approach.z; back += look_every_m) {
    const Pose there = tip * Pose{{0, 0, -back}, {}};
    if (scene.tool_meets_basket(there, request.opening_m, walls_clear_m)) return false;
  }
  return true;
}

bool has_place(const OracleScene& scene,
               const ArmExecutor& arm,
               std::size_t item,
               const Pose& station_from_tip,
               double opening_m) {
  const PlaceQuestion question =
      place_question(scene,
                     item,
                     inverse(station_from_tip) * scene.world().item_pose(item),
                     opening_m,
                     scene.is_target(item));
  return !item_places(scene, arm, question, 1).empty();
}

}  // namespace marketgen
