// Marks on grown skins: streaks, specks, nets, veins, as fields of how much of the mark colour
// shows.
#pragma once
#include "assets/materials/texture_field.h"

namespace marketgen::assets {

// How the mark colour lies on the body colour.
enum class SkinTexture {
  smooth,
  blushed,  // one side ripened in the sun
  streaked,
  specks,
  peel,
  striped,
  netted,
  scales,
  ringed,
  ridged,
  fibres,
  ripening,
  blotched,
  kernels,
  seeds,
  florets,
  leafy
};

// Share of the mark colour everywhere, 0..1; tiles along u.
TextureField mark_field(SkinTexture texture, int width, int height, const Seed& seed);

}  // namespace marketgen::assets
