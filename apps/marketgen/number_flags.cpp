#include "number_flags.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>

namespace marketgen::app {
namespace {

template <class Number>
std::optional<Number> number_in(const std::string& text) {
  Number value{};
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failed != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

NumberCheck whole_number(std::uint64_t min, std::uint64_t max) {
  return [min, max](const std::string& text) {
    const auto value = number_in<std::uint64_t>(text);
    if (value && *value >= min && *value <= max) return std::string();
    return fmt::format("\"{}\" is not a whole number from {} to {}", text, min, max);
  };
}

NumberCheck real_number(double min, double max) {
  return [min, max](const std::string& text) {
    const auto value = number_in<double>(text);
    if (value && std::isfinite(*value) && *value >= min && *value <= max) return std::string();
    return fmt::format("\"{}\" is not a number from {:g} to {:g}", text, min, max);
  };
}

}  // namespace marketgen::app
