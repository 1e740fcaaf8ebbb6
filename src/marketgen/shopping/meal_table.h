// What meals are made of, how much of it a person eats, and what diets forbid: data/meals.json.
//
// A meal has menus, the usual one first; a menu needs foods and may have extras; a food is any of
// its options, the better one first. The amounts are of one person and one meal.
#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "catalog/product.h"

namespace marketgen::shopping {

// gram: a millilitre counts as one. pack: as many packs, whatever is in them.
enum class MealUnit { gram, piece, pack };
constexpr std::array<std::string_view, 3> names_of(MealUnit) {
  return {"gram", "piece", "pack"};
}

// Products of a group ("dairy/milk") whose name has one of `names` (any when empty), and whose
// name, variant and keywords have none of `without`.
struct FoodOption {
  std::vector<std::string> groups, names, without;
  double amount = 1;
  MealUnit unit = MealUnit::gram;

  static constexpr auto fields = field_list(
      field("groups", &FoodOption::groups, "category/subcategory", required()),
      field("names", &FoodOption::names, "words of a name; empty: any"),
      field("without", &FoodOption::without, "words that the row must not have"),
      field("amount", &FoodOption::amount, "of one person", range(0.01, 10'000), required()),
      field("unit", &FoodOption::unit, "of the amount"));
};

struct Food {
  std::string id, name;
  std::vector<std::string> say;  // what a list calls it: "bread"; empty: only meals have it
  std::vector<FoodOption> options;

  static constexpr auto fields =
      field_list(field("id", &Food::id, "unique", identifier()),
                 field("name", &Food::name, "what people call it", required()),
                 field("say", &Food::say, "what an item of a list is called that means any of it"),
                 field("options", &Food::options, "the better one first", required()));
};

struct Menu {
  std::string name;
  std::vector<std::string> needs, extras;  // ids of foods

  static constexpr auto fields =
      field_list(field("name", &Menu::name, "what people call it", required()),
                 field("needs", &Menu::needs, "foods without which it is no such meal", required()),
                 field("extras", &Menu::extras, "foods that go with it where money is left"));
};

struct Meal {
  std::string id;
  std::vector<std::string> say;      // "breakfast", "bake a cake"
  std::vector<std::string> say_for;  // the same where persons are told: "tea for two"
  int usual_persons = 1;             // where nobody says for how many
  std::vector<Menu> menus;

  static constexpr auto fields =
      field_list(field("id", &Meal::id, "unique", identifier()),
                 field("say", &Meal::say, "words that name it", required()),
                 field("say_for", &Meal::say_for, "words that name it where persons are told"),
                 field("usual_persons",
                       &Meal::usual_persons,
                       "for how many it is where nobody says it",
                       range(1, 100)),
                 field("menus", &Meal::menus, "the usual one first", required()));
};

// What a diet leaves out, as far as rows tell it. A row that says one of `told_by` is allowed; one
// of `never_groups`, or that says one of `never_words`, is not; of the others those of
// `plain_groups` and `plain_names` are allowed, or all when both are empty and not `only_told`.
struct Diet {
  std::string id;
  std::vector<std::string> say, told_by, never_groups, never_words, plain_groups, plain_names;
  bool only_told = false;    // nothing is allowed that does not say it
  bool cannot_tell = false;  // no row tells anything of it: nothing is left out
  std::string caution;       // what rows do not tell of it

  static constexpr auto fields = field_list(
      field("id", &Diet::id, "unique", required()),
      field("say", &Diet::say, "words that name it", required()),
      field("told_by", &Diet::told_by, "words by which a row says that it is so"),
      field("never_groups", &Diet::never_groups, "category/subcategory that it forbids"),
      field("never_words", &Diet::never_words, "words of rows that it forbids"),
      field("plain_groups", &Diet::plain_groups, "category/subcategory that it allows by nature"),
      field("plain_names", &Diet::plain_names, "words of names that it allows by nature"),
      field("only_told", &Diet::only_told, "it allows nothing that does not say so"),
      field("cannot_tell", &Diet::cannot_tell, "rows tell nothing of it"),
      field("caution", &Diet::caution, "what rows do not tell of it", required()));
};

struct MealTable {
  std::vector<std::string> filler;      // words of requests that say nothing
  std::vector<std::string> containers;  // words for packs, of any product
  std::vector<Food> foods;
  std::vector<Meal> meals;
  std::vector<Diet> diets;

  // Each returns null when there is no such row.
  const Food* food(std::string_view id) const;
  const Meal* meal(std::string_view id) const;
  const Diet* diet(std::string_view id) const;

  static constexpr auto fields =
      field_list(field("filler", &MealTable::filler, "words of requests that say nothing"),
                 field("containers", &MealTable::containers, "words for packs of any product"),
                 field("foods", &MealTable::foods, "what meals are made of", required()),
                 field("meals", &MealTable::meals, "meals and occasions", required()),
                 field("diets", &MealTable::diets, "what they leave out", required()));
};

// data/meals.json. Errors: those of reading it; catalog.bad_row for a food that a menu names and
// the table has not.
Result<MealTable> load_meals(const std::filesystem::path& data);

// "dairy/milk".
std::string group_of(const catalog::Product& product);

// Whether the words stand in `spaced` (base/words.h), one after the other.
bool has_words(std::string_view spaced, std::string_view words);

// The better the lower: index of the first option that the product is of; -1 for none. Options in
// pieces take products that are counted in pieces.
int option_of(const Food& food, const catalog::Product& product);

// How many packs of the product `persons` want of the option: 1.6. 0 when it cannot be told.
double packs_for(const FoodOption& option, const catalog::Product& product, int persons);

// Grams or millilitres in a pack; of loose goods, of one of them.
double content_of(const catalog::Product& product);
// Pieces in a pack: "10 pieces", "20 bags", "each". 0 when it does not tell them.
double pieces_of_pack(const catalog::Product& product);

}  // namespace marketgen::shopping
