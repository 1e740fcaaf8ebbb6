// The MuJoCo model of a World: the room, the fixtures, every product as a static geom, and a pool
// of free bodies, rigid and soft, that stand in for products while they move.
//
// All that stands still is on one body, the model's last: its geoms come after those that move.
#pragma once
#include <cstdint>
#include <vector>

#include "physics/goods/standing_goods.h"
#include "physics/mujoco_guard.h"
#include "physics/world/world.h"

namespace marketgen::physics {

constexpr int max_pool = 1024, max_soft_pool = 256;  // of WorldOptions

// A free body of the pool and the constraint that hangs it on a hook. Of a soft pack the first of
// `parts` bodies, and a hinge for each that hangs on it. Its geoms follow one another; how many of
// them are in use, the model's body_geomnum says.
struct PoolBody {
  int body = 0, geom = 0, tree = 0, qpos = 0, dof = 0, hook = 0;
  int parts = 1, geoms = 1;

  bool soft() const { return parts > 1; }
  int dofs() const { return 6 + parts - 1; }
};

// What a geom stands for.
struct GeomOwner {
  BodyKind kind = BodyKind::room;
  std::uint32_t row = 0;  // part, pool body (of a moving product), product (of a static one)
  bool pool = false;      // kind is product: `row` is a pool body
};

struct JointAddress {
  int qpos = -1, dof = -1;  // -1: stands still
};

struct StoreModel {
  MujocoModel model{nullptr, mj_deleteModel};
  std::vector<StandingGoods> goods;  // by row of the catalog
  std::vector<int> product_geom;     // by product; -1: absent
  std::vector<GeomOwner> owners;     // by geom
  int still_body = 0;                // first the floor, then the products, then the rest
  std::vector<PoolBody> pool;        // rigid ones first
  std::vector<JointAddress> joints;  // by row of Scene::joints
};

// Errors: as World::create.
Result<StoreModel> store_model(const scene::Scene& scene, const WorldOptions& options);

bool hangs_on_hook(const scene::Scene& scene, std::uint32_t product);

}  // namespace marketgen::physics
