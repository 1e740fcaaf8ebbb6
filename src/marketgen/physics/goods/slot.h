// The body of one model as a body of another, that is compiled already.
//
// A slot is a free body, or a tree of them, with more geoms than most goods need. It becomes one
// product after another: every number is copied from a model of that product alone, which MuJoCo
// itself has compiled, so that the slot moves bit for bit as if its model had been compiled with
// the product in it.
#pragma once
#include "physics/mujoco_guard.h"

namespace marketgen::physics {

// Makes the tree of `to` whose first body is `body` the one that `from` consists of: it has as many
// bodies and joints, and no more geoms than the slot has. `first_mesh`: the row in `to` of the
// first mesh of `from`. Which geoms collide is left as it is; those that are left over belong to no
// body.
void copy_tree(mjModel& to, int body, const mjModel& from, int first_mesh = 0);

// The same bodies of so many times the density: `model` is of goods alone. What MuJoCo derives of
// masses goes with them, or against them.
void scale_mass(mjModel& model, double factor);

}  // namespace marketgen::physics
