// What somebody wants to have bought, read from what they say: meals and occasions, persons, a
// budget, a list, what is at home, and what must not be in it.
//
//   breakfast for two under 10 €
//   two cartons of milk, bread and 500 g of pasta; I have butter
//   vegetarian dinner for a family of four, no mushrooms, at most 25 euros
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "catalog/catalog.h"
#include "perception/goal_reader.h"
#include "shopping/meal_table.h"

namespace marketgen::shopping {

struct MealWish {
  std::string meal;  // id of the table
  int persons = 1;
  bool persons_said = true;  // false: as many as is usual

  static constexpr auto fields =
      field_list(field("meal", &MealWish::meal, "which meal", identifier()),
                 field("persons", &MealWish::persons, "for how many", range(1, 200)),
                 field("persons_said", &MealWish::persons_said, "false: as many as is usual"));
};

struct Budget {
  double amount = 0;
  std::string money;  // as it was said: "€", "euro"; empty: that of the store

  static constexpr auto fields =
      field_list(field("amount", &Budget::amount, "at most", range(0.01, 1e7), required()),
                 field("money", &Budget::money, "as it was said; empty: that of the store"));
};

struct ShoppingRequest {
  std::string words;
  std::vector<MealWish> meals;
  std::vector<std::string> items;    // of a list, in its words: "two cartons of milk"
  std::vector<std::string> at_home;  // the same
  std::vector<std::string> diets;    // ids of the table
  std::vector<std::string> without;  // words that no row may say
  std::optional<Budget> budget;

  static constexpr auto fields =
      field_list(field("words", &ShoppingRequest::words, "as they were said", at_most_bytes(2000)),
                 field("meals", &ShoppingRequest::meals, "meals and occasions"),
                 field("items", &ShoppingRequest::items, "items of a list, in its words"),
                 field("at_home", &ShoppingRequest::at_home, "what need not be bought"),
                 field("diets", &ShoppingRequest::diets, "diets and exclusions of data/meals.json"),
                 field("without", &ShoppingRequest::without, "words that no row may say"),
                 field("budget", &ShoppingRequest::budget, "what all may cost together"));
};

// All that is known without a store: the catalogue's rows, what meals are made of, how words are
// read. Immutable; any number of threads may use it.
class ShoppingKnowledge {
 public:
  // `catalog` in the money of the store; it must outlive this. Errors: those of load_meals.
  static Result<ShoppingKnowledge> load(const catalog::Catalog& catalog,
                                        const std::filesystem::path& data);

  const catalog::Catalog& catalog() const { return *catalog_; }
  const MealTable& table() const { return table_; }
  const perception::CatalogueReader& reader() const { return reader_; }
  // Words that a list's item begins or ends with and that say nothing, as of plain_words().
  bool is_filler(std::string_view word) const;
  bool is_container(std::string_view word) const;

 private:
  ShoppingKnowledge(const catalog::Catalog& catalog, MealTable table);

  const catalog::Catalog* catalog_;
  MealTable table_;
  perception::CatalogueReader reader_;
};

// Reads English. The longest request is 2,000 bytes. Errors: shopping.not_understood, with the
// words at fault, their place in bytes and what to say instead; input.not_utf8.
Result<ShoppingRequest> read_request(std::string_view words, const ShoppingKnowledge& knowledge);

}  // namespace marketgen::shopping
