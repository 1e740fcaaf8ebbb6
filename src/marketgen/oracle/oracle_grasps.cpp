#include "oracle/oracle_grasps.h"

#include <algorithm>
#include <array>

namespace marketgen::oracle {
namespace {

// So far neighbours give way. Fingers come from above: what they meet they press down.
constexpr double max_hand_overlap_m = 0.003;
constexpr double max_lift_overlap_m = 0.005;
constexpr std::array lifts_m{0.015, 0.035, 0.06, 0.09, 0.13, 0.19};

GraspChoice choice_of(const OracleScene& scene,
                      std::size_t item,
                      const motion::GraspCandidate& candidate) {
  GraspChoice choice{skills::lifting_grasp(scene.lying(item), candidate), {}};
  const std::vector<robots::ToolSolid> hand = skills::open_hand(scene.tool(), choice.opening_m);
  for (std::size_t other = 0; other < scene.items(); ++other) {
    if (other == item) continue;
    const double over = skills::hand_overlap(hand, choice.base_from_tip, scene.body(other));
    choice.score -= skills::overlap_cost(over);
    if (over > max_hand_overlap_m) choice.blockers.push_back(other);
  }
  return choice;
}

}  // namespace

Result<std::vector<motion::GraspCandidate>> lone_grasps(const OracleScene& scene,
                                                        std::size_t item) {
  skills::LyingPack pack = scene.lying(item);
  // The floor of the basket and the counter are its ground.
  const agent::Workplace place = scene.place();
  if (scene.in_basket(item)) pack.ground_m = place.base_from_basket.position.z;
  return skills::grasps_from_above(pack, scene.tool(), skills::wall_obstacles(place));
}

ItemGrasps item_grasps(const OracleScene& scene,
                       std::size_t item,
                       const std::vector<motion::GraspCandidate>& lone) {
  ItemGrasps grasps;
  for (const motion::GraspCandidate& candidate : lone)
    grasps.choices.push_back(choice_of(scene, item, candidate));
  std::ranges::stable_sort(grasps.choices, [](const GraspChoice& a, const GraspChoice& b) {
    if (a.blockers.size() != b.blockers.size()) return a.blockers.size() < b.blockers.size();
    return a.score > b.score;
  });
  for (std::size_t other = 0; other < scene.items(); ++other) {
    const bool over = other != item && std::ranges::any_of(lifts_m, [&](double by) {
                        return scene.item_overlap(item, {0, 0, by}, other) > max_lift_overlap_m;
                      });
    if (over) grasps.lies_under.push_back(other);
  }
  return grasps;
}

}  // namespace marketgen::oracle
