// The realisms that are rows, data/benchmark/realism/NAME.json.
#pragma once
#include <array>
#include <string_view>

namespace marketgen::episodes {

inline constexpr std::array<std::string_view, 4> realism_rows{
    "ideal", "standard", "hard", "randomized"};

}  // namespace marketgen::episodes
