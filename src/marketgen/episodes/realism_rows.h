// The realisms that are rows, data/benchmark/realism/NAME.json.
#pragma once
#include <array>
#include <string_view>

namespace marketgen::episodes {

inline constexpr std::array<std::string_view, 5> realism_rows{
    "ideal", "standard", "hard", "crowded", "randomized"};

}  // namespace marketgen::episodes
