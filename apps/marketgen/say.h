// What commands print for people.
#pragma once
#include <fmt/format.h>

#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "base/safe_line.h"

namespace marketgen::app {

// A text among what is printed: of a file, a flag, a server.
inline std::string shown(std::string_view text) {
  constexpr std::size_t longest = 300;
  return safe_line(text, longest);
}
template <class Value>
auto shown_or_itself(const Value& value) {
  if constexpr (std::is_convertible_v<const Value&, std::string_view>)
    return shown(value);
  else if constexpr (std::is_arithmetic_v<Value>)
    return value;
  else
    return shown(fmt::vformat("{}", fmt::make_format_args(value)));  // joined texts
}

// To standard output. Every text among the arguments passes through safe_line(): whatever a
// catalogue or a plan holds, a line is a line and nothing moves the cursor. JSON is printed by
// fmt::print(): it escapes by itself.
template <class... Args>
void say(fmt::format_string<Args...> format, Args&&... args) {
  std::apply(
      [&](const auto&... words) {
        fmt::print("{}", fmt::vformat(fmt::string_view(format), fmt::make_format_args(words...)));
      },
      std::make_tuple(shown_or_itself(args)...));
}

}  // namespace marketgen::app
