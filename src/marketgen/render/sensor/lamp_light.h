// Lamps that are brighter than the camera is set to, or of another colour.
#pragma once
#include "geometry/vector.h"

namespace marketgen::render {

// For RenderOptions::light: as much brighter, and as a black body at 4000 K changes when it is so
// many mired warmer (+) or colder, white paper as bright as before. A mired is a millionth of a
// reciprocal kelvin; so counted, light of any colour changes nearly alike. Zeros: exactly 1, 1, 1.
Vec3f lamp_light(double stops, double mired);

}  // namespace marketgen::render
