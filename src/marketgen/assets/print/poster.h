// Posters for walls and the ends of shelves: one large motif, a headline, a line below.
#pragma once
#include <string_view>
#include <vector>

#include "base/result.h"
#include "geometry/image.h"

namespace marketgen::assets {

struct Poster {
  std::string_view zone_type;  // whose goods it praises; empty: any
  std::string_view motif, headline, line;
};

// Every poster, in the order of posters.inc.
const std::vector<Poster>& posters();
// Those of a zone type; those of any zone when it has none of its own.
std::vector<const Poster*> posters_for(std::string_view zone_type);

constexpr double poster_aspect = 1 / 1.414;  // width over height, as all A sizes

// Draws a poster in one of three designs, the house's colour as its accent (#rrggbb).
// Deterministic. Errors: assets.bad_row for a motif or a colour that is none.
Result<Image> draw_poster(const Poster& poster,
                          std::string_view accent,
                          unsigned design,
                          int height_px);

}  // namespace marketgen::assets
