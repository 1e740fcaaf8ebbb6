// What an item of a shopping list means: which rows, and how much of it.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "catalog/net_content.h"
#include "shopping/assortment.h"

namespace marketgen::shopping {

// So much of one product answers a part.
struct Answer {
  const catalog::Product* product = nullptr;  // of the assortment
  double packs = 1;                           // that are wanted: 1.6; whole packs are bought
  bool other = false;                         // not what the words say, but the nearest to it
  double distance = 0;                        // from what they say
  int preference = 0;                         // the more the better, below max_preference

  int count() const;
  std::int64_t coins() const;
};
constexpr int max_preference = 10;

struct ItemReading {
  std::string words;                   // "two cartons of milk"
  std::vector<std::string> said = {};  // "milk": without amounts, packs and fillers; sorted
  std::vector<const catalog::Product*> wanted =
      {};                      // rows of the catalogue that it means, not empty
  const Food* food = nullptr;  // of the table, when it means any of it
  double count = 1;            // packs, or pieces of a pack that counts them
  bool count_said = false, container_said = false;
  std::optional<catalog::NetContent> amount = {};  // in all: 500 g
};

// Error: shopping.not_understood.
Result<ItemReading> read_item(const std::string& words, const ShoppingKnowledge& knowledge);

// All of a list, in its order. The same error.
Result<std::vector<ItemReading>> read_items(const std::vector<std::string>& list,
                                            const ShoppingKnowledge& knowledge);

// The product as an answer to the item: what it says, or else what is of the same group. Empty for
// products of other groups, unless the item's words are their whole name.
std::optional<Answer> answer_of(const ItemReading& item, const catalog::Product& product);

// Of many answers to an item those that a plan may choose among, the preferred one first: of what
// the words say the usual size at the least price, then whatever costs the least; where there is
// none, what is nearest to it. Ties: by SKU.
// With a breadth above 1: the nearest, four times as many.
std::vector<Answer> worth_a_thought(std::vector<Answer> answers, std::size_t breadth);

// Whether the item is a food of that kind: it names it, or a product that is one.
bool is_food(const ItemReading& item, const Food& food);

// Whether one of these means the same as the item, however much of it.
bool is_among(const ItemReading& item, const std::vector<ItemReading>& others);

// How unlike two products of a group are, 0 for the same: size, price and words that their names
// do not share.
double unlikeness(const catalog::Product& a, const catalog::Product& b);

}  // namespace marketgen::shopping
