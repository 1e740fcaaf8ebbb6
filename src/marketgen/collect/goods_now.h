// A store in which goods and doors have been moved, without a copy of its scene.
#pragma once
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace marketgen::collect {

class GoodsNow {
 public:
  // As the scene has them. It must outlive this. A scene is taken for goods that nobody has moved.
  GoodsNow(const scene::Scene& scene) : scene_(&scene) {}

  // It now stands there, as exactly as a scene says it.
  void move(std::uint32_t product, const Pose& pose);  // world_from_product

  // Where its joints are now, one a row of Scene::joints; none: as in the scene, at 0.
  void set_joints(std::vector<double> positions) { joints_ = std::move(positions); }

  const scene::Scene& scene() const { return *scene_; }
  double joint(std::uint32_t row) const { return joints_.empty() ? 0 : joints_[row]; }
  const std::vector<double>& joints() const { return joints_; }
  Pose pose(std::uint32_t product) const;  // world_from_product

 private:
  const scene::Scene* scene_;
  std::map<std::uint32_t, Pose> moved_;
  std::vector<double> joints_;
};

}  // namespace marketgen::collect
