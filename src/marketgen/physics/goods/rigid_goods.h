// A product as one rigid body: the contact pieces of its shape, its centre of mass and inertia.
//
// The one description of what a product is to physics where it does not bend: ProductBodies writes
// it into a specification, and a World's pool body is copied from it.
#pragma once
#include <memory>

#include "assets/product_model.h"
#include "geometry/pose.h"
#include "physics/goods/contact_shape.h"
#include "physics/mujoco_guard.h"
#include "physics/world/product_grid.h"

namespace marketgen {

// Alone in a model, as MuJoCo compiles it: one free body, whose frame is that of its inertia.
struct RigidGoods {
  MujocoModel model{nullptr, mj_deleteModel};
  Pose product_from_body;
  Box3 bounds;          // of its pieces, body frame
  bool hollow = false;  // not one solid: its still shape is where the pack is not, beside a neck
};

// Pieces, centre of mass and inertia. Three kinds of goods have for their one piece the solid of
// collision_of(), by which stores are stocked, and the true centre and inertia all the same:
// - produce: its heaps were settled with it (data/heaps.json), pieces would begin inside one
// another;
// - what may be stacked: MuJoCo holds a hull under a stack by one contact, and of 1,111 stacks of
// two 203
//   fell; a box or cylinder it holds by several;
// - what its pieces' foot hardly bears (cards on pegs, baguettes): it stands as it was put;
// - meshes of one's own in more pieces than a body of the pool has geoms.
// Errors: as make_product_body and check_has_body.
Result<ProductBody> store_body(const Product& product);

// Made once in a process (30 ms a row). Thread-safe. Errors: those of store_body, physics.failed.
Result<std::shared_ptr<const RigidGoods>> rigid_goods(const Product& product);

}  // namespace marketgen
