#include "shopping/item_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "base/words.h"
#include "catalog/net_content.h"
#include "perception/said_amounts.h"

namespace marketgen::shopping {
namespace {

constexpr double max_count = 999;
constexpr double rounding = 1e-9;
constexpr double named_distance = 0.1;

std::string all_of(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words)
    text += (text.empty() ? "" : " ") + word;
  return text;
}

// The food of which the item means any: "bread". None for one that says more: "rye bread".
const Food* food_named(const std::vector<std::string>& said, const MealTable& table) {
  const std::string words = spaced_words(all_of(said));
  for (const Food& food : table.foods)
    for (const std::string& name : food.say)
      if (spaced_words(name) == words) return &food;
  return nullptr;
}

// Whether the row has all words of the item.
bool says_all(const ItemReading& item, const catalog::Product& product) {
  std::string row = product.name + " " + product.variant + " " + product.brand;
  for (const std::string& keyword : product.keywords)
    row += " " + keyword;
  const std::string words = spaced_words(row);
  return std::ranges::all_of(item.said,
                             [&](const std::string& word) { return has_words(words, word); });
}

// Whether the item's words are the whole name of the product, which is of the same category.
bool is_named(const ItemReading& item, const catalog::Product& product) {
  std::vector<std::string> name = perception::plain_words(product.name);
  std::ranges::sort(name);
  return name == item.said && product.category == item.wanted.front()->category;
}

// How far the product is from what is meant; 0 for what is meant itself.
double distance_to(const ItemReading& item, const catalog::Product& product) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const catalog::Product* wanted : item.wanted)
    if (group_of(*wanted) == group_of(product))
      nearest = std::min(nearest, wanted->sku == product.sku ? 0 : unlikeness(*wanted, product));
  return nearest;
}

// "500 g of pasta" is half of a pack of a kilo; "12 eggs" are two packs of ten.
double packs_of(const ItemReading& item, const catalog::Product& product) {
  if (item.amount && item.amount->unit != catalog::NetUnit::piece)
    return item.count * item.amount->total() / content_of(product);
  const auto net = catalog::net_content(product.net);
  if (!net || net->unit != catalog::NetUnit::piece || !item.count_said) return item.count;
  const bool pieces = (net->counted == "piece" && !item.container_said) ||
                      std::ranges::find(item.said, net->counted) != item.said.end();
  return pieces ? item.count / net->total() : item.count;
}

bool is_usual_size(double content, double median) {
  constexpr double factor = 1.6;
  return content <= median * factor && content * factor >= median;
}

double median_content(const std::vector<Answer>& answers) {
  std::vector<double> contents;
  for (const Answer& answer : answers)
    contents.push_back(content_of(*answer.product));
  std::ranges::sort(contents);
  return contents[contents.size() / 2];
}

bool cheaper(const Answer& a, const Answer& b) {
  return std::pair(a.coins(), a.product->sku) < std::pair(b.coins(), b.product->sku);
}

}  // namespace

int Answer::count() const {
  return std::max(1, static_cast<int>(std::ceil(packs - rounding)));
}

std::int64_t Answer::coins() const {
  return count() * coins_of(*product);
}

double unlikeness(const catalog::Product& a, const catalog::Product& b) {
  constexpr double words_weight = 1.5;  // as much as content or price by a factor of 4.5
  const auto words_in = [](const catalog::Product& product) {
    std::set<std::string> words;
    for (const std::string& word : perception::plain_words(product.name + " " + product.variant))
      words.insert(word);
    return words;
  };
  const std::set<std::string> of_a = words_in(a), of_b = words_in(b);
  const auto shared =
      std::ranges::count_if(of_a, [&](const std::string& word) { return of_b.contains(word); });
  const double all = static_cast<double>(std::max<std::size_t>(1, of_a.size() + of_b.size()));
  return std::abs(std::log(content_of(a) / content_of(b))) + std::abs(std::log(a.price / b.price)) +
         words_weight * (1 - 2 * static_cast<double>(shared) / all);
}

Result<ItemReading> read_item(const std::string& words, const ShoppingKnowledge& knowledge) {
  ItemReading item{.words = words};
  const perception::SaidWords said = perception::said_words(words, {});
  item.count_said = said.count.has_value();
  item.count = std::min(said.count.value_or(1), max_count);
  if (!said.amounts.empty()) item.amount = said.amounts.front();
  std::vector<std::string> in_order;
  for (const std::string& word : said.words) {
    item.container_said = item.container_said || knowledge.is_container(word);
    if (!knowledge.is_container(word) && !knowledge.is_filler(word)) in_order.push_back(word);
  }
  MARKETGEN_TRY(const std::vector<std::string> skus, knowledge.reader().read(words));
  item.food = food_named(in_order, knowledge.table());
  for (const catalog::Product& product : knowledge.catalog().products) {
    const bool read = std::ranges::find(skus, product.sku) != skus.end();
    if (item.food != nullptr ? option_of(*item.food, product) == 0 : read)
      item.wanted.push_back(&product);
  }
  if (item.wanted.empty())
    return Error{"shopping.not_understood",
                 fmt::format("\"{}\"", words),
                 "it names no product; say what it is called"};
  item.said = std::move(in_order);
  std::ranges::sort(item.said);
  return item;
}

Result<std::vector<ItemReading>> read_items(const std::vector<std::string>& list,
                                            const ShoppingKnowledge& knowledge) {
  std::vector<ItemReading> readings;
  for (const std::string& words : list) {
    MARKETGEN_TRY(ItemReading item, read_item(words, knowledge));
    readings.push_back(std::move(item));
  }
  return readings;
}

std::optional<Answer> answer_of(const ItemReading& item, const catalog::Product& product) {
  Answer answer{.product = &product, .packs = packs_of(item, product)};
  if (item.food != nullptr) {
    const int option = option_of(*item.food, product);
    if (option < 0) return std::nullopt;
    answer.distance = option;
    return answer;
  }
  answer.distance = distance_to(item, product);
  if (!std::isfinite(answer.distance) && is_named(item, product))
    answer.distance = named_distance;  // "onions": loose ones, too
  if (!std::isfinite(answer.distance)) return std::nullopt;
  answer.other = answer.distance > 0 && !says_all(item, product);
  return answer;
}

bool is_food(const ItemReading& item, const Food& food) {
  if (item.food == &food) return true;
  return std::ranges::any_of(
      item.wanted, [&](const catalog::Product* product) { return option_of(food, *product) >= 0; });
}

bool is_among(const ItemReading& item, const std::vector<ItemReading>& others) {
  return std::ranges::any_of(others, [&](const ItemReading& other) {
    return item.said == other.said || (item.food != nullptr && item.food == other.food);
  });
}

std::vector<Answer> worth_a_thought(std::vector<Answer> answers, std::size_t breadth) {
  if (answers.empty()) return answers;
  const bool any_said =
      std::ranges::any_of(answers, [](const Answer& answer) { return !answer.other; });
  std::ranges::sort(answers, {}, [](const Answer& answer) {
    return std::pair(answer.distance, answer.product->sku);
  });
  if (!any_said) {
    constexpr std::size_t max_others = 5;
    const Answer cheapest = *std::ranges::min_element(answers, cheaper);
    if (answers.size() > max_others) answers.resize(max_others);
    for (std::size_t i = 0; i < answers.size(); ++i)
      answers[i].preference = max_preference - 1 - static_cast<int>(i);
    if (std::ranges::find(answers, cheapest.product, &Answer::product) == answers.end())
      answers.push_back(cheapest);
    return answers;
  }
  std::erase_if(answers, [](const Answer& answer) { return answer.other; });
  if (breadth > 1) {
    if (answers.size() > 4 * breadth) answers.resize(4 * breadth);
    return answers;
  }
  const double nearest = answers.front().distance;
  const auto cheapest = std::ranges::min_element(answers, cheaper);
  std::vector<Answer> usual;
  for (const Answer& answer : answers)
    if (answer.distance == nearest) usual.push_back(answer);
  const double median = median_content(usual);
  std::erase_if(usual, [&](const Answer& answer) {
    return !is_usual_size(content_of(*answer.product), median);
  });
  Answer best = *std::ranges::min_element(usual, cheaper);
  best.preference = max_preference - 1;
  std::vector<Answer> chosen{best};
  if (cheapest->product != best.product) {
    chosen.push_back(*cheapest);
    chosen.back().preference = 1;
  }
  return chosen;
}

}  // namespace marketgen::shopping
