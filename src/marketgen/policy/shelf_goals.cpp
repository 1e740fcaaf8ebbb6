#include "policy/shelf_goals.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/progress.h"
#include "perception/rivals.h"
#include "policy/goal_skus.h"

namespace marketgen::policy {
namespace {

constexpr int max_tries = 3;  // an item

using Looks = std::vector<const perception::ProductLook*>;

Result<Looks> looks_of(const std::vector<const catalog::Product*>& rows,
                       const agent::KnownProducts& products,
                       perception::LookLibrary& library) {
  Looks looks;
  for (const catalog::Product* row : rows) {
    MARKETGEN_TRY(const perception::ProductLook* look, library.of(*row, products));
    looks.push_back(look);
  }
  return looks;
}

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
        looks_of(perception::rivals_of_any_kind(known->product, products.rows()), products, looks));
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
    MARKETGEN_TRY(goal.look, looks.of(known->product, products));
    MARKETGEN_TRY(
        goal.rivals,
        looks_of(perception::rivals_of(known->product, products.rows()), products, looks));
    const auto hint = std::ranges::find(hints, number, &agent::CategoryHint::goal);
    if (hint == hints.end())
      return Error{"episode.impossible", goal.sku, "nothing says where its category stands"};
    goal.hint = hint->position;
  }
  return goals;
}

}  // namespace marketgen::policy
