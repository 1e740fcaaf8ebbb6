#include "episodes/told_attribute.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.h"
#include "base/words.h"
#include "catalog/container_nouns.h"
#include "catalog/label_color.h"

namespace marketgen::episodes {
namespace {

struct Saying {
  Attribute attribute;
  std::string_view value, said;
};

constexpr Saying sayings[] = {
#define SAID_OTHERWISE(attribute, value, said) {Attribute::attribute, value, said},
#include "episodes/said_otherwise.inc"
#undef SAID_OTHERWISE
};

// Whether each word of the saying is among the row's.
bool has_all_words(const std::string& row_words, const std::string& said) {
  for (const std::string& word : split(trimmed(said), ' '))
    if (row_words.find(" " + word + " ") == std::string::npos) return false;
  return true;
}

// A saying for another value of the row.
bool means(Attribute attribute, std::string_view said, std::string_view value) {
  return std::ranges::any_of(sayings, [&](const Saying& saying) {
    return saying.attribute == attribute && saying.said == said && saying.value == value;
  });
}

}  // namespace

std::vector<std::string_view> said_otherwise(Attribute attribute, std::string_view value) {
  std::vector<std::string_view> said;
  for (const Saying& saying : sayings)
    if (saying.attribute == attribute && saying.value == value) said.push_back(saying.said);
  return said;
}

Offer::Offer(std::vector<catalog::Product> rows) : rows_(std::move(rows)) {
  for (const catalog::Product& row : rows_) {
    const std::string keywords = fmt::format("{}", fmt::join(row.keywords, " "));
    const std::string named =
        fmt::format("{} {} {} {}", row.name, row.variant, row.subcategory, keywords);
    const std::string varied = fmt::format("{} {} {}", row.variant, row.name, keywords);
    words_.push_back({spaced_words(named),
                      spaced_words(varied),
                      catalog::net_content(row.net),
                      catalog::label_color_term(row.label.primary)});
  }
}

std::size_t Offer::number_of(std::string_view sku) const {
  return static_cast<std::size_t>(std::ranges::find(rows_, sku, &catalog::Product::sku) -
                                  rows_.begin());
}

bool Offer::fits(std::size_t number, const ToldAttribute& told) const {
  const catalog::Product& row = rows_[number];
  const Words& words = words_[number];
  switch (told.attribute) {
    case Attribute::name:
      return means(told.attribute, told.value, row.name) ||
             has_all_words(words.named, spaced_words(told.value));
    case Attribute::variant:
      return means(told.attribute, told.value, row.variant) ||
             has_all_words(words.variant, spaced_words(told.value));
    case Attribute::brand:
      return row.brand == told.value;
    case Attribute::size: {
      const auto said = catalog::net_content(told.value);
      return said && words.net && words.net->is_as_much_as(*said);
    }
    case Attribute::container: {
      const auto said = catalog::container_nouns(row.archetype);
      return std::ranges::find(said, told.value, &catalog::ContainerNoun::noun) != said.end();
    }
    case Attribute::category:
      return row.category == told.value;
    case Attribute::color:
      return !words.color || *words.color == told.value;
  }
  return false;
}

std::vector<std::size_t> Offer::fitting(const std::vector<ToldAttribute>& told) const {
  std::vector<std::size_t> found;
  for (std::size_t number = 0; number < rows_.size(); ++number)
    if (std::ranges::all_of(told, [&](const ToldAttribute& each) { return fits(number, each); }))
      found.push_back(number);
  return found;
}

}  // namespace marketgen::episodes
