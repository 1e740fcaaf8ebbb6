// How much of a product is in a pack, as its row prints it and as people say it.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace marketgen::catalog {

enum class NetUnit { gram, millilitre, piece };
constexpr std::array<std::string_view, 3> names_of(NetUnit) {
  return {"gram", "millilitre", "piece"};
}

struct NetContent {
  int packs = 1;      // of "6 x 25 g": 6
  double amount = 0;  // of one of them, in `unit`
  NetUnit unit = NetUnit::gram;
  std::string counted = {};  // of pieces, what is counted, singular: "roll"

  double total() const { return packs * amount; }
  // As much in all, of the same: "0.5 l" and "500 ml", "2 x 250 g" and "500 g".
  bool is_as_much_as(const NetContent& other) const;
};

// A word for a measure of mass or volume, singular or plural: "l", "litres", "kilo".
struct NetMeasure {
  NetUnit unit = NetUnit::gram;
  double factor = 1;  // grams or millilitres
};
std::optional<NetMeasure> net_measure(std::string_view word);

// Of a row's `net`: "330 ml", "6 x 1.5 l", "20 bags". Empty for what is no amount ("each",
// "bunch").
std::optional<NetContent> net_content(std::string_view net);

}  // namespace marketgen::catalog
