// Surfaces laid of pieces: which piece each texel lies on, how far from its edge, and the joints
// between them.
#pragma once
#include <vector>

#include "assets/materials/pattern_sheet.h"

namespace marketgen::assets {

// What a texel knows of its piece.
struct Piece {
  std::uint32_t id = 0;
  float edge_mm = 0;                  // to the nearest edge, the middle of the joint
  float along_mm = 0, across_mm = 0;  // place on the piece, from any corner
};

// The pieces under every texel; lay(x_mm, y_mm) says which one lies there.
template <class Lay>
std::vector<Piece> lay_pieces(const PatternSheet& sheet, const Lay& lay) {
  std::vector<Piece> pieces;
  pieces.reserve(sheet.look.mark.values.size());
  for (int y = 0; y < sheet.size_px; ++y) {
    for (int x = 0; x < sheet.size_px; ++x) {
      pieces.push_back(lay((static_cast<float>(x) + 0.5F) * sheet.mm_per_px,
                           (static_cast<float>(y) + 0.5F) * sheet.mm_per_px));
    }
  }
  return pieces;
}

// The piece of a grid of `columns` by `rows` (given in pieces along the texture's sides) under a
// point; `shift` of a column moves the row.
Piece grid_piece(
    const PatternSheet& sheet, int columns, int rows, float shift, float x_mm, float y_mm);

struct Joints {
  float width_mm = 3;
  float depth_mm = 1;      // of the joint's floor below the pieces
  float round_mm = 1;      // over which the pieces' edges fall
  float roughness = 0.9F;  // of the joint itself
};
// Joints in the second colour, below the pieces.
void cut_joints(PatternSheet& sheet, const std::vector<Piece>& pieces, const Joints& joints);

// One brightness for every piece, within `depth` times the row's variation.
void tone_pieces(PatternSheet& sheet, const std::vector<Piece>& pieces, float depth);

// Joints as shadows without a filling, as between boards: `share` of the light is lost in them.
void darken_joints(PatternSheet& sheet,
                   const std::vector<Piece>& pieces,
                   float width_mm,
                   float depth_mm,
                   float share);

}  // namespace marketgen::assets
