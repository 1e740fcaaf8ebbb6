// Where a photographer can stand: free floor, and how far he sees from there.
#pragma once
#include <optional>
#include <vector>

#include "geometry/vector.h"
#include "navigation/occupancy.h"
#include "scene/scene.h"

namespace marketgen::render::raytrace {

class StandingRoom {
 public:
  explicit StandingRoom(const scene::Scene& scene);

  // Free floor of the shop's main area nearest to `point`; the point itself when there is none.
  Vec3 nearest(Vec3 point) const;
  bool is_free(Vec3 point) const;
  // How far one can walk from `from` towards `direction` (unit, level), up to `limit`.
  double free_way(Vec3 from, Vec3 direction, double limit) const;
  // How far one sees at eye height, over low fixtures.
  double sight(Vec3 from, Vec3 direction, double limit) const;

 private:
  bool is_main(std::size_t cell) const;
  navigation::OccupancyGrid floor_, tall_;
  std::vector<int> label_;
  int main_ = 0;
};

}  // namespace marketgen::render::raytrace
