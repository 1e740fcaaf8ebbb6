// What is said of a product, attribute by attribute, and which products it fits: the evaluator that
// decides whether words name exactly one of what is on offer.
//
// It takes words as widely as a hearer may: "cola" fits whatever has the word in its name, variety,
// keywords or group; a saying of episodes/said_otherwise.inc fits all that one of its lines means;
// a container's noun every shape that is called so; a colour every pack that no other colour's word
// names clearly. What is unique so is unique to whoever takes it more narrowly.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "catalog/net_content.h"
#include "catalog/product.h"

namespace marketgen::episodes {

enum class Attribute { name, variant, brand, size, container, category, color };
constexpr std::array<std::string_view, 7> names_of(Attribute) {
  return {"name", "variant", "brand", "size", "container", "category", "color"};
}

// `value` as it is said, but for a size, which is the row's net content, and a category, its id.
struct ToldAttribute {
  Attribute attribute = Attribute::name;
  std::string value;
  bool operator==(const ToldAttribute&) const = default;
};

// Sayings for the value of a row, without that itself.
std::vector<std::string_view> said_otherwise(Attribute attribute, std::string_view value);

// Products on offer. Immutable; any number of threads may ask.
class Offer {
 public:
  explicit Offer(std::vector<catalog::Product> rows);
  std::size_t size() const { return rows_.size(); }
  const catalog::Product& row(std::size_t number) const { return rows_[number]; }
  // Its number, or size() when it is not on offer.
  std::size_t number_of(std::string_view sku) const;
  bool fits(std::size_t number, const ToldAttribute& told) const;
  // Those that all of it fits, ascending.
  std::vector<std::size_t> fitting(const std::vector<ToldAttribute>& told) const;

 private:
  struct Words {
    std::string named, variant;  // spaced_words of name, variant, group and keywords; of the rest
    std::optional<catalog::NetContent> net;
    std::optional<std::string_view> color;
  };
  std::vector<catalog::Product> rows_;
  std::vector<Words> words_;
};

}  // namespace marketgen::episodes
