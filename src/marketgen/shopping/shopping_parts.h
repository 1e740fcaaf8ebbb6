// The parts of a request, and what in a store would answer each.
//
// An item of the list is a part, and so is every food of a menu. A part that another answers, or
// that is at home, is no part of what is bought.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shopping/item_reading.h"

namespace marketgen::shopping {

enum class PartKind { item, need, extra };

struct Part {
  std::string name;  // "breakfast: bread or rolls"; of an item, its words
  PartKind kind = PartKind::item;
  std::optional<ItemReading> item =
      {};  // or a food for so many persons, of the meal of that number
  const Food* food = nullptr;
  int persons = 1, meal = 0;
  std::vector<Answer> answers = {};  // worth a thought, each of another product; may be empty
  // Products that would answer it, were they not sold out.
  std::vector<const catalog::Product*> sold_out = {};
  // Of an item whose product the store does not sell: the name of that product.
  std::string not_sold = {};
  // Allowed by nothing but the request's diet and exclusions: how many were refused.
  int refused = 0;

  // Any product as an answer; empty for what is none.
  std::optional<Answer> answer_by(const catalog::Product& product) const;
};

struct MenuParts {
  std::string name;
  std::vector<Part> parts = {};  // the needed first
};

struct MealParts {
  MealWish wish;
  std::vector<MenuParts> menus = {};  // the usual one first
};

struct ShoppingParts {
  std::vector<Part> items;
  std::vector<MealParts> meals;
  std::vector<const catalog::Product*> allowed;  // of the store, all that may be bought
};

// Of each option of a food the `breadth` answers that cost the least; of an item the one or two
// that a plan needs, or with more breadth the nearest. Errors: shopping.not_understood for an item
// that no row fits; catalog.unknown_sku for a sold-out SKU that the store does not sell.
Result<ShoppingParts> parts_of(const ShoppingRequest& request,
                               const Assortment& assortment,
                               const ShoppingKnowledge& knowledge,
                               std::size_t breadth = 1);

// "breakfast: eggs".
std::string part_name(std::string_view meal, const Food& food);

}  // namespace marketgen::shopping
