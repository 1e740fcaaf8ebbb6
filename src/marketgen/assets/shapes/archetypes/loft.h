// Lofts: a skin drawn over cross-sections from bottom to top. Bottles, cans, jars, flasks, tubes
// and fruit.
#pragma once
#include <vector>

#include "assets/shapes/archetypes/pack_builder.h"

namespace marketgen::assets {

// A cross-section: a rectangle with elliptical corners that reach `roundness` of the way to the
// middles of its sides (1: an ellipse, 0: a rectangle), wavy by `lobe` of its radius.
struct Section {
  float z = 0;
  float half_width = 0, half_depth = 0;  // 0 and 0: a pole
  std::uint16_t surface = 0;  // of the band that starts here; of the end cap for the last section
  float roundness = 1;
  float lobe = 0;
  float x = 0, y = 0;  // of its middle
};

// What one pack may spend, so that 40,000 of them can be drawn.
inline constexpr int pack_triangles = 1480;

struct LoftStyle {
  int triangles =
      pack_triangles;   // at most about so many: sets the chords of a quarter turn, 3 to 9
  int lobes = 0;        // waves once around
  float lobe_turn = 0;  // where the first lies, in turns
  int max_chords = 9;   // of a quarter turn
  // How far `front` and `back` reach around each corner's arc: 1 half way around the pack, less: a
  // label with an edge, and `beside` it shows the pack itself.
  float label_arc = 1;
  std::uint16_t beside = 0;
  bool lying = false;  // what is printed reads along the loft's axis, left to right on its way up
};

// What a round pack in the hand may spend: no facets at 400 pixels.
inline constexpr LoftStyle smooth_style{.triangles = 2800, .max_chords = 14};

// Length of a section's outline over its front, as far around both corners as `label_arc` says.
float label_width(const Section& section, float label_arc);

// Closed at both ends. Once around from the back (+Y): left, front, right. Bands with the printed
// surface take their UVs from the sheet (`band`, `skin`, or `front` and `back`; an end cap takes
// `top`), the others from 0..1 of their run. Precondition: at least two sections; where z falls (a
// dome pressed in from below) the skin turns inwards.
void add_loft(PackBuilder& pack,
              const std::vector<Section>& sections,
              const LoftStyle& style = {},
              const Placement& place = PartFrame{});

}  // namespace marketgen::assets
