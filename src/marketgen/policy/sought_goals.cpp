#include "policy/sought_goals.h"

#include <algorithm>
#include <functional>

#include <fmt/format.h>

#include "base/progress.h"

namespace marketgen::policy {
namespace {

// Of the likeness of one that was put down. Seen in 12 baskets of v1: 0.64 to 0.75 where it was
// something else, 0.74 and more where it was another of the same.
constexpr double doubtful_share = 0.75;

// Of the mask that looks most like it, by size and colours.
double likeness_in_sight(const Sight& sight, const perception::ProductLook& look) {
  double most = 0;
  for (const perception::MaskedView& masked : sight.masked) {
    for (const perception::Mask& mask : masked.masks) {
      const perception::SurfacePatch patch =
          perception::patch_of(sight.views[masked.view], mask, sight_patch_points);
      if (is_of_size(patch, look))
        most = std::max(most, perception::color_likeness(patch.colors, look));
    }
  }
  return most;
}

}  // namespace

Result<SoughtGoals::Goal> SoughtGoals::read(const agent::TaskGoal& told,
                                            const perception::GoalReader* reader,
                                            const Catalogue& catalogue) const {
  Goal goal;
  goal.count = told.count;
  goal.words = told.text;
  const auto skus = goal_skus(told, reader);
  if (!skus.ok() && skus.error().code != not_understood) return skus.error();
  if (!skus.ok()) {
    log_debug(fmt::format("classical: {}", to_string(skus.error())));
    return goal;
  }
  for (const std::string& sku : *skus) {
    const auto known = std::ranges::find(catalogue, sku, &perception::ProductLook::sku);
    if (known == catalogue.end())
      return Error{"catalog.unknown_sku", sku, "the agent's catalogue has no such product"};
    goal.readings.push_back(*known);
  }
  return goal;
}

Result<void> SoughtGoals::learn(const std::vector<agent::TaskGoal>& told,
                                const perception::GoalReader* reader,
                                const Catalogue& catalogue) {
  for (const agent::TaskGoal& each : told) {
    MARKETGEN_TRY(Goal goal, read(each, reader, catalogue));
    goals_.push_back(std::move(goal));
  }
  if (std::ranges::all_of(goals_,
                          [](const Goal& goal) { return goal.readings.size() <= max_readings; }))
    want_readings(catalogue);
  return {};
}

void SoughtGoals::want_readings(const Catalogue& catalogue) {
  for (std::size_t goal = 0; goal < goals_.size(); ++goal) {
    for (const perception::ProductLook* look : goals_[goal].readings) {
      wanted_.push_back(
          {look, perception::rivals_of(*look, catalogue), goals_[goal].count, goals_[goal].words});
      of_goal_.push_back(goal);
    }
  }
}

void SoughtGoals::narrow(const Sight& sight, const Catalogue& catalogue) {
  for (Goal& goal : goals_) {
    if (goal.readings.size() <= max_readings) continue;
    std::vector<std::pair<double, const perception::ProductLook*>> alike;
    for (const perception::ProductLook* look : goal.readings)
      alike.emplace_back(likeness_in_sight(sight, *look), look);
    std::ranges::stable_sort(
        alike, std::greater<>{}, [](const auto& entry) { return entry.first; });
    goal.readings.clear();
    for (std::size_t i = 0; i < max_readings; ++i)
      goal.readings.push_back(alike[i].second);
  }
  want_readings(catalogue);
}

std::vector<const perception::FoundProduct*> SoughtGoals::found_of(const Sight& sight,
                                                                   std::size_t goal) const {
  const perception::ProductLook* meant = goals_[goal].taken_as;
  std::vector<const perception::FoundProduct*> of_goal;
  for (const perception::FoundProduct& found : sight.found) {
    if (of_goal_[found.look] != goal) continue;
    if (found.pose.evidence.likeness() < doubtful_share * goals_[goal].sure_likeness) continue;
    if (meant == nullptr) meant = wanted_[found.look].look;
    if (wanted_[found.look].look == meant) of_goal.push_back(&found);
  }
  return of_goal;
}

std::vector<std::string> SoughtGoals::skus_of(std::size_t goal) const {
  std::vector<std::string> skus;
  for (const perception::ProductLook* look : goals_[goal].readings)
    skus.push_back(look->sku());
  return skus;
}

bool SoughtGoals::is_unloaded(const perception::FoundProduct& found,
                              const agent::WorkArea& unloading) const {
  const Vec3 at = middle_of(look_of(found), found.pose.base_from_product);
  return unloading.holds(at.x, at.y);
}

int SoughtGoals::there_of(const Sight& sight,
                          std::size_t goal,
                          const agent::WorkArea& unloading) const {
  const auto found = found_of(sight, goal);
  const auto seen_there = static_cast<int>(std::ranges::count_if(
      found, [&](const auto* each) { return is_unloaded(*each, unloading); }));
  const int unseen = std::max(0, goals_[goal].count - static_cast<int>(found.size()));
  return seen_there + std::clamp(goals_[goal].put_down - seen_there, 0, unseen);
}

bool SoughtGoals::may_find_more(const Sight& sight, const agent::WorkArea& unloading) const {
  for (std::size_t goal = 0; goal < goals_.size(); ++goal)
    if (is_read(goal) && !is_there(sight, goal, unloading)) return true;
  return false;
}

void SoughtGoals::note_taken(std::size_t goal,
                             const perception::ProductLook& look,
                             double likeness) {
  ++goals_[goal].tries;
  goals_[goal].taken_as = &look;
  goals_[goal].taken_likeness = likeness;
}

void SoughtGoals::note_put_down(std::size_t goal) {
  ++goals_[goal].put_down;
  goals_[goal].sure_likeness = std::max(goals_[goal].sure_likeness, goals_[goal].taken_likeness);
}

}  // namespace marketgen::policy
