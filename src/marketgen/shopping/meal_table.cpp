#include "shopping/meal_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>

#include "base/words.h"
#include "catalog/net_content.h"
#include "io/file.h"
#include "io/json.h"

namespace marketgen::shopping {
namespace {

constexpr std::uint64_t max_table_bytes = 1U << 20;

template <class Row>
const Row* row_with_id(const std::vector<Row>& rows, std::string_view id) {
  const auto found = std::ranges::find(rows, id, &Row::id);
  return found == rows.end() ? nullptr : &*found;
}

Result<void> check_menu(const MealTable& table, const Meal& meal, const Menu& menu) {
  for (const auto* list : {&menu.needs, &menu.extras}) {
    for (const std::string& id : *list) {
      if (table.food(id) == nullptr)
        return Error{"catalog.bad_row",
                     fmt::format("meals.json: {}, {}", meal.id, menu.name),
                     fmt::format("there is no food \"{}\"; name one of \"foods\"", id)};
    }
  }
  return {};
}

bool is_of(const FoodOption& option, const catalog::Product& product) {
  if (std::ranges::find(option.groups, group_of(product)) == option.groups.end()) return false;
  const std::string name = spaced_words(product.name);
  const auto in = [](const std::string& spaced) {
    return [&spaced](const std::string& words) { return has_words(spaced, words); };
  };
  if (!option.names.empty() && std::ranges::none_of(option.names, in(name))) return false;
  if (option.without.empty()) return true;
  std::string all = product.name + " " + product.variant;
  for (const std::string& keyword : product.keywords)
    all += " , " + keyword;
  const std::string row = spaced_words(all);
  return std::ranges::none_of(option.without, in(row));
}

}  // namespace

const Food* MealTable::food(std::string_view id) const {
  return row_with_id(foods, id);
}

const Meal* MealTable::meal(std::string_view id) const {
  return row_with_id(meals, id);
}

const Diet* MealTable::diet(std::string_view id) const {
  return row_with_id(diets, id);
}

Result<MealTable> load_meals(const std::filesystem::path& data) {
  const std::filesystem::path file = data / "meals.json";
  MARKETGEN_TRY(const std::string text, io::read_file(file, max_table_bytes));
  MARKETGEN_TRY(MealTable table, io::read_json<MealTable>(text, file.string()));
  for (const Meal& meal : table.meals)
    for (const Menu& menu : meal.menus)
      MARKETGEN_CHECK(check_menu(table, meal, menu));
  return table;
}

std::string group_of(const catalog::Product& product) {
  return product.category + "/" + product.subcategory;
}

bool has_words(std::string_view spaced, std::string_view words) {
  const std::string sought = spaced_words(words);
  return !sought.empty() && spaced.find(sought) != std::string_view::npos;
}

double content_of(const catalog::Product& product) {
  const auto net = catalog::net_content(product.net);
  if (net && net->unit != catalog::NetUnit::piece) return net->total();
  if (product.unit_of_measure == "kg" || product.unit_of_measure == "l")
    return product.unit_amount * 1000;
  return product.mass_kg * 1000;
}

double pieces_of_pack(const catalog::Product& product) {
  if (product.net == "each") return 1;
  const auto net = catalog::net_content(product.net);
  return net && net->unit == catalog::NetUnit::piece ? net->total() : 0;
}

double packs_for(const FoodOption& option, const catalog::Product& product, int persons) {
  const double wanted = option.amount * persons;
  if (option.unit == MealUnit::pack) return wanted;
  const double in_pack =
      option.unit == MealUnit::piece ? pieces_of_pack(product) : content_of(product);
  return in_pack > 0 ? wanted / in_pack : 0;
}

int option_of(const Food& food, const catalog::Product& product) {
  for (std::size_t i = 0; i < food.options.size(); ++i)
    if (is_of(food.options[i], product) && packs_for(food.options[i], product, 1) > 0)
      return static_cast<int>(i);
  return -1;
}

}  // namespace marketgen::shopping
