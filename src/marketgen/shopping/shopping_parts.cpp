#include "shopping/shopping_parts.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"

namespace marketgen::shopping {
namespace {

// What of the store may be bought at all.
struct Offered {
  std::vector<const catalog::Product*> allowed, sold_out;
  std::vector<const catalog::Product*> refused;
  std::size_t breadth = 1;
};

Offered offered_of(const ShoppingRequest& request,
                   const Assortment& assortment,
                   const ShoppingKnowledge& knowledge) {
  Offered offered;
  for (const catalog::Product& product : assortment.products) {
    if (refusal(product, request, knowledge))
      offered.refused.push_back(&product);
    else if (assortment.is_sold_out(product.sku))
      offered.sold_out.push_back(&product);
    else
      offered.allowed.push_back(&product);
  }
  return offered;
}

// Of each option the answers that cost the least; the first of equals is that of the lowest SKU.
std::vector<Answer> cheapest_answers(const Part& part, const Offered& offered) {
  std::vector<std::vector<Answer>> of_preference(max_preference);
  for (const catalog::Product* product : offered.allowed)
    if (const auto answer = part.answer_by(*product))
      of_preference[max_preference - 1 - answer->preference].push_back(*answer);
  std::vector<Answer> cheapest;
  for (std::vector<Answer>& answers : of_preference) {
    std::ranges::stable_sort(answers, {}, &Answer::coins);
    if (answers.size() > offered.breadth) answers.resize(offered.breadth);
    cheapest.insert(cheapest.end(), answers.begin(), answers.end());
  }
  return cheapest;
}

Part food_part(
    const Food& food, PartKind kind, const MealWish& wish, int meal, const Offered& offered) {
  Part part{.name = part_name(wish.meal, food),
            .kind = kind,
            .food = &food,
            .persons = wish.persons,
            .meal = meal};
  part.answers = cheapest_answers(part, offered);
  for (const catalog::Product* product : offered.sold_out)
    if (part.answer_by(*product)) part.sold_out.push_back(product);
  part.refused = static_cast<int>(std::ranges::count_if(
      offered.refused, [&](const auto* product) { return part.answer_by(*product).has_value(); }));
  return part;
}

bool any_is_food(const std::vector<ItemReading>& items, const Food& food) {
  return std::ranges::any_of(items, [&](const auto& item) { return is_food(item, food); });
}

struct Readings {
  std::vector<ItemReading> items, home;
};

void add_foods(const std::vector<std::string>& foods,
               PartKind kind,
               const MealWish& wish,
               int meal,
               const Readings& readings,
               const Offered& offered,
               const MealTable& table,
               MenuParts& menu) {
  for (const std::string& id : foods) {
    const Food& food = *table.food(id);
    if (any_is_food(readings.items, food) || any_is_food(readings.home, food)) continue;
    menu.parts.push_back(food_part(food, kind, wish, meal, offered));
  }
}

Part item_part(const ItemReading& item, const Offered& offered) {
  Part part{.name = item.words, .kind = PartKind::item, .item = item};
  std::vector<Answer> answers;
  for (const catalog::Product* product : offered.allowed)
    if (const auto answer = answer_of(item, *product)) answers.push_back(*answer);
  part.answers = worth_a_thought(std::move(answers), offered.breadth);
  for (const catalog::Product* product : offered.sold_out)
    if (const auto answer = answer_of(item, *product); answer && !answer->other)
      part.sold_out.push_back(product);
  const bool any_said =
      std::ranges::any_of(part.answers, [](const Answer& answer) { return !answer.other; });
  if (!any_said && part.sold_out.empty()) part.not_sold = item.wanted.front()->name;
  part.refused = static_cast<int>(std::ranges::count_if(
      offered.refused, [&](const auto* product) { return answer_of(item, *product).has_value(); }));
  return part;
}

Result<void> check_sold_out(const Assortment& assortment) {
  std::vector<std::string_view> skus;
  for (const catalog::Product& product : assortment.products)
    skus.push_back(product.sku);
  for (const std::string& sku : assortment.sold_out)
    if (assortment.product(sku) == nullptr)
      return Error{"catalog.unknown_sku",
                   sku,
                   fmt::format("the store does not sell it{}; `marketgen query STORE planogram` "
                               "lists what it sells",
                               did_you_mean(sku, skus))};
  return {};
}

MealParts meal_parts(const MealWish& wish,
                     int number,
                     const Readings& readings,
                     const Offered& offered,
                     const MealTable& table) {
  MealParts meal{.wish = wish};
  for (const Menu& menu : table.meal(wish.meal)->menus) {
    MenuParts parts{.name = menu.name};
    add_foods(menu.needs, PartKind::need, wish, number, readings, offered, table, parts);
    add_foods(menu.extras, PartKind::extra, wish, number, readings, offered, table, parts);
    meal.menus.push_back(std::move(parts));
  }
  return meal;
}

}  // namespace

std::optional<Answer> Part::answer_by(const catalog::Product& product) const {
  if (item) return answer_of(*item, product);
  const int option = option_of(*food, product);
  if (option < 0) return std::nullopt;
  return Answer{.product = &product,
                .packs = packs_for(food->options[option], product, persons),
                .preference = std::max(1, max_preference - 1 - option)};
}

std::string part_name(std::string_view meal, const Food& food) {
  return fmt::format("{}: {}", meal, food.name);
}

Result<ShoppingParts> parts_of(const ShoppingRequest& request,
                               const Assortment& assortment,
                               const ShoppingKnowledge& knowledge,
                               std::size_t breadth) {
  MARKETGEN_CHECK(check_sold_out(assortment));
  MARKETGEN_TRY(std::vector<ItemReading> items, read_items(request.items, knowledge));
  MARKETGEN_TRY(std::vector<ItemReading> home, read_items(request.at_home, knowledge));
  Offered offered = offered_of(request, assortment, knowledge);
  offered.breadth = breadth;
  ShoppingParts parts;
  std::erase_if(items, [&](const ItemReading& item) { return is_among(item, home); });
  for (const ItemReading& item : items)
    parts.items.push_back(item_part(item, offered));
  const Readings readings{std::move(items), std::move(home)};
  for (const MealWish& wish : request.meals) {
    const int number = static_cast<int>(parts.meals.size());
    parts.meals.push_back(meal_parts(wish, number, readings, offered, knowledge.table()));
  }
  parts.allowed = std::move(offered.allowed);
  return parts;
}

}  // namespace marketgen::shopping
