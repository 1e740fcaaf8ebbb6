// A store in which goods have been moved, without a copy of its scene.
#pragma once
#include <cstdint>
#include <map>

#include "scene/scene.h"

namespace marketgen::collect {

class GoodsNow {
 public:
  // As the scene has them. It must outlive this. A scene is taken for goods that nobody has moved.
  GoodsNow(const scene::Scene& scene) : scene_(&scene) {}

  // It now stands there, as exactly as a scene says it.
  void move(std::uint32_t product, const Pose& pose);  // world_from_product

  const scene::Scene& scene() const { return *scene_; }
  Pose pose(std::uint32_t product) const;  // world_from_product

 private:
  const scene::Scene* scene_;
  std::map<std::uint32_t, Pose> moved_;
};

}  // namespace marketgen::collect
