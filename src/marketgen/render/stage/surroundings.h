// What lies outside the shop's doors and windows: a street of houses under an overcast sky, or the
// same street at night.
//
// Infinitely far away, as an environment map that is drawn once and blurred, for lenses are focused
// on the shop: the walls' openings are small, so nobody sees that it does not shift. Deterministic,
// read by any number of threads.
#pragma once
#include "geometry/vector.h"

namespace marketgen::render::raytrace {

struct Surroundings {
  float white = 0;     // radiance of white paper in the shop: what everything here is measured in
  float daylight = 1;  // share of an overcast day; 0 is night
  Vec3f day_tint{1, 1, 1};         // daylight's colour for the shop's camera, luminance 1
  Vec3f even{};                    // beside the street: radiance from every direction
  bool sampled_as_lights = false;  // openings have area lights that stand for it

  // What a ray sees that leaves the shop; no street where `white` is 0.
  Vec3f radiance(Vec3f direction) const;
  // Mean radiance of what is seen through an opening.
  Vec3f mean_radiance() const;
};

}  // namespace marketgen::render::raytrace
