// From radiance to what a screen shows: exposure, the AgX film curve, sRGB bytes.
#pragma once
#include "geometry/image.h"
#include "geometry/vector.h"

namespace marketgen::raytrace {

// `radiance` times exposure: 1 is a white sheet under the store's own light.
Rgb8 display_color(Vec3f exposed);

// Linear RGB (Rec. 709, unit luminance) of a black body at `kelvin`, 1000..40000 K.
Vec3f black_body(double kelvin);

}  // namespace marketgen::raytrace
