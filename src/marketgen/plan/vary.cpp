#include "plan/vary.h"

#include <charconv>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.h"

namespace marketgen::plan {
namespace {

using VariedSeed = std::optional<std::uint64_t> Vary::*;

struct NamedAxis {
  std::string_view name;
  VariedSeed seed;
};
constexpr std::array<NamedAxis, 5> named_axes{{{"layout", &Vary::layout},
                                               {"planogram", &Vary::planogram},
                                               {"fill", &Vary::fill},
                                               {"disorder", &Vary::disorder},
                                               {"prices", &Vary::prices}}};

}  // namespace

std::vector<std::string_view> vary_axes() {
  std::vector<std::string_view> names;
  for (const NamedAxis& axis : named_axes)
    names.push_back(axis.name);
  return names;
}

Result<void> add_vary(Vary& vary,
                      std::string_view text,
                      std::string code,
                      const std::string& where) {
  const std::size_t equals = std::min(text.find('='), text.size());
  const std::string_view name = text.substr(0, equals);
  const std::string_view number = text.substr(std::min(text.size(), equals + 1));
  for (const NamedAxis& axis : named_axes) {
    if (axis.name != name) continue;
    std::uint64_t seed = 0;
    const auto [end, fault] = std::from_chars(number.begin(), number.end(), seed);
    if (number.empty() || fault != std::errc{} || end != number.end())
      return Error{std::move(code),
                   where,
                   fmt::format("\"{}\" gives {} no seed; write a whole number from 0 to 2^64 - 1, "
                               "as in \"{}=3\"",
                               text,
                               name,
                               name)};
    if (vary.*axis.seed)
      return Error{std::move(code), where, fmt::format("{} is given twice", name)};
    vary.*axis.seed = seed;
    return {};
  }
  const std::vector<std::string_view> names = vary_axes();
  return Error{std::move(code),
               where,
               fmt::format("there is no axis \"{}\"; there are: {}{}",
                           name,
                           fmt::join(names, ", "),
                           did_you_mean(name, names))};
}

Vary with_vary(Vary vary, const Vary& over) {
  for (const NamedAxis& axis : named_axes)
    if (over.*axis.seed) vary.*axis.seed = over.*axis.seed;
  return vary;
}

Seed axis_seed(const std::optional<Vary>& vary,
               VariedSeed axis,
               Seed own,
               std::string_view stream) {
  const std::optional<std::uint64_t> seed = vary ? *vary.*axis : std::nullopt;
  return seed ? Seed(*seed).child(stream) : own;
}

}  // namespace marketgen::plan
