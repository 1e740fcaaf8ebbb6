#include "collect/goods_now.h"

namespace marketgen::collect {

void GoodsNow::move(std::uint32_t product, const Pose& pose) {
  scene::SceneProduct moved = scene_->products[product];
  scene::place(moved, pose);
  moved_[product] = scene::world_from_product(moved);
}

Pose GoodsNow::pose(std::uint32_t product) const {
  const auto moved = moved_.find(product);
  return moved == moved_.end() ? scene::world_from_product(scene_->products[product])
                               : moved->second;
}

}  // namespace marketgen::collect
