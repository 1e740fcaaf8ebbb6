// Where on a pack the printed zone lies: shared by the meshes that carry it and the sheet that is
// drawn for it.
#pragma once
#include "catalog/product.h"

namespace marketgen::assets {

// The printed part of a pack's body, a band between two heights.
struct LabelZone {
  float low_m = 0, high_m = 0;  // above the ground
  float roundness = 1;          // of the cross-section: 1 ellipse, 0 rectangle
  float perimeter_m = 0;        // of the cross-section in the middle of the band
  float arc = 1;                // how far `front` and `back` reach, see LoftStyle::label_arc
  float face_width_m = 0;       // of `front` and `back`
  float lid_share = 1;          // of the footprint that the printed top takes
};

// Of a pack whose label goes once around (SheetKind band, band_lid) or lies on the body's two
// halves (front_back bottles).
LabelZone label_zone_of(const catalog::Product& product);

// The roof of a gable-top carton: two slopes that meet under an upright fin. The ridge runs along
// X.
struct GableRoof {
  float body_m = 0;   // height of the upright walls
  float fin_m = 0;    // height of the fin
  float rise_m = 0;   // height of the slopes
  float slope_m = 0;  // length of one slope
};
GableRoof gable_roof_of(const catalog::Product& product);

// Circumference of an ellipse with these axes (Ramanujan's first formula, within 0.5 % for packs).
float ellipse_perimeter(float width, float depth);

// Width and depth within a tenth: the pack is round, not oval or long.
bool is_round_footprint(const catalog::Product& product);

}  // namespace marketgen::assets
