#include "collect/goods_now.h"

namespace marketgen {

void GoodsNow::move(std::uint32_t product, const Pose& pose) {
  SceneProduct moved = scene_->products[product];
  place(moved, pose);
  moved_[product] = world_from_product(moved);
}

Pose GoodsNow::pose(std::uint32_t product) const {
  const auto moved = moved_.find(product);
  return moved == moved_.end() ? world_from_product(scene_->products[product]) : moved->second;
}

}  // namespace marketgen
