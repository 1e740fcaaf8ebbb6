#include "shopping/check_shopping.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "shopping/item_reading.h"
#include "shopping/plan_lines.h"

namespace marketgen::shopping {
namespace {

constexpr double tolerance = 1e-6;

Error bad_plan(std::string where, std::string message) {
  return {"shopping.bad_plan", std::move(where), std::move(message)};
}

// Something to be bought, and how products answer it.
struct Asked {
  std::string name;
  std::optional<ItemReading> item = {};  // or a food
  const Food* food = nullptr;
  int persons = 1;
  bool required = true;

  // Packs that are wanted of the product; 0 when it does not answer it.
  double packs_of(const catalog::Product& product) const {
    if (item) {
      const auto answer = answer_of(*item, product);
      return answer ? answer->packs : 0;
    }
    const int option = option_of(*food, product);
    return option < 0 ? 0 : packs_for(food->options[option], product, persons);
  }
  bool is_said_by(const catalog::Product& product) const {
    if (!item) return packs_of(product) > 0;
    const auto answer = answer_of(*item, product);
    return answer && !answer->other;
  }
};

class PlanCheck {
 public:
  PlanCheck(const ShoppingPlan& plan,
            const ShoppingRequest& request,
            const Assortment& assortment,
            const ShoppingKnowledge& knowledge)
      : plan_(plan), request_(request), assortment_(assortment), knowledge_(knowledge) {}

  Result<void> check() {
    MARKETGEN_CHECK(note_asked());
    MARKETGEN_CHECK(check_rows());
    MARKETGEN_CHECK(check_sums());
    MARKETGEN_CHECK(check_answers());
    return check_unanswered();
  }

 private:
  Result<void> note_asked() {
    MARKETGEN_TRY(const std::vector<ItemReading> items, read_items(request_.items, knowledge_));
    MARKETGEN_TRY(const std::vector<ItemReading> home, read_items(request_.at_home, knowledge_));
    std::vector<ItemReading> named = home;
    for (const ItemReading& item : items) {
      if (is_among(item, home)) continue;
      asked_.push_back({.name = item.words, .item = item});
      named.push_back(item);
    }
    if (plan_.menus.size() != request_.meals.size())
      return bad_plan("menus", "it has not one menu for each meal");
    for (std::size_t i = 0; i < request_.meals.size(); ++i)
      MARKETGEN_CHECK(note_meal(request_.meals[i], plan_.menus[i], named));
    return {};
  }

  Result<void> note_meal(const MealWish& wish,
                         const std::string& text,
                         const std::vector<ItemReading>& named) {
    const Meal* meal = knowledge_.table().meal(wish.meal);
    if (meal == nullptr) return bad_plan(wish.meal, "there is no such meal");
    const auto menu = std::ranges::find_if(
        meal->menus, [&](const Menu& each) { return menu_text(wish, each.name) == text; });
    if (menu == meal->menus.end()) return bad_plan(text, "the meal has no such menu");
    for (const auto* foods : {&menu->needs, &menu->extras}) {
      for (const std::string& id : *foods) {
        const Food* food = knowledge_.table().food(id);
        if (std::ranges::any_of(named, [&](const auto& item) { return is_food(item, *food); }))
          continue;
        asked_.push_back({.name = part_name(wish.meal, *food),
                          .food = food,
                          .persons = wish.persons,
                          .required = foods == &menu->needs});
      }
    }
    return {};
  }

  // Nothing when it may be bought.
  Result<void> check_row(const std::string& sku) const {
    const catalog::Product* row = assortment_.product(sku);
    if (row == nullptr) return bad_plan(sku, "the store does not sell it");
    if (assortment_.is_sold_out(sku)) return bad_plan(sku, "it is sold out");
    if (const auto why = refusal(*row, request_, knowledge_)) return bad_plan(sku, *why);
    return {};
  }

  Result<void> check_rows() const {
    std::set<std::string> seen;
    for (const ShoppingLine& line : plan_.lines) {
      MARKETGEN_CHECK(check_row(line.sku));
      if (!seen.insert(line.sku).second) return bad_plan(line.sku, "two lines buy it");
      for (const Substitute& substitute : line.substitutes) {
        MARKETGEN_CHECK(check_row(substitute.sku));
        if (substitute.sku == line.sku) return bad_plan(line.sku, "it is its own substitute");
      }
    }
    return {};
  }

  Result<void> check_sums() {
    std::int64_t coins = 0;
    for (const ShoppingLine& line : plan_.lines) {
      const catalog::Product& row = *assortment_.product(line.sku);
      if (line.price != row.price)
        return bad_plan(line.sku,
                        fmt::format("its price is {:g}, not {:g}", row.price, line.price));
      coins += line.count * coins_of(row);
    }
    if (std::abs(price_of(coins, assortment_) - plan_.total) > tolerance)
      return bad_plan(
          "total",
          fmt::format(
              "it is {:g}; the lines cost {:g}", plan_.total, price_of(coins, assortment_)));
    if (!request_.budget) return {};
    MARKETGEN_TRY(const std::int64_t budget, coins_of(*request_.budget, assortment_));
    left_ = budget - coins;
    if (left_ < 0)
      return bad_plan(
          "total",
          fmt::format("{:g} is above the budget of {:g}", plan_.total, request_.budget->amount));
    return {};
  }

  const Asked* asked_as(const std::string& name) const {
    const auto found = std::ranges::find(asked_, name, &Asked::name);
    return found == asked_.end() ? nullptr : &*found;
  }

  bool any_is_said(const Asked& asked) const {
    return std::ranges::any_of(assortment_.products, [&](const catalog::Product& product) {
      return asked.is_said_by(product) && check_row(product.sku).ok();
    });
  }

  Result<void> check_answers() {
    for (const ShoppingLine& line : plan_.lines) {
      const catalog::Product& row = *assortment_.product(line.sku);
      if (line.answers.empty()) return bad_plan(line.sku, "nothing asks for it");
      double packs = 0;
      for (const std::string& name : line.answers) {
        const Asked* asked = asked_as(name);
        if (asked == nullptr)
          return bad_plan(line.sku, fmt::format("nobody asks for \"{}\"", name));
        if (!answered_.insert(name).second)
          return bad_plan(line.sku, fmt::format("\"{}\" is bought twice", name));
        const double wanted = asked->packs_of(row);
        if (wanted <= 0) return bad_plan(line.sku, fmt::format("it is no \"{}\"", name));
        if (!asked->is_said_by(row) && any_is_said(*asked))
          return bad_plan(line.sku, fmt::format("the store has what \"{}\" says", name));
        packs += wanted;
      }
      const int count = std::max(1, static_cast<int>(std::ceil(packs - tolerance)));
      if (line.count != count)
        return bad_plan(line.sku,
                        fmt::format("{} packs are bought; {} are wanted", line.count, count));
    }
    return {};
  }

  // Coins of the cheapest answer there is; nothing when there is none.
  std::optional<std::int64_t> cheapest(const Asked& asked) const {
    std::optional<std::int64_t> least;
    const bool any_said = any_is_said(asked);
    for (const catalog::Product& product : assortment_.products) {
      const double packs = asked.packs_of(product);
      if (packs <= 0 || !check_row(product.sku).ok()) continue;
      if (any_said && !asked.is_said_by(product)) continue;
      const auto count = std::max<std::int64_t>(1, std::llround(std::ceil(packs - tolerance)));
      least = std::min(least.value_or(std::numeric_limits<std::int64_t>::max()),
                       count * coins_of(product));
    }
    return least;
  }

  Result<void> check_unanswered() const {
    for (const Asked& asked : asked_) {
      const auto unmet = std::ranges::find(plan_.unmet, asked.name, &UnmetPart::part);
      const bool is_unmet = unmet != plan_.unmet.end() && unmet->kind != UnmetKind::not_told;
      if (answered_.contains(asked.name)) {
        if (is_unmet) return bad_plan(asked.name, "it is bought, and named as unmet");
        continue;
      }
      if (!asked.required) continue;
      if (!is_unmet) return bad_plan(asked.name, "it is neither bought nor named as unmet");
      const auto least = cheapest(asked);
      if (unmet->kind == UnmetKind::not_sold && least)
        return bad_plan(asked.name, "the store has something for it");
      if (unmet->kind == UnmetKind::over_budget && !least)
        return bad_plan(asked.name, "the store has nothing for it");
      if (unmet->kind == UnmetKind::over_budget && (!left_ || *least <= *left_))
        return bad_plan(asked.name, "the budget has money left for it");
    }
    return {};
  }

  const ShoppingPlan& plan_;
  const ShoppingRequest& request_;
  const Assortment& assortment_;
  const ShoppingKnowledge& knowledge_;
  std::vector<Asked> asked_;
  std::set<std::string> answered_;
  std::optional<std::int64_t> left_;  // coins of the budget
};

}  // namespace

Result<void> check_shopping(const ShoppingPlan& plan,
                            const ShoppingRequest& request,
                            const Assortment& assortment,
                            const ShoppingKnowledge& knowledge) {
  return PlanCheck(plan, request, assortment, knowledge).check();
}

}  // namespace marketgen::shopping
