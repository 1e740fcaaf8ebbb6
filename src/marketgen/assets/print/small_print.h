// The table of small print: which row of pack_foods.inc or pack_goods.inc a product's words come
// from.
//
// A row applies only where it says (`where`: categories, or subcategories of one). Of the rows that
// apply, the one whose longest phrase stands in the product's name wins; failing that the one
// without words for its subcategory, then the one for its category. Phrases are whole words, case,
// hyphens and plurals aside: "pea" is in "Garden Peas", not in "Peach Halves".
#pragma once
#include <string_view>

#include "catalog/product.h"

namespace marketgen::assets {

// Stands for the fat of a food that bears no nutrition table.
constexpr double no_table = -1;

struct FoodRow {
  std::string_view where, words;
  double fat, saturates, carbohydrate, sugars, protein, salt;  // g per 100 g or 100 ml
  std::string_view ingredients;
};

struct GoodsRow {
  std::string_view where, words;
  bool dated;  // bears a date, as food does
  std::string_view contents, directions;
};

// Null for what is not food, or of a category that the table does not know.
const FoodRow* food_row_of(const catalog::Product& product);
// Null for food, or for a category that the table does not know.
const GoodsRow* goods_row_of(const catalog::Product& product);

// Whether `phrase` stands in `text` as whole words.
bool has_phrase(std::string_view text, std::string_view phrase);

}  // namespace marketgen::assets
