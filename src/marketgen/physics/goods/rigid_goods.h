// The body of a product in a model of its own: what a World's pool body is copied from
// (physics/goods/slot.h).
#pragma once
#include <memory>

#include "catalog/product.h"
#include "geometry/pose.h"
#include "physics/goods/goods_body.h"
#include "physics/mujoco_guard.h"
#include "physics/world/product_grid.h"

namespace marketgen::physics {

// Alone in a model, as MuJoCo compiles it: one free body, whose frame is that of its inertia.
struct RigidGoods {
  MujocoModel model{nullptr, mj_deleteModel};
  Pose product_from_body;
  Box3 bounds;          // of its pieces, body frame
  bool hollow = false;  // not one solid: its still shape is where the pack is not, beside a neck
};

// goods_body() of a product. Made once in a process (30 ms a row). Thread-safe. Errors:
// those of goods_body, physics.failed.
Result<std::shared_ptr<const RigidGoods>> rigid_goods(const catalog::Product& product,
                                                      GoodsUse use);

// A copy of so many times the mass, evenly through the pack. Error physics.failed.
Result<std::shared_ptr<const RigidGoods>> with_mass(const RigidGoods& goods, double factor);

}  // namespace marketgen::physics
