// The difficulties that are rows, data/benchmark/difficulty/NAME.json.
#pragma once
#include <array>
#include <string_view>

namespace marketgen::episodes {

inline constexpr std::array<std::string_view, 3> difficulty_rows{"easy", "standard", "hard"};

}  // namespace marketgen::episodes
