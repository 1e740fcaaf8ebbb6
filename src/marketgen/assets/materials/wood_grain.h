// Grain of sawn wood: fine pores along the board over the broad figure of its year rings.
#pragma once
#include "assets/materials/pieces.h"

namespace marketgen::assets {

class WoodGrain {
 public:
  WoodGrain(const PatternSheet& sheet, const Seed& seed);

  // 0 early wood .. 1 late wood on piece `id`, each piece cut from elsewhere in the tree.
  float dark(const Piece& piece) const;
  // Depth of the pores there, 0..1.
  float pores(const Piece& piece) const;

 private:
  float at(const TextureField& field, const Piece& piece, float salt) const;

  float px_per_mm_;
  Seed cuts_;
  TextureField figure_, rings_, pores_;
};

// Colours, pores and grooves of wooden pieces: the second colour is the grain.
void grow_wood(PatternSheet& sheet, const std::vector<Piece>& pieces, float contrast);

}  // namespace marketgen::assets
