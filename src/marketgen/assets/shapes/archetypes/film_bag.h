// Bags of film: two faces that part from seal to seal.
#pragma once
#include <functional>

#include "assets/shapes/archetypes/panel_box.h"

namespace marketgen::assets {

// How a bag is blown up, for a place on its face: x from -1 (left) to 1 (right), z from 0 (bottom)
// to 1 (top). Returns the share of the full thickness, 0 at a seal.
using BagThickness = std::function<float(float x, float z)>;

inline constexpr float seal_half_thickness_m = 0.0006F;  // two films and their fold

struct BagForm {
  Vec3f size;                     // of the bag, blown up
  std::vector<float> across, up;  // the grid's lines
  float waist = 0;                // share of its width that a bag loses where it is blown up
  BagThickness thickness;
};

// Front and back take `front_and_back`, the narrow edges `edges`.
void add_bag(PackBuilder& pack,
             std::uint16_t front_and_back,
             std::uint16_t edges,
             const BagForm& form,
             const Placement& place = PartFrame{});

}  // namespace marketgen::assets
