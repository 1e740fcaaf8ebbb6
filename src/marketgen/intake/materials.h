// From "oak", "white tiles" or "dark" to a material row.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "catalog/catalog.h"

namespace marketgen::intake {

// Words that describe a surface, as the lexicon's material and color rows give them.
struct SurfaceWords {
  std::vector<std::string> materials;  // each a list of names that mean it: "wood oak plank"
  std::vector<std::string> colors;     // colour names
};

// The row that is used for `part` (floor wall ceiling fixture) and fits the words best; null when
// none has the material or, for colours alone, none has the colour.
const catalog::MaterialRow* material_for(const catalog::Catalog& catalog,
                                         std::string_view part,
                                         const SurfaceWords& words,
                                         std::string_view color_hex);

// Colours nearer than this go by the same name; about a fifth of the way from black to white.
constexpr double same_color = 90;

// Distance of two #rrggbb colours, 0..441.
double color_distance(std::string_view a, std::string_view b);

}  // namespace marketgen::intake
