#include "episodes/checkout_goals.h"

#include <algorithm>

namespace marketgen {
namespace {

constexpr double under_the_top_m = 0.02;  // lower than this over the counter is beside it

}  // namespace

bool inside(const AreaRow& area, const ItemState& item) {
  const auto over = [&](Vec3 point) {
    const Vec3 at = item.pose * point;
    return area.holds(at.x, at.y) && at.z > -under_the_top_m;
  };
  if (!over(item.center_of_mass)) return false;
  const auto there = std::ranges::count_if(item.volume, over);
  return static_cast<double>(there) >= least_volume_share * static_cast<double>(item.volume.size());
}

bool in_place(const AreaRow& area, const ItemState& item) {
  return inside(area, item) && !item.touched && item.rested_s >= least_rest_s &&
         item.impact_m_s <= most_impact_m_s;
}

CheckoutOutcome judge_checkout(const AreaRow& area,
                               const std::vector<EpisodeGoal>& goals,
                               const std::vector<ItemState>& items,
                               double most_basket_tilt_deg) {
  CheckoutOutcome outcome;
  int rightly_there = 0;
  for (const EpisodeGoal& goal : goals) {
    const auto of_goal = [&](const ItemState& item) { return item.sku == goal.sku; };
    const auto placed = std::ranges::count_if(
        items, [&](const ItemState& item) { return of_goal(item) && in_place(area, item); });
    const auto there = std::ranges::count_if(
        items, [&](const ItemState& item) { return of_goal(item) && inside(area, item); });
    const int reached = std::min(static_cast<int>(placed), goal.count);
    outcome.goals.push_back({goal.sku, goal.count, reached});
    outcome.asked += goal.count;
    outcome.hits += reached;
    rightly_there += std::min(static_cast<int>(there), goal.count);
  }
  const auto in_area =
      std::ranges::count_if(items, [&](const ItemState& item) { return inside(area, item); });
  outcome.wrong = static_cast<int>(in_area) - rightly_there;
  outcome.is_void = most_basket_tilt_deg > most_tilt_deg;
  outcome.hits = outcome.is_void ? 0 : std::max(0, outcome.hits - outcome.wrong);
  return outcome;
}

}  // namespace marketgen
