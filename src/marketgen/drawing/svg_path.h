// SVG's small languages: path data, transforms, lengths (SVG 1.1, chapters 7 and 8).
#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "drawing/curves.h"

namespace marketgen::drawing {

// Straight pieces and curves of one subpath apart, so that a door's arc can be told from its leaf.
struct PathPiece {
  std::vector<Vec2> points;
  bool closed = false;
  bool curved = false;
};

// What can be read up to the first fault, as SVG asks of its readers; `fault` tells of one.
struct PathData {
  std::vector<PathPiece> pieces;
  bool fault = false;
};
PathData read_path(std::string_view text);

std::vector<Vec2> read_points(std::string_view text);
// Nothing when it is none.
std::optional<Affine> read_transform(std::string_view text);

struct Length {
  double value = 0;
  double unit_mm = 0;  // 0: a bare number or px
};
std::optional<Length> read_length(std::string_view text);

}  // namespace marketgen::drawing
