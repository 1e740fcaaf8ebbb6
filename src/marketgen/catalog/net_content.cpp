#include "catalog/net_content.h"

#include <charconv>
#include <cmath>
#include <utility>
#include <vector>

#include "base/text.h"
#include "base/words.h"

namespace marketgen::catalog {
namespace {

constexpr double same_share = 1e-3;

std::optional<double> number_of(std::string_view text) {
  double number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc{} || read.ptr != text.data() + text.size() || !(number > 0))
    return std::nullopt;
  return number;
}

}  // namespace

bool NetContent::is_as_much_as(const NetContent& other) const {
  return unit == other.unit && counted == other.counted &&
         std::abs(total() - other.total()) <= same_share * total();
}

std::optional<NetMeasure> net_measure(std::string_view word) {
  constexpr std::pair<std::string_view, NetMeasure> measures[] = {
      {"g", {NetUnit::gram, 1}},
      {"gram", {NetUnit::gram, 1}},
      {"kg", {NetUnit::gram, 1000}},
      {"kilo", {NetUnit::gram, 1000}},
      {"kilogram", {NetUnit::gram, 1000}},
      {"ml", {NetUnit::millilitre, 1}},
      {"millilitre", {NetUnit::millilitre, 1}},
      {"milliliter", {NetUnit::millilitre, 1}},
      {"cl", {NetUnit::millilitre, 10}},
      {"l", {NetUnit::millilitre, 1000}},
      {"litre", {NetUnit::millilitre, 1000}},
      {"liter", {NetUnit::millilitre, 1000}}};
  const std::string one = singular(lower_ascii(word));
  for (const auto& [name, measure] : measures)
    if (name == one) return measure;
  return std::nullopt;
}

std::optional<NetContent> net_content(std::string_view net) {
  std::vector<std::string> parts = split(net, ' ');
  NetContent content;
  if (parts.size() == 4 && parts[1] == "x") {
    const auto packs = number_of(parts[0]);
    if (!packs || *packs != std::floor(*packs) || *packs > 1000) return std::nullopt;
    content.packs = static_cast<int>(*packs);
    parts.erase(parts.begin(), parts.begin() + 2);
  }
  if (parts.size() != 2) return std::nullopt;
  const auto amount = number_of(parts[0]);
  if (!amount) return std::nullopt;
  content.amount = *amount;
  if (const auto measure = net_measure(parts[1])) {
    content.unit = measure->unit;
    content.amount *= measure->factor;
    return content;
  }
  content.unit = NetUnit::piece;
  content.counted = singular(lower_ascii(parts[1]));
  return content;
}

}  // namespace marketgen::catalog
