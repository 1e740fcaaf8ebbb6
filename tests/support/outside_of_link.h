// How far a point lies outside of a link's capsules; negative inside. Metres, link frame.
#pragma once
#include <algorithm>
#include <cmath>

#include "robots/self_collision.h"

namespace marketgen {

inline double outside(const robots::Link& link, Vec3 p) {
  double least = HUGE_VAL;
  for (const robots::Capsule& c : link.capsules)
    least = std::min(least, robots::distance_between(robots::Capsule{p, p, 0}, c));
  return least;
}

}  // namespace marketgen
