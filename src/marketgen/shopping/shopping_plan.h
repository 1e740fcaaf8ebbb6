// What to buy for a request in one store: market-shopping/1.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "shopping/assortment.h"
#include "shopping/request.h"

namespace marketgen::shopping {

// To be bought when the line's product has just been sold out.
struct Substitute {
  std::string sku, name;
  int count = 1;
  double price = 0;  // of one

  static constexpr auto fields =
      field_list(field("sku", &Substitute::sku, "SKU", identifier()),
                 field("name", &Substitute::name, "brand, name and variant"),
                 field("count", &Substitute::count, "packs", range(1, 100'000)),
                 field("price", &Substitute::price, "of one, in the store's money"));
};

struct ShoppingLine {
  std::string sku, name, net;
  int count = 1;
  double price = 0;                     // of one
  std::vector<std::string> answers;     // names of parts: "breakfast: eggs"; an item's words
  std::string why;                      // why this product
  std::vector<Substitute> substitutes;  // the nearest first

  static constexpr auto fields = field_list(
      field("sku", &ShoppingLine::sku, "SKU", identifier()),
      field("name", &ShoppingLine::name, "brand, name and variant"),
      field("net", &ShoppingLine::net, "net quantity as printed"),
      field("count", &ShoppingLine::count, "packs", range(1, 100'000), required()),
      field("price", &ShoppingLine::price, "of one, in the store's money"),
      field("answers", &ShoppingLine::answers, "items and foods of meals that it is for"),
      field("why", &ShoppingLine::why, "why this product"),
      field("substitutes", &ShoppingLine::substitutes, "where it is sold out, the nearest first"));
};

enum class UnmetKind { not_sold, over_budget, not_told };
constexpr std::array<std::string_view, 3> names_of(UnmetKind) {
  return {"not_sold", "over_budget", "not_told"};
}

struct UnmetPart {
  std::string part;  // an item's words, a food of a meal, a diet
  UnmetKind kind = UnmetKind::not_sold;
  std::string reason;

  static constexpr auto fields = field_list(
      field("part", &UnmetPart::part, "an item's words, a food of a meal, a diet"),
      field("kind", &UnmetPart::kind, "whether the store, the money or the rows lack it"),
      field("reason", &UnmetPart::reason, "why"));
};

// Who planned, when a language model was asked.
struct ShopperRecord {
  std::string model, kept = {}, why = {};
  int requests = 0;
  std::int64_t tokens_in = 0, tokens_out = 0;

  static constexpr auto fields =
      field_list(field("model", &ShopperRecord::model, "which language model"),
                 field("kept", &ShopperRecord::kept, "whose plan it is: model or offline"),
                 field("why", &ShopperRecord::why, "why"),
                 field("requests", &ShopperRecord::requests, "questions to the model"),
                 field("tokens_in", &ShopperRecord::tokens_in, "tokens that it read"),
                 field("tokens_out", &ShopperRecord::tokens_out, "tokens that it wrote"));
};

struct ShoppingPlan {
  std::string schema = "market-shopping/1";
  ShoppingRequest request;
  std::vector<std::string> menus;   // of each meal: "breakfast for 2: cereal with milk"
  std::vector<ShoppingLine> lines;  // each SKU once
  double total = 0;                 // of all lines
  std::string money;                // ISO 4217
  std::vector<UnmetPart> unmet;
  std::vector<std::string> left_out;  // extras for which no money is left, or that the store lacks
  std::optional<double> least;        // what would buy all of it that the store sells
  std::optional<ShopperRecord> shopper;

  static constexpr auto fields = field_list(
      field("schema", &ShoppingPlan::schema, "schema tag", constant("market-shopping/1")),
      field("request", &ShoppingPlan::request, "as it was understood"),
      field("menus", &ShoppingPlan::menus, "what is made of each meal"),
      field("lines", &ShoppingPlan::lines, "what to buy, each SKU once"),
      field("total", &ShoppingPlan::total, "of all lines, in the store's money"),
      field("money", &ShoppingPlan::money, "ISO 4217"),
      field("unmet", &ShoppingPlan::unmet, "what the plan does not do, and why"),
      field("left_out", &ShoppingPlan::left_out, "extras that it leaves out"),
      field("least",
            &ShoppingPlan::least,
            "the least sum that buys all that is sold; absent where nothing is over the budget"),
      field("shopper", &ShoppingPlan::shopper, "absent: no language model was asked"));
};

// The best plan offline: it buys all parts of the request wherever the budget allows it, otherwise
// as many as it can (budget_choice.h), and says what it does not buy and what would. Exact and
// deterministic. Errors: those of parts_of(); shopping.other_money.
Result<ShoppingPlan> plan_shopping(const ShoppingRequest& request,
                                   const Assortment& assortment,
                                   const ShoppingKnowledge& knowledge);

}  // namespace marketgen::shopping
