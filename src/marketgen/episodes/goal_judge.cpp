#include "episodes/goal_judge.h"

#include <algorithm>
#include <functional>

namespace marketgen::episodes {
namespace {

// Of so many that are counted, the one that came to rest last.
double shortest_rest_s(std::vector<double> rested_s, std::size_t counted) {
  if (counted == 0) return 0;
  std::ranges::sort(rested_s, std::greater<>());
  return rested_s[counted - 1];
}

}  // namespace

bool is_inside(const HoldsPoint& region, const ItemState& item) {
  const auto in_region = [&](Vec3 point) { return region(item.pose * point); };
  if (!in_region(item.center_of_mass)) return false;
  const auto there = std::ranges::count_if(item.volume, in_region);
  return static_cast<double>(there) >= min_volume_share * static_cast<double>(item.volume.size());
}

bool is_in_place(const HoldsPoint& region, const ItemState& item) {
  return is_inside(region, item) && !item.touched && item.rested_s >= min_rest_s &&
         item.impact_m_s <= max_impact_m_s;
}

EpisodeOutcome judge(const HoldsPoint& region,
                     const std::vector<EpisodeGoal>& goals,
                     const std::vector<ItemState>& items) {
  EpisodeOutcome outcome;
  int rightly_there = 0;
  for (const EpisodeGoal& goal : goals) {
    const auto of_goal = [&](const ItemState& item) { return item.sku == goal.sku; };
    std::vector<double> placed;
    for (const ItemState& item : items)
      if (of_goal(item) && is_in_place(region, item)) placed.push_back(item.rested_s);
    const auto there = std::ranges::count_if(
        items, [&](const ItemState& item) { return of_goal(item) && is_inside(region, item); });
    const int reached = std::min(static_cast<int>(placed.size()), goal.count);
    const double rested_s = shortest_rest_s(placed, static_cast<std::size_t>(reached));
    outcome.goals.push_back({goal.sku, goal.count, reached, rested_s});
    outcome.asked += goal.count;
    outcome.hits += reached;
    rightly_there += std::min(static_cast<int>(there), goal.count);
  }
  const auto in_region =
      std::ranges::count_if(items, [&](const ItemState& item) { return is_inside(region, item); });
  outcome.wrong = static_cast<int>(in_region) - rightly_there;
  outcome.hits = std::max(0, outcome.hits - outcome.wrong);
  return outcome;
}

}  // namespace marketgen::episodes
