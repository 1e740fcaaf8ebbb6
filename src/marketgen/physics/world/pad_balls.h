// A gripper's pad as MuJoCo meets it: a grid of balls that touch the pad's face from behind. Rubber
// lies on in many places. (The edge of a flat box on a hull touches in two, which jump along it
// from step to step; pouches crept by 2 mm.)
#pragma once
#include <vector>

#include "geometry/vector.h"
#include "physics/mujoco_guard.h"

namespace marketgen::physics {

// Middles of its balls. The pad is as for add_pad_balls().
std::vector<Vec3> pad_ball_places(Vec3 middle, Vec3 half, double side);

// Massless geoms on `body`. The pad is a box at `middle` with `half` sizes, its face towards -Y
// times `side` (1 or -1). Friction and what they meet is the caller's to set.
std::vector<mjsGeom*> add_pad_balls(mjsBody* body, Vec3 middle, Vec3 half, double side);

}  // namespace marketgen::physics
