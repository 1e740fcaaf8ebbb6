// What kind of thing a pixel shows.
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

namespace marketgen::render {

// What light meets first on its way from the eye: the pane counts, not what is behind it.
// metal: bare, so that it mirrors; clear: a clear pack with what it holds, as bottles of PET.
enum class Matter : std::uint8_t { none, solid, glass, metal, clear };
constexpr std::array<std::string_view, 5> names_of(Matter) {
  return {"none", "solid", "glass", "metal", "clear"};
}

}  // namespace marketgen::render
