// What an agent is told of its goals: with instructions in words a text for each and no SKU.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/fields.h"
#include "episodes/episode_spec.h"

namespace marketgen::episodes {

struct ToldGoal {
  std::optional<std::string> text, sku;  // one of both
  int count = 1;
  static constexpr auto fields =
      field_list(field("text", &ToldGoal::text, "instructions in words: what is asked for"),
                 field("sku", &ToldGoal::sku, "instructions by SKU: the product"),
                 field("count", &ToldGoal::count, "how many", range(1, 100)));
};

// Where products of a goal's category stand.
struct ToldCategory {
  int goal = 0;                    // its number in the told goals, from 0
  std::optional<std::string> sku;  // instructions by SKU: of that goal
  std::string category;
  double x_m = 0, y_m = 0;
  static constexpr auto fields =
      field_list(field("goal", &ToldCategory::goal, "number of the goal, from 0", range(0, 100)),
                 field("sku", &ToldCategory::sku, "instructions by SKU: of the goal"),
                 field("category", &ToldCategory::category, "of that product"),
                 field("x_m", &ToldCategory::x_m, "middle of its products in the store, east"),
                 field("y_m", &ToldCategory::y_m, "north"));
};

// In the episode's order.
std::vector<ToldGoal> told_goals(const EpisodeSpec& spec);
// Of goals of the episode only (check_episode).
std::vector<ToldCategory> told_categories(const EpisodeSpec& spec);

}  // namespace marketgen::episodes
