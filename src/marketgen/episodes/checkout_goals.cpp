#include "episodes/checkout_goals.h"

namespace marketgen {
namespace {

constexpr double under_the_top_m = 0.02;  // lower than this over the counter is beside it

}  // namespace

HoldsPoint over_area(const AreaRow& area) {
  return [area](Vec3 at) { return area.holds(at.x, at.y) && at.z > -under_the_top_m; };
}

EpisodeOutcome judge_checkout(const AreaRow& area,
                              const std::vector<EpisodeGoal>& goals,
                              const std::vector<ItemState>& items,
                              double most_basket_tilt_deg) {
  EpisodeOutcome outcome = judge(over_area(area), goals, items);
  outcome.is_void = most_basket_tilt_deg > most_tilt_deg;
  if (outcome.is_void) outcome.hits = 0;
  return outcome;
}

}  // namespace marketgen
