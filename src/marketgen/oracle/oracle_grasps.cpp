#include "oracle/oracle_grasps.h"

#include <algorithm>
#include <array>

namespace marketgen {
namespace {

constexpr std::size_t most_candidates = 64;
// So far neighbours give way. Fingers come from above: what they meet they press down.
constexpr double most_tool_overlap_m = 0.003;
constexpr double most_lift_overlap_m = 0.005;
constexpr std::array lifts_m{0.015, 0.035, 0.06, 0.09, 0.13, 0.19};
// How far open pads stand off the item on either side; the second where the first finds nothing.
constexpr std::array open_on_each_side_m{0.005, 0.0025};
// Grips harder than must be, as far as the gripper can: goods are knocked while they are carried.
constexpr double firmness = 2, least_grip_n = 30, most_grip_n = 60;

// ---- Weights of the score: room, straight down, near the middle of mass; measured in the probe.
constexpr double most_room_m = 0.015;
constexpr double of_room = 1000, of_tilt_deg = 0.2, of_offset = 250, of_overlap = 3000;
// Of how firm the grasp is, 0..1 (GraspCandidate::score): faces that lean press the item out.
constexpr double of_firmness = 30;

GraspChoice choice_of(const OracleScene& scene, std::size_t item, const GraspCandidate& candidate) {
  GraspChoice choice;
  choice.strategy = candidate.strategy;
  choice.station_from_tip = scene.world().item_pose(item) * candidate.grasp.product_from_tool;
  choice.opening_m = candidate.grasp.opening_m;
  choice.width_m = candidate.width_m;
  choice.force_n = std::clamp(candidate.grasp.force_n * firmness, least_grip_n, most_grip_n);
  choice.score = of_firmness * candidate.score;
  const double offset = length(choice.station_from_tip.position - scene.middle(item));
  choice.score += of_room * std::min(candidate.clearance_m, most_room_m) -
                  of_tilt_deg * tilt_deg(choice.station_from_tip.rotation) - of_offset * offset;
  for (std::size_t other = 0; other < scene.items(); ++other) {
    if (other == item) continue;
    const double over = scene.tool_overlap(other, choice.station_from_tip, choice.opening_m);
    choice.score -= of_overlap * std::min(over, most_room_m);
    if (over > most_tool_overlap_m) choice.blockers.push_back(other);
  }
  return choice;
}

}  // namespace

Result<std::vector<GraspCandidate>> lone_grasps(const OracleScene& scene, std::size_t item) {
  const CheckoutGoods& goods = scene.world().goods(item);
  GraspQuery query;
  query.friction = goods.pad_friction;
  query.most = most_candidates;
  query.from_above = true;
  query.world_from_product = scene.world().item_pose(item);
  // The floor of the basket and the counter are its ground.
  const double floor = scene.in_basket(item) ? scene.world().basket_pose().position.z : 0.0;
  query.world_from_product.position.z -= floor;
  query.walls = scene.walls();
  for (GraspObstacle& wall : query.walls)
    wall.world_from_box.position.z -= floor;
  for (const double gap : open_on_each_side_m) {
    query.finger_gap_m = gap;
    MARKETGEN_TRY(GraspCandidates found,
                  grasp_candidates(goods.product, goods.body, scene.tool(), query));
    if (!found.found.empty()) return std::move(found.found);
  }
  return std::vector<GraspCandidate>{};
}

ItemGrasps item_grasps(const OracleScene& scene,
                       std::size_t item,
                       const std::vector<GraspCandidate>& lone) {
  ItemGrasps grasps;
  for (const GraspCandidate& candidate : lone)
    grasps.choices.push_back(choice_of(scene, item, candidate));
  std::ranges::stable_sort(grasps.choices, [](const GraspChoice& a, const GraspChoice& b) {
    if (a.blockers.size() != b.blockers.size()) return a.blockers.size() < b.blockers.size();
    return a.score > b.score;
  });
  for (std::size_t other = 0; other < scene.items(); ++other) {
    const bool over = other != item && std::ranges::any_of(lifts_m, [&](double by) {
                        return scene.item_overlap(item, {0, 0, by}, other) > most_lift_overlap_m;
                      });
    if (over) grasps.lies_under.push_back(other);
  }
  return grasps;
}

}  // namespace marketgen
