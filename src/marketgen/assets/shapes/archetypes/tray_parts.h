// Trays under film: a tapering body with a flange, and a lid film over the goods.
#pragma once
#include "assets/shapes/archetypes/panel_box.h"

namespace marketgen::assets {

// Shares of the footprint and of the height.
struct TrayForm {
  float foot_scale = 0.86F, wall_scale = 0.93F;  // of the footprint: at the foot, under the flange
  float foot_high = 0.16F;                       // how high the foot rounds off
  float flange_low = 0.78F, flange_high = 0.82F;
  float greatest_corner_m = 0.018F;
  float dome_flat = 1.2F;  // the film's shape: greater falls earlier towards the flange
};

// Printed on `top` and on the front; `body` elsewhere.
void add_tray(PackBuilder& pack, const TrayForm& form, std::uint16_t print, std::uint16_t body);

}  // namespace marketgen::assets
