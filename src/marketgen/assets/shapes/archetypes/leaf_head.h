// Heads of leaves: a heart, and leaves that wrap round it from its foot, ever looser.
#pragma once
#include "assets/shapes/archetypes/growth.h"

namespace marketgen::assets {

struct LeafHead {
  float heart = 0.9F;  // size of the closed heart, of the head's
  int leaves = 7;      // that wrap it
  double half_turn = 0.17;
  double low_edge = 0.55, high_edge = 0.9;  // upper ends of the outermost and the innermost leaf
  float flare_outer = 0.15F, flare_inner = 0.03F;
  float ruffle = 0.02F;
  int ruffles = 9;
  int segments = 18, bands = 10;  // of a leaf
};
void add_leaf_head(PackBuilder& pack,
                   std::uint16_t skin,
                   const LeafHead& form,
                   const PlantFrame& frame,
                   const Seed& seed);

}  // namespace marketgen::assets
