// The plain word for a pack's ground colour, where there is one.
#pragma once
#include <array>
#include <optional>
#include <string_view>

namespace marketgen::catalog {

// Basic colour terms (Berlin and Kay 1969) that people give to packs without doubt.
constexpr std::array<std::string_view, 10> label_color_terms{
    "white", "black", "grey", "red", "orange", "yellow", "green", "blue", "purple", "pink"};

// Of #rrggbb, by hue, lightness and saturation. Empty between two terms, where people would not
// agree, and for what is no such colour.
std::optional<std::string_view> label_color_term(std::string_view hex);

}  // namespace marketgen::catalog
