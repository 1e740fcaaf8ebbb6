#include "environments/goal_progress.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "episodes/goal_judge.h"

namespace marketgen::environments {
namespace {

constexpr double reach_share = 0.2, hold_share = 0.1, carry_share = 0.4;
constexpr double there = 0.75, let_go = 0.15, rested = 0.1;

double near(double distance_m, double scale_m) {
  return 1 - std::tanh(distance_m / scale_m);
}

double tool_distance(const EnvironmentItem& item, const std::vector<Pose>& tools) {
  double least = std::numeric_limits<double>::infinity();
  for (const Pose& tool : tools)
    least = std::min(least, length(item.middle - tool.position));
  return least;
}

// Along the floor: what is to be lifted over a rim first goes up.
double way_to(const EnvironmentPlace& place, const EnvironmentItem& item) {
  const Vec3 off = item.middle - place.middle;
  return std::hypot(std::max(0.0, std::abs(off.x) - place.size_m.x / 2),
                    std::max(0.0, std::abs(off.y) - place.size_m.y / 2));
}

double of_item(const EnvironmentItem& item,
               const EnvironmentPlace& place,
               const ProgressScale& scale) {
  if (item.in_place) return 1;
  if (item.in_region)
    return there + (item.touched
                        ? 0
                        : let_go + rested * std::min(item.rested_s / episodes::min_rest_s, 1.0));
  return (item.held ? hold_share : 0) + carry_share * near(way_to(place, item), scale.carry_m);
}

}  // namespace

double goal_progress(const std::vector<episodes::EpisodeGoal>& goals,
                     const std::vector<EnvironmentItem>& items,
                     const EnvironmentPlace& place,
                     const std::vector<Pose>& tools,
                     const ProgressScale& scale) {
  double sum = 0, reached = 0;
  int asked = 0, outside = 0;
  for (const episodes::EpisodeGoal& goal : goals) {
    std::vector<std::pair<double, const EnvironmentItem*>> found;
    for (const EnvironmentItem& item : items)
      if (item.sku == goal.sku) found.emplace_back(of_item(item, place, scale), &item);
    std::ranges::stable_sort(
        found, std::greater<>(), [](const auto& entry) { return entry.first; });
    found.resize(std::min(found.size(), static_cast<std::size_t>(goal.count)));
    asked += goal.count;
    for (const auto& [value, item] : found) {
      sum += value;
      if (item->in_region || item->in_place) continue;
      ++outside;
      reached = std::max(reached, near(tool_distance(*item, tools), scale.reach_m));
    }
  }
  return asked > 0 ? (sum + outside * reach_share * reached) / asked : 0;
}

}  // namespace marketgen::environments
