// Rewriting a compiled MuJoCo model in place: bodies of the pool take a product's shape, static
// geoms of products go and come back elsewhere.
//
// mj_setConst and mj_recompile would take 10 to 30 ms and wake everything; these take under 4 us.
// What MuJoCo derives from a product at compile time is copied from a model of it
// (physics/goods/slot.h).
#pragma once
#include "physics/goods/slot.h"
#include "physics/world/product_grid.h"
#include "physics/world/store_model.h"

namespace marketgen::physics {

inline Vec3 vec3_of(const mjtNum* v) {
  return {v[0], v[1], v[2]};
}

// world_from_shape as MuJoCo keeps it.
struct ShapePose {
  mjtNum position[3] = {0, 0, 0};
  mjtNum rotation[4] = {1, 0, 0, 0};
};

// The slot becomes the product of `goods`, a model of it alone, and collides: at rest at `pose` (of
// its first body), a soft pack straight. `first_mesh` as in copy_tree().
void dress_body(mjModel& model,
                mjData& data,
                const PoolBody& body,
                const mjModel& goods,
                int first_mesh,
                const ShapePose& pose);
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

}  // namespace marketgen::physics
