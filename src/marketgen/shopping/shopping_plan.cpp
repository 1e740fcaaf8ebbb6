#include "shopping/shopping_plan.h"

#include <algorithm>
#include <utility>

#include "shopping/budget_choice.h"
#include "shopping/plan_lines.h"

namespace marketgen::shopping {
namespace {

struct Bill {
  std::vector<ChosenAnswer> bought;
  std::vector<const Part*> missing;
};

// In the order of Choice::answers.
Bill bill_of(const ShoppingParts& parts, const Choice& choice) {
  Bill bill;
  std::size_t at = 0;
  const auto add = [&](const Part& part) {
    const int answer = choice.answers[at++];
    if (answer == nothing_chosen)
      bill.missing.push_back(&part);
    else
      bill.bought.push_back({&part, part.answers[answer]});
  };
  for (const Part& part : parts.items)
    add(part);
  for (std::size_t m = 0; m < parts.meals.size(); ++m)
    for (const Part& part : parts.meals[m].menus[choice.menus[m]].parts)
      add(part);
  return bill;
}

// Parts that share a product may cost less together than each by itself: what that leaves buys what
// is missing, the needed first.
void spend_the_rest(Bill& bill, std::int64_t budget) {
  const auto has_meal = [&](const Part& extra) {
    return std::ranges::any_of(bill.bought, [&](const ChosenAnswer& bought) {
      return bought.part->kind != PartKind::item && bought.part->meal == extra.meal;
    });
  };
  std::ranges::stable_sort(bill.missing, {}, &Part::kind);
  std::erase_if(bill.missing, [&](const Part* part) {
    if (part->kind == PartKind::extra && !has_meal(*part)) return false;
    for (const Answer& answer : part->answers) {
      bill.bought.push_back({part, answer});
      if (coins_of(bill.bought) <= budget) return true;
      bill.bought.pop_back();
    }
    return false;
  });
}

}  // namespace

Result<ShoppingPlan> plan_shopping(const ShoppingRequest& request,
                                   const Assortment& assortment,
                                   const ShoppingKnowledge& knowledge) {
  MARKETGEN_TRY(const ShoppingParts parts, parts_of(request, assortment, knowledge));
  std::optional<std::int64_t> budget;
  if (request.budget) {
    MARKETGEN_TRY(budget, coins_of(*request.budget, assortment));
  }
  const Choices choices = choose(parts, budget);
  Bill bill = bill_of(parts, choices.best);
  if (budget) spend_the_rest(bill, *budget);
  ShoppingPlan plan = empty_plan(request, assortment, knowledge);
  for (std::size_t m = 0; m < parts.meals.size(); ++m)
    plan.menus.push_back(
        menu_text(parts.meals[m].wish, parts.meals[m].menus[choices.best.menus[m]].name));
  for (const Part* part : bill.missing) {
    if (part->kind == PartKind::extra) {
      plan.left_out.push_back(part->name);
      continue;
    }
    const double least = price_of(choices.min_coins, assortment);
    plan.unmet.push_back(unmet_part(*part, least, assortment));
    if (plan.unmet.back().kind == UnmetKind::over_budget) plan.least = least;
  }
  plan.lines = lines_of(bill.bought, parts.allowed);
  plan.total = price_of(coins_of(bill.bought), assortment);
  return plan;
}

}  // namespace marketgen::shopping
