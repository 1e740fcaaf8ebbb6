#include "physics/world/pad_balls.h"

#include <algorithm>
#include <cmath>

#include "physics/goods/contact_shape.h"

namespace marketgen::physics {
namespace {

// How large, how far apart at most, and how far out the outermost stand.
constexpr double pad_ball_m = 0.006, pad_spacing_m = 0.0055, pad_inset = 0.85;

int balls_along(double half) {
  return std::max(2, static_cast<int>(std::ceil(2 * pad_inset * half / pad_spacing_m)) + 1);
}

double ball_place(double half, int i, int count) {
  return pad_inset * half * (2.0 * i / (count - 1) - 1);
}

}  // namespace

std::vector<Vec3> pad_ball_places(Vec3 middle, Vec3 half, double side) {
  std::vector<Vec3> places;
  const int across = balls_along(half.x), along = balls_along(half.z);
  for (int i = 0; i < across; ++i) {
    for (int k = 0; k < along; ++k)
      places.push_back(middle + Vec3{ball_place(half.x, i, across),
                                     side * (pad_ball_m - half.y),
                                     ball_place(half.z, k, along)});
  }
  return places;
}

std::vector<mjsGeom*> add_pad_balls(mjsBody* body, Vec3 middle, Vec3 half, double side) {
  std::vector<mjsGeom*> balls;
  for (const Vec3& at : pad_ball_places(middle, half, side)) {
    mjsGeom* ball = mjs_addGeom(body, nullptr);
    ball->type = mjGEOM_SPHERE;
    ball->size[0] = pad_ball_m;
    ball->pos[0] = at.x, ball->pos[1] = at.y, ball->pos[2] = at.z;
    ball->mass = 0;
    ball->condim = 4;
    ball->friction[1] = torsional_friction_m;
    ball->solref[0] = contact_time_s;
    balls.push_back(ball);
  }
  return balls;
}

}  // namespace marketgen::physics
