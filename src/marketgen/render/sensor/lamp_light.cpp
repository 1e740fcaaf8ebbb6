#include "render/sensor/lamp_light.h"

#include <cmath>

#include "render/shading_math.h"
#include "render/tone.h"

namespace marketgen::render {
namespace {

constexpr double usual_mired = 250;  // 4000 K, neutral white, as most shops hang

}  // namespace

Vec3f lamp_light(double stops, double mired) {
  Vec3f color{1, 1, 1};
  if (mired != 0) {
    const Vec3f usual = raytrace::black_body(1e6 / usual_mired);
    const Vec3f lamp = raytrace::black_body(1e6 / (usual_mired + mired));
    color = {lamp.x / usual.x, lamp.y / usual.y, lamp.z / usual.z};
    color = color / raytrace::luminance(color);
  }
  return color * static_cast<float>(std::exp2(stops));
}

}  // namespace marketgen::render
