// Rewriting a compiled MuJoCo model in place: bodies of the pool take a product's shape, static
// geoms of products go and come back elsewhere.
//
// mj_setConst and mj_recompile would take 10 to 30 ms and wake everything; these take under 4 us.
// Everything that MuJoCo derives from a shape at compile time is derived here as well, with its
// formulas.
#pragma once
#include "physics/product_grid.h"
#include "physics/store_model.h"

namespace marketgen {

inline Vec3 vec3_of(const mjtNum* v) {
  return {v[0], v[1], v[2]};
}

// world_from_shape as MuJoCo keeps it.
struct ShapePose {
  mjtNum position[3] = {0, 0, 0};
  mjtNum rotation[4] = {1, 0, 0, 0};
};

// The body becomes such a product, at rest at `pose`, and collides.
void dress_body(mjModel& model,
                mjData& data,
                const PoolBody& body,
                const GoodsShape& goods,
                const ShapePose& pose);
// The same for a soft slot, which becomes the pack of soft_model(), straight.
void dress_soft_body(
    mjModel& model, mjData& data, const PoolBody& body, const mjModel& pack, const ShapePose& pose);
void collide_body(mjModel& model, const PoolBody& body, bool on);
// It no longer collides and sleeps alone. It must be asleep.
void park_body(mjModel& model, mjData& data, const PoolBody& body);
// The next step finds it awake: a force of -0 is a change to MuJoCo, and none to the body.
// settle_wake() after the step takes it away again.
void mark_wake(mjData& data, const PoolBody& body);
void settle_wake(mjData& data, const PoolBody& body);

// The upright box around a geom that stands so; `rotation` is MuJoCo's matrix of nine.
Box3 box_of_geom(const mjModel& model, int geom, const mjtNum* position, const mjtNum* rotation);

void switch_geom(mjModel& model, int geom, bool on);
void move_geom(mjModel& model, mjData& data, int geom, const ShapePose& pose);  // a static one
ShapePose geom_pose(const mjModel& model, int geom);

}  // namespace marketgen
