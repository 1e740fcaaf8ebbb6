#include "environments/goal_nearness.h"

#include <algorithm>

namespace marketgen::environments {

double goal_nearness(
    const std::vector<episodes::EpisodeGoal>& goals,
    double scale_m,
    const std::function<std::vector<double>(const episodes::EpisodeGoal& goal)>& distances) {
  double sum = 0;
  int asked = 0;
  for (const episodes::EpisodeGoal& goal : goals) {
    std::vector<double> near = distances(goal);
    const auto count = std::min(near.size(), static_cast<std::size_t>(goal.count));
    std::ranges::partial_sort(near, near.begin() + static_cast<std::ptrdiff_t>(count));
    for (std::size_t i = 0; i < count; ++i)
      sum += 1 - std::tanh(near[i] / scale_m);
    asked += goal.count;
  }
  return asked > 0 ? sum / asked : 0;
}

}  // namespace marketgen::environments
