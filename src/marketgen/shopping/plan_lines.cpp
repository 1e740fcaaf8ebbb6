#include "shopping/plan_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include "catalog/country.h"
#include "catalog/full_name.h"

namespace marketgen::shopping {
namespace {

constexpr std::size_t max_substitutes = 3;

struct Bought {
  const catalog::Product* product = nullptr;
  double packs = 0;
  std::vector<ChosenAnswer> of;
};

// "Fonda Cola and 2 more are".
std::string list_of(const std::vector<const catalog::Product*>& products) {
  const std::string first = catalog::full_name(*products.front());
  return products.size() == 1 ? first + " is"
                              : fmt::format("{} and {} more are", first, products.size() - 1);
}

std::string lack_of(const Part& part) {
  if (!part.sold_out.empty())
    return fmt::format("{} sold out, and nothing else of its kind is there",
                       list_of(part.sold_out));
  if (part.refused > 0)
    return fmt::format("the store has {} of it, of which none is what the request allows",
                       part.refused);
  return part.not_sold.empty()
             ? "the store sells nothing of it"
             : fmt::format("the store sells no {} and nothing of its group", part.not_sold);
}

// Why the product for the part.
std::string reason_of(const ChosenAnswer& chosen) {
  const Part& part = *chosen.part;
  const Answer& answer = chosen.answer;
  std::string why;
  if (answer.other && !part.sold_out.empty())
    why = fmt::format("{} sold out: the nearest of its group", list_of(part.sold_out));
  else if (answer.other)
    why = fmt::format("the store has no {}: the nearest of its group", part.not_sold);
  else if (part.kind == PartKind::item)
    why = "what the words say, at the least price of the usual size";
  else
    why = "the least price of its kind";
  if (!answer.other && part.kind == PartKind::item && answer.preference == 1)
    why = "what the words say, at the least price";
  if (!answer.other && !part.sold_out.empty())
    why += fmt::format("; {} sold out", list_of(part.sold_out));
  constexpr double much_of_it = 0.75;
  if (answer.packs < much_of_it) why += fmt::format("; {:.2g} of a pack is wanted", answer.packs);
  return why;
}

// The product as an answer to all that the line is for; empty when it is none.
std::optional<Answer> instead_of(const Bought& bought, const catalog::Product& product) {
  Answer instead{.product = &product, .packs = 0};
  for (const ChosenAnswer& each : bought.of) {
    const auto answer = each.part->answer_by(product);
    if (!answer) return std::nullopt;
    instead.packs += answer->packs;
    instead.other = instead.other || answer->other;
  }
  return instead;
}

// First what answers the same words, then the nearest in size, price and name.
std::vector<Substitute> substitutes_of(const Bought& bought,
                                       const std::vector<const catalog::Product*>& allowed) {
  std::vector<Answer> near;
  for (const catalog::Product* product : allowed) {
    if (product == bought.product) continue;
    auto instead = instead_of(bought, *product);
    if (!instead) continue;
    const bool same_group = group_of(*product) == group_of(*bought.product);
    instead->distance = unlikeness(*bought.product, *product);
    instead->preference = (instead->other ? 2 : 0) + (same_group ? 0 : 1);
    near.push_back(*instead);
  }
  std::ranges::sort(near, {}, [](const Answer& answer) {
    return std::tuple(answer.preference, answer.distance, answer.product->sku);
  });
  std::vector<Substitute> substitutes;
  for (const Answer& answer : near) {
    if (substitutes.size() == max_substitutes) break;
    substitutes.push_back({answer.product->sku,
                           catalog::full_name(*answer.product),
                           answer.count(),
                           answer.product->price});
  }
  return substitutes;
}

std::vector<Bought> bought_of(const std::vector<ChosenAnswer>& chosen) {
  std::vector<Bought> all;
  for (const ChosenAnswer& each : chosen) {
    auto found = std::ranges::find(all, each.answer.product, &Bought::product);
    if (found == all.end()) found = all.insert(all.end(), Bought{each.answer.product, 0, {}});
    found->packs += each.answer.packs;
    found->of.push_back(each);
  }
  return all;
}

ShoppingLine line_of(const Bought& bought, const std::vector<const catalog::Product*>& allowed) {
  ShoppingLine line;
  line.sku = bought.product->sku;
  line.name = catalog::full_name(*bought.product);
  line.net = bought.product->net;
  line.count = Answer{.product = bought.product, .packs = bought.packs}.count();
  line.price = bought.product->price;
  for (const ChosenAnswer& each : bought.of)
    line.answers.push_back(each.part->name);
  line.why = reason_of(bought.of.front());
  line.substitutes = substitutes_of(bought, allowed);
  return line;
}

}  // namespace

std::int64_t coins_of(const std::vector<ChosenAnswer>& chosen) {
  std::int64_t coins = 0;
  for (const Bought& bought : bought_of(chosen))
    coins += Answer{.product = bought.product, .packs = bought.packs}.coins();
  return coins;
}

std::vector<ShoppingLine> lines_of(const std::vector<ChosenAnswer>& chosen,
                                   const std::vector<const catalog::Product*>& allowed) {
  std::vector<ShoppingLine> lines;
  for (const Bought& bought : bought_of(chosen))
    lines.push_back(line_of(bought, allowed));
  return lines;
}

ShoppingPlan empty_plan(const ShoppingRequest& request,
                        const Assortment& assortment,
                        const ShoppingKnowledge& knowledge) {
  ShoppingPlan plan;
  plan.request = request;
  plan.money = country_of(assortment).currency;
  for (const std::string& id : request.diets)
    if (const Diet* diet = knowledge.table().diet(id))
      plan.unmet.push_back({id, UnmetKind::not_told, diet->caution});
  for (const std::string& word : request.without)
    plan.unmet.push_back({"no " + word,
                          UnmetKind::not_told,
                          "rows name no ingredients: left out is what says it by name"});
  return plan;
}

std::string menu_text(const MealWish& wish, std::string_view menu) {
  return fmt::format("{} for {}: {}", wish.meal, wish.persons, menu);
}

UnmetPart unmet_part(const Part& part, double least, const Assortment& assortment) {
  if (part.answers.empty()) return {part.name, UnmetKind::not_sold, lack_of(part)};
  const auto cheapest = std::ranges::min_element(part.answers, {}, &Answer::coins);
  const catalog::Country& country = catalog::country_of(*cheapest->product);
  return {part.name,
          UnmetKind::over_budget,
          fmt::format("the least that would do costs {}; all that is asked for costs at least {}",
                      catalog::price_text(price_of(cheapest->coins(), assortment), country),
                      catalog::price_text(least, country))};
}

}  // namespace marketgen::shopping
