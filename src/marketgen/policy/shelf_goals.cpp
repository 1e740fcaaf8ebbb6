#include "policy/shelf_goals.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/progress.h"
#include "perception/rivals.h"
#include "policy/goal_skus.h"

namespace marketgen::policy {
namespace {

constexpr int max_tries = 3;  // an item

}  // namespace

bool ShelfGoal::is_due() const {
  return fetched < wanted && tries < max_tries;
}

perception::WantedProduct ShelfGoal::wanted_afar() const {
  return {look, rivals, wanted - fetched, words};
}

Result<perception::WantedProduct> ShelfGoal::wanted_close(agent::KnownProducts& products,
                                                          perception::LookLibrary& looks) {
  if (close_rivals.empty()) {
    MARKETGEN_TRY(const agent::KnownProduct* known, products.product(sku));
    MARKETGEN_TRY(
        close_rivals,
        looks.of(perception::rivals_of_any_kind(known->product, products.rows()), products));
  }
  return perception::WantedProduct{look, close_rivals, wanted - fetched, words};
}

Result<std::vector<ShelfGoal>> learn_shelf_goals(const std::vector<agent::TaskGoal>& told,
                                                 const perception::GoalReader* reader,
                                                 const std::vector<agent::CategoryHint>& hints,
                                                 agent::KnownProducts& products,
                                                 perception::LookLibrary& looks) {
  std::vector<ShelfGoal> goals;
  for (std::size_t number = 0; number < told.size(); ++number) {
    ShelfGoal& goal = goals.emplace_back();
    goal.wanted = told[number].count;
    goal.words = told[number].text;
    const auto skus = goal_skus(told[number], reader);
    if (!skus.ok() && skus.error().code != not_understood) return skus.error();
    if (!skus.ok()) {
      log_debug(fmt::format("classical: {}", to_string(skus.error())));
      goal.tries = max_tries;
      continue;
    }
    goal.sku = skus->front();
    MARKETGEN_TRY(const agent::KnownProduct* known, products.product(goal.sku));
    MARKETGEN_TRY(const perception::Looks own, looks.of({&known->product}, products));
    goal.look = own.front();
    MARKETGEN_TRY(goal.rivals,
                  looks.of(perception::rivals_of(known->product, products.rows()), products));
    const auto hint = std::ranges::find(hints, number, &agent::CategoryHint::goal);
    if (hint == hints.end())
      return Error{"episode.impossible", goal.sku, "nothing says where its category stands"};
    goal.hint = hint->position;
  }
  return goals;
}

}  // namespace marketgen::policy
