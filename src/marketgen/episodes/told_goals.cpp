#include "episodes/told_goals.h"

#include <algorithm>

namespace marketgen::episodes {

std::vector<ToldGoal> told_goals(const EpisodeSpec& spec) {
  std::vector<ToldGoal> told;
  for (const EpisodeGoal& goal : spec.goals) {
    if (spec.instructions == Instructions::words)
      told.push_back({goal.text, std::nullopt, goal.count});
    else
      told.push_back({std::nullopt, goal.sku, goal.count});
  }
  return told;
}

std::vector<ToldCategory> told_categories(const EpisodeSpec& spec) {
  std::vector<ToldCategory> told;
  for (const CategoryPlace& place : spec.categories) {
    const auto goal = std::ranges::find(spec.goals, place.sku, &EpisodeGoal::sku);
    ToldCategory category;
    category.goal = static_cast<int>(goal - spec.goals.begin());
    if (spec.instructions == Instructions::ids) category.sku = place.sku;
    category.category = place.category;
    category.x_m = place.x_m;
    category.y_m = place.y_m;
    told.push_back(std::move(category));
  }
  return told;
}

}  // namespace marketgen::episodes
