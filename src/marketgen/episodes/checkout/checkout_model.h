// The MuJoCo model of Checkout Unloading: counter, lip, basket, items and the arm.
#pragma once
#include <memory>
#include <vector>

#include "catalog/rows.h"
#include "episodes/checkout/checkout_station.h"
#include "episodes/episode_spec.h"
#include "physics/goods/goods_body.h"
#include "physics/mujoco_guard.h"

namespace marketgen::episodes {

// A product with what physics and goals need of it.
struct CheckoutGoods {
  physics::SharedGoodsBody made;  // of GoodsUse::bulk
  const catalog::Product& product;
  const assets::ProductBody& body;
  std::vector<Vec3> volume;   // points spread evenly through it, product frame
  double pad_friction = 0.5;  // of rubber on it
};

// A body is made once in a process: cutting packs into convex pieces takes longer than all the rest
// of a reset. Thread-safe. Errors: assets.*, catalog.bad_row.
using SharedGoods = std::shared_ptr<const CheckoutGoods>;
Result<SharedGoods> checkout_goods(const catalog::Product& product,
                                   const std::vector<catalog::FrictionRow>& frictions);

enum class CheckoutOwner { still, basket, item, finger, arm };

struct CheckoutModel {
  physics::MujocoModel model{nullptr, mj_deleteModel};
  int basket = 0;                     // body
  std::vector<int> items;             // bodies, in the order of the episode's
  std::vector<CheckoutOwner> owners;  // by geom
  std::vector<int> owner_index;       // by geom: which item, which finger
};

// `goods[i]` is what item i is. Errors: physics.failed, robot.*, assets.*.
Result<CheckoutModel> checkout_model(const CheckoutStation& station,
                                     const robots::Robot& robot,
                                     const std::vector<double>& robot_state,
                                     const std::vector<EpisodeItem>& items,
                                     const std::vector<SharedGoods>& goods);

// The arm at rest, fingers open.
std::vector<double> ready_state(const CheckoutStation& station, const robots::Robot& robot);

}  // namespace marketgen::episodes
