// Points of circles with only + - * / : the same bits in every build and on every machine, unlike
// std::sin.
#pragma once
#include "geometry/vector.h"

namespace marketgen {
inline namespace geometry {

// (cos, sin) of an angle given in whole turns: 0.25 is a quarter turn to the left. Exact at quarter
// turns and exactly symmetric about both axes; elsewhere within 1e-15.
Vec2 unit_circle(double turns);

}  // namespace geometry
}  // namespace marketgen
