// Colour as a small sensor records it: shot noise, read noise, and a lens darker at its corners.
//
// Applied to the finished picture: its sRGB codes are taken back to linear light, so that the tone
// curve between scene and code is left out of the noise.
#pragma once
#include "geometry/image.h"
#include "render/cameras/camera.h"
#include "render/sensor/sensor_noise.h"

namespace marketgen::render {

// Electrons of a pixel at white are Poisson (here: normal of that variance), the amplifier adds its
// own. Sources: EMVA Standard 1288, release 4.0, section 2; the numbers are our assumption for
// pixels of 1.4 micrometres, which colour sensors of small depth cameras have.
struct ColorSensor {
  double full_well_e = 4500;
  double read_noise_e = 4;
  double vignette = 0.3;  // 0 none, 1 the fourth power of the cosine off the axis
};

// Deterministic from `source`. Precondition: `picture` has the camera's size.
Image noisy_color(const Image& picture,
                  const Camera& camera,
                  const ColorSensor& sensor,
                  const NoiseSource& source);

}  // namespace marketgen::render
