#include "episodes/referring_expression.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.h"
#include "catalog/container_nouns.h"
#include "catalog/label_color.h"

namespace marketgen::episodes {
namespace {

constexpr double otherwise_chance = 0.5;  // of a saying where the row's value has one
constexpr double more_chance = 0.25;      // of an attribute that is not needed
constexpr std::array<std::string_view, 11> number_words{
    "none", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten"};

using Told = std::vector<ToldAttribute>;

template <class T>
const T& any_of(const std::vector<T>& choices, Stream& draw) {
  return choices[static_cast<std::size_t>(draw.integer(0, static_cast<int>(choices.size()) - 1))];
}

std::string number_word(int number) {
  return number < static_cast<int>(number_words.size())
             ? std::string(number_words[static_cast<std::size_t>(number)])
             : std::to_string(number);
}

// "Fresh Milk" as in the middle of a sentence; "WC Gel" keeps its capitals.
std::string spoken(std::string_view text) {
  std::vector<std::string> words = split(text, ' ');
  for (std::string& word : words) {
    const auto capitals = std::ranges::count_if(
        word, [](char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; });
    if (capitals == 1) word = lower_ascii(word);
  }
  return fmt::format("{}", fmt::join(words, " "));
}

// ---- What may be said of a product. ----

std::optional<std::string> worded(Attribute attribute,
                                  const std::string& value,
                                  bool otherwise,
                                  Stream& draw) {
  if (value.empty()) return std::nullopt;
  const std::vector<std::string_view> others = said_otherwise(attribute, value);
  if (otherwise && !others.empty() && draw.chance(otherwise_chance))
    return std::string(any_of(others, draw));
  return value;
}

// Each attribute that the row has, in the words that are used if it is said. `otherwise`: they may
// be others than the row's.
Told sayable(const catalog::Product& row, bool otherwise, Stream& draw) {
  Told told{{Attribute::name, *worded(Attribute::name, row.name, otherwise, draw)}};
  if (auto variant = worded(Attribute::variant, row.variant, otherwise, draw))
    told.push_back({Attribute::variant, std::move(*variant)});
  if (!row.brand.empty()) told.push_back({Attribute::brand, row.brand});
  const auto net = catalog::net_content(row.net);
  if (net && !(net->unit == catalog::NetUnit::piece && net->total() == 1))
    told.push_back({Attribute::size, row.net});
  if (const auto containers = catalog::container_nouns(row.archetype); !containers.empty())
    told.push_back({Attribute::container, std::string(any_of(containers, draw).noun)});
  if (const auto color = catalog::label_color_term(row.label.primary))
    told.push_back({Attribute::color, std::string(*color)});
  told.push_back({Attribute::category, row.category});
  return told;
}

// The name and, of `others` in their order, what rules something out; then what could be left out
// again is. Empty when that fits more than one.
Told distinguishing(const Offer& offer, const ToldAttribute& name, const Told& others) {
  Told told{name};
  std::size_t left = offer.fitting(told).size();
  for (const ToldAttribute& each : others) {
    if (left == 1) break;
    told.push_back(each);
    const std::size_t now = offer.fitting(told).size();
    if (now == left) told.pop_back();
    left = now;
  }
  if (left != 1) return {};
  for (std::size_t i = 1; i < told.size();) {
    Told fewer = told;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    if (offer.fitting(fewer).size() == 1)
      told = std::move(fewer);
    else
      ++i;
  }
  return told;
}

// ---- As a phrase. ----

std::string trimmed_number(double number) {
  return fmt::format("{:.6g}", number);
}

std::vector<std::string> worded_measures(double amount,
                                         std::string_view small,
                                         std::string_view small_word,
                                         std::string_view large,
                                         std::string_view large_word) {
  std::vector<std::string> said;
  const std::string large_number = trimmed_number(amount / 1000);
  if (amount < 1000 || std::fmod(amount, 100) == 0) {
    said.push_back(fmt::format("{} {}", trimmed_number(amount), small));
    said.push_back(fmt::format("{} {}s", trimmed_number(amount), small_word));
  }
  if (amount >= 1000 || std::fmod(amount, 250) == 0)
    said.push_back(fmt::format("{} {}", large_number, large));
  if (amount >= 1000) {
    said.push_back(fmt::format("{} {}{}", large_number, large_word, amount == 1000 ? "" : "s"));
  }
  if (amount == 500) said.push_back(fmt::format("half a {}", large_word));
  if (amount == 1000) said.push_back(fmt::format("one {}", large_word));
  if (amount == 2000) said.push_back(fmt::format("two {}s", large_word));
  return said;
}

// "500 ml", "half a litre", "0.5 l", "six of 330 ml", "twenty bags".
std::string worded_size(const std::string& net, Stream& draw) {
  const catalog::NetContent content = *catalog::net_content(net);
  if (content.unit == catalog::NetUnit::piece) {
    const int pieces = static_cast<int>(content.amount);
    if (content.packs != 1 || pieces != content.amount || pieces > 10 || draw.chance(0.5))
      return net;
    return number_word(pieces) + net.substr(net.find(' '));
  }
  const bool liquid = content.unit == catalog::NetUnit::millilitre;
  std::string one =
      any_of(liquid ? worded_measures(content.amount, "ml", "millilitre", "l", "litre")
                    : worded_measures(content.amount, "g", "gram", "kg", "kilo"),
             draw);
  if (content.packs == 1) return one;
  const std::vector<std::string> packed{
      fmt::format("{} x {}", content.packs, one),
      fmt::format("{} times {}", number_word(content.packs), one)};
  return any_of(packed, draw);
}

const std::string* said(const Told& told, Attribute attribute) {
  const auto found = std::ranges::find(told, attribute, &ToldAttribute::attribute);
  return found == told.end() ? nullptr : &found->value;
}

bool is_number(std::string_view text) {
  return std::ranges::all_of(
      text, [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; });
}

// Before the name ("low-fat milk") or after it ("milk, low-fat").
void add_variant(const std::string& variant,
                 Stream& draw,
                 std::string& before,
                 std::string& after) {
  const std::string words = spoken(variant);
  const bool hangs = words.starts_with("with") || words.starts_with("in ") ||
                     words.starts_with("for ") || words.starts_with("from ");
  if (is_number(variant))
    after += fmt::format(" in a pack of {}", variant);
  else if (hangs)
    after += " " + words;
  else if (variant.find(',') == std::string::npos && draw.chance(0.4))
    before += words + " ";
  else
    after +=
        draw.chance(0.5) ? fmt::format(", {}", words) : fmt::format(" in the variety {}", words);
}

void add_brand(const std::string& brand, Stream& draw, std::string& before, std::string& after) {
  const std::vector<std::string> behind{" by {}", " from {}", " of the brand {}"};
  if (draw.chance(0.4))
    before = brand + " " + before;
  else
    after += fmt::format(fmt::runtime(any_of(behind, draw)), brand);
}

// "the" and the container, or what stands in their place: "the red carton of", "two cans of".
std::string opening(const Told& told,
                    const catalog::Product& row,
                    int count,
                    std::string_view color) {
  const std::string* const container = said(told, Attribute::container);
  if (container == nullptr)
    return count == 1 ? fmt::format("the {}", color)
                      : fmt::format("{} of the {}", number_word(count), color);
  const auto nouns = catalog::container_nouns(row.archetype);
  const auto noun = std::ranges::find(nouns, *container, &catalog::ContainerNoun::noun);
  return count == 1 ? fmt::format("the {}{} of ", color, noun->noun)
                    : fmt::format("{} {}{} of ", number_word(count), color, noun->plural);
}

std::string phrase_of(const Told& told, const catalog::Product& row, int count, Stream& draw) {
  std::string before, after, color;
  if (const std::string* const variant = said(told, Attribute::variant))
    add_variant(*variant, draw, before, after);
  if (const std::string* const brand = said(told, Attribute::brand))
    add_brand(*brand, draw, before, after);
  if (const std::string* const term = said(told, Attribute::color)) {
    if (said(told, Attribute::container) != nullptr && draw.chance(0.5))
      color = *term + " ";
    else
      after += fmt::format(" with the {} label", *term);
  }
  if (const std::string* const category = said(told, Attribute::category)) {
    std::string words = *category;
    std::ranges::replace(words, '_', ' ');
    after += fmt::format(" from the {} section", words);
  }
  if (const std::string* const net = said(told, Attribute::size))
    after += fmt::format(", {}", worded_size(*net, draw));
  return opening(told, row, count, color) + before + spoken(*said(told, Attribute::name)) + after;
}

}  // namespace

std::optional<ReferringExpression> refer_to(const Offer& offer,
                                            std::size_t number,
                                            int count,
                                            Seed seed) {
  Stream draw = seed.stream();
  for (const bool otherwise : {true, false}) {
    Told all = sayable(offer.row(number), otherwise, draw);
    const ToldAttribute name = all.front();
    all.erase(all.begin());
    draw.shuffle(std::span(all));
    Told told = distinguishing(offer, name, all);
    if (told.empty()) continue;
    for (const ToldAttribute& each : all)
      if (std::ranges::find(told, each) == told.end() && draw.chance(more_chance))
        told.push_back(each);
    return ReferringExpression{phrase_of(told, offer.row(number), count, draw), std::move(told)};
  }
  return std::nullopt;
}

std::string instruction_of(InstructionVerb verb,
                           Instructions instructions,
                           const std::vector<std::string>& goals,
                           Seed seed) {
  Stream draw = seed.stream();
  const std::string all = fmt::format("{}", fmt::join(goals, "; "));
  const std::vector<std::string> unload{
      "Put these from the basket on the unloading area: {}.",
      "Please take these out of the basket and put them on the unloading area: {}.",
      "Unload these for me: {}."};
  const std::vector<std::string> collect{"Collect these into your basket: {}.",
                                         "Please fetch these from the shelves: {}.",
                                         "I need these in your basket: {}."};
  const std::vector<std::string>& sentences = verb == InstructionVerb::unload ? unload : collect;
  const bool varied = instructions == Instructions::words;
  return fmt::format(fmt::runtime(varied ? any_of(sentences, draw) : sentences.front()), all);
}

}  // namespace marketgen::episodes
