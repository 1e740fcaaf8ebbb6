#include "shopping/budget_choice.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace marketgen::shopping {
namespace {

struct State {
  Choice choice;
  int menu_ranks = 0, preference = 0;

  // The lower the better. What is added to two states leaves their order as it is.
  std::tuple<int, int, int, int, int> worth() const {
    return {
        choice.missing_items, choice.missing_needs, menu_ranks, choice.missing_extras, -preference};
  }
};
using States = std::vector<State>;  // by cost, each better than those before

// Without what costs no less than another that is as good.
States pruned(States states) {
  std::ranges::stable_sort(states, [](const State& a, const State& b) {
    return std::pair(a.choice.coins, a.worth()) < std::pair(b.choice.coins, b.worth());
  });
  States kept;
  for (State& state : states)
    if (kept.empty() || state.worth() < kept.back().worth()) kept.push_back(std::move(state));
  return kept;
}

void note_missing(Choice& choice, PartKind kind) {
  int& count = kind == PartKind::item   ? choice.missing_items
               : kind == PartKind::need ? choice.missing_needs
                                        : choice.missing_extras;
  ++count;
}

// `may_buy`: of a state whether it may have the part.
template <class MayBuy>
States with_part(const States& states, const Part& part, const MayBuy& may_buy) {
  States next;
  for (const State& state : states) {
    State without = state;
    note_missing(without.choice, part.kind);
    without.choice.answers.push_back(nothing_chosen);
    next.push_back(std::move(without));
    for (std::size_t i = 0; i < part.answers.size() && may_buy(state); ++i) {
      State with = state;
      with.choice.coins += part.answers[i].coins();
      with.choice.answers.push_back(static_cast<int>(i));
      with.preference += part.answers[i].preference;
      next.push_back(std::move(with));
    }
  }
  return pruned(std::move(next));
}

// Of one meal alone. Extras are bought only with something that the menu needs: of its states the
// better never has fewer needs.
States of_meal(const MealParts& meal) {
  States all;
  for (std::size_t m = 0; m < meal.menus.size(); ++m) {
    State empty;
    empty.choice.menus.push_back(static_cast<int>(m));
    empty.menu_ranks = static_cast<int>(m);
    States of_menu{empty};
    const auto needs = std::ranges::count(meal.menus[m].parts, PartKind::need, &Part::kind);
    for (const Part& part : meal.menus[m].parts)
      of_menu = with_part(of_menu, part, [&](const State& state) {
        return part.kind != PartKind::extra || needs == 0 || state.choice.missing_needs < needs;
      });
    all.insert(all.end(), of_menu.begin(), of_menu.end());
  }
  return pruned(std::move(all));
}

State joined(const State& first, const State& second) {
  State both = first;
  both.menu_ranks += second.menu_ranks;
  both.preference += second.preference;
  both.choice.coins += second.choice.coins;
  both.choice.missing_items += second.choice.missing_items;
  both.choice.missing_needs += second.choice.missing_needs;
  both.choice.missing_extras += second.choice.missing_extras;
  for (auto list : {&Choice::menus, &Choice::answers})
    (both.choice.*list)
        .insert(
            (both.choice.*list).end(), (second.choice.*list).begin(), (second.choice.*list).end());
  return both;
}

States joined(const States& first, const States& second) {
  States all;
  for (const State& one : first)
    for (const State& other : second)
      all.push_back(joined(one, other));
  return pruned(std::move(all));
}

std::pair<int, int> missing_of(const State& state) {
  return {state.choice.missing_items, state.choice.missing_needs};
}

}  // namespace

Choices choose(const ShoppingParts& parts, std::optional<std::int64_t> budget) {
  States states{{}};
  for (const Part& item : parts.items)
    states = with_part(states, item, [](const State&) { return true; });
  for (const MealParts& meal : parts.meals)
    states = joined(states, of_meal(meal));
  Choices choices;
  const std::pair<int, int> fewest = missing_of(states.back());
  const auto least =
      std::ranges::find_if(states, [&](const State& state) { return missing_of(state) == fewest; });
  choices.min_coins = least->choice.coins;
  const State* best = &states.front();
  for (const State& state : states)
    if (!budget || state.choice.coins <= *budget) best = &state;
  choices.best = best->choice;
  return choices;
}

}  // namespace marketgen::shopping
