#include <cmath>

#include "intake/brief.h"
#include "intake/store_size.h"
#include "intake/tokens.h"

namespace marketgen::intake {
namespace {

struct UnitName {
  std::string_view name;
  double mm;
};
constexpr UnitName units[] = {{"m", 1000},
                              {"metre", 1000},
                              {"meter", 1000},
                              {"cm", 10},
                              {"mm", 1},
                              {"ft", 304.8},
                              {"foot", 304.8},
                              {"feet", 304.8},
                              {"yard", 914.4},
                              {"yd", 914.4}};

double unit_mm(const Token& token) {
  for (const UnitName& unit : units) {
    if (token.stem == unit.name) return unit.mm;
  }
  return 0;
}

struct Side {
  double number = 0;
  double unit = 0;  // mm; 0 = not said
};

// "24", "24 m": moves `at` past what it read.
std::optional<Side> read_side(const std::vector<Token>& tokens, std::size_t& at) {
  if (at >= tokens.size() || tokens[at].kind != TokenKind::number) return std::nullopt;
  Side side{tokens[at++].number, 0};
  if (at < tokens.size()) side.unit = unit_mm(tokens[at]);
  if (side.unit > 0) ++at;
  return side;
}

bool is_times(const std::vector<Token>& tokens, std::size_t at) {
  return at < tokens.size() &&
         (tokens[at].text == "x" || tokens[at].text == "by" || tokens[at].text == "*");
}

std::optional<std::array<Side, 2>> read_sides(std::string_view text) {
  const std::vector<Token> tokens = tokenize(text);
  std::size_t at = 0;
  const auto width = read_side(tokens, at);
  if (!width || !is_times(tokens, at)) return std::nullopt;
  ++at;
  const auto depth = read_side(tokens, at);
  if (!depth || at != tokens.size()) return std::nullopt;
  return {{*width, *depth}};
}

}  // namespace

Result<void> check_store_size(double width_mm, double depth_mm, const std::string& where) {
  const auto buildable = [](double side) {
    return side >= min_store_side_mm && side <= max_store_side_mm;
  };
  if (buildable(width_mm) && buildable(depth_mm)) return {};
  return Error{"brief.bad_size",
               where,
               "a store is 4 to 200 m wide and deep, not " + metres(width_mm) + " x " +
                   metres(depth_mm) + " m"};
}

std::string metres(double mm) {
  const double rounded = std::round(mm / 100) / 10;  // one decimal
  std::string text = std::to_string(rounded);
  while (text.ends_with('0'))
    text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text;
}

Result<std::array<int, 2>> parse_size(std::string_view text, const std::string& where) {
  const auto sides = read_sides(text);
  if (!sides) {
    return Error{"brief.bad_size",
                 where,
                 "\"" + std::string(text.substr(0, 80)) +
                     "\" is not a size; write width x depth, as in 24x15m or 80x50ft"};
  }
  const auto [width, depth] = *sides;
  constexpr double metre_mm = 1000;
  const double fallback = depth.unit > 0 ? depth.unit : (width.unit > 0 ? width.unit : metre_mm);
  const double width_mm = width.number * (width.unit > 0 ? width.unit : fallback);
  const double depth_mm = depth.number * (depth.unit > 0 ? depth.unit : fallback);
  MARKETGEN_CHECK(check_store_size(width_mm, depth_mm, where));
  return std::array<int, 2>{static_cast<int>(std::lround(width_mm)),
                            static_cast<int>(std::lround(depth_mm))};
}

}  // namespace marketgen::intake
