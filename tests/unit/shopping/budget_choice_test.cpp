// The knapsack against every choice there is.
#include "shopping/budget_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <tuple>

namespace marketgen {
namespace {

using shopping::Answer;
using shopping::Part;
using shopping::PartKind;

using Worth = std::tuple<int, int, int, int, std::int64_t>;  // the lower the better

// All choices of a list of parts, one after the other; extras only with something that is needed.
Worth best_by_trying(const std::vector<Part>& parts, std::int64_t budget) {
  Worth best{99, 99, 99, 0, 0};
  std::vector<int> pick(parts.size(), -1);
  for (;;) {
    std::array<int, 3> missing{};
    int preference = 0;
    std::int64_t coins = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (pick[i] < 0) {
        ++missing[static_cast<std::size_t>(parts[i].kind)];
        continue;
      }
      preference += parts[i].answers[pick[i]].preference;
      coins += parts[i].answers[pick[i]].coins();
    }
    const auto needs = std::ranges::count(parts, PartKind::need, &Part::kind);
    const auto extras = std::ranges::count(parts, PartKind::extra, &Part::kind);
    const bool extras_alone = needs > 0 && missing[1] == needs && missing[2] < extras;
    if (coins <= budget && !extras_alone)
      best = std::min(best, Worth{missing[0], missing[1], missing[2], -preference, coins});
    std::size_t at = 0;
    while (at < pick.size() && ++pick[at] == static_cast<int>(parts[at].answers.size()))
      pick[at++] = -1;
    if (at == pick.size()) return best;
  }
}

TEST(BudgetChoice, IsTheBestOfAllChoices) {
  std::mt19937 draw(3);
  std::vector<catalog::Product> products(40);
  for (catalog::Product& product : products)
    product.price = 0.01 * static_cast<double>(20 + draw() % 700);
  for (int round = 0; round < 60; ++round) {
    shopping::ShoppingParts parts;
    parts.meals.push_back({.wish = {.meal = "meal"}, .menus = {{.name = "menu"}}});
    std::vector<Part> all;
    for (std::size_t i = 0, count = 2 + draw() % 5; i < count; ++i) {
      Part part{.name = "part", .kind = static_cast<PartKind>(draw() % 3)};
      for (auto k = draw() % 4; k > 0; --k)
        part.answers.push_back({.product = &products[draw() % products.size()],
                                .packs = static_cast<double>(1 + draw() % 3),
                                .preference = static_cast<int>(draw() % 10)});
      (part.kind == PartKind::item ? parts.items : parts.meals[0].menus[0].parts).push_back(part);
      all.push_back(part);
    }
    std::ranges::stable_sort(parts.meals[0].menus[0].parts, {}, &Part::kind);
    const std::int64_t budget = draw() % 3000;
    const shopping::Choice best = shopping::choose(parts, budget).best;
    const Worth expected = best_by_trying(all, budget);
    EXPECT_EQ(std::tie(best.missing_items, best.missing_needs, best.missing_extras, best.coins),
              std::tuple(std::get<0>(expected),
                         std::get<1>(expected),
                         std::get<2>(expected),
                         std::get<4>(expected)));
  }
}

}  // namespace
}  // namespace marketgen
