// The MuJoCo model of a region: some products free, the others and everything else standing still.
#pragma once
#include <cstdint>
#include <vector>

#include "physics/mujoco_guard.h"
#include "scene/scene.h"

namespace marketgen::physics {

struct SettleModel {
  MujocoModel model{nullptr, mj_deleteModel};
  std::vector<std::uint32_t> products;  // rows of scene.products; products[i] is body i + 1
};

// `free` are rows of scene.products. Of the rest, what lies within `margin_m` of them is in the
// model. Goods on pegs hang from the middle of their upper edge. Errors: physics.failed, assets.*.
Result<SettleModel> settle_model(const scene::Scene& scene,
                                 const std::vector<std::uint32_t>& free,
                                 double margin_m);

}  // namespace marketgen::physics
