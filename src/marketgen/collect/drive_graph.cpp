#include "collect/drive_graph.h"

#include <algorithm>
#include <cmath>

#include "layout/layout.h"
#include "plan/plan.h"
#include "scene/floor_obstacles.h"

namespace marketgen::collect {
namespace {

std::vector<RectMm> obstacles_below(const scene::Scene& scene, double height_m) {
  std::vector<RectMm> obstacles;
  for (const layout::Fixture& fixture : scene::fixtures_below(scene, height_m))
    obstacles.push_back(layout::footprint_of(fixture));
  for (const plan::Column& column : scene.layout.shell.columns)
    obstacles.push_back(plan::footprint_of(column));
  return obstacles;
}

}  // namespace

Result<navigation::VisibilityGraph> drive_graph(const scene::Scene& scene,
                                                const motion::BaseEnvelope& envelope,
                                                const std::vector<RectMm>& more,
                                                double margin_m) {
  const double room_m = envelope.radius_m + margin_m;
  std::vector<RectMm> obstacles = obstacles_below(scene, envelope.height_m);
  obstacles.insert(obstacles.end(), more.begin(), more.end());
  return navigation::VisibilityGraph::make(
      plan::floor_of(scene.layout.shell), obstacles, static_cast<int>(std::lround(room_m * 1e3)));
}

Result<navigation::FreeSpace> open_floor(const scene::Scene& scene, double height_m) {
  constexpr int min_clearance_mm = 1;
  return navigation::FreeSpace::make(
      plan::floor_of(scene.layout.shell), obstacles_below(scene, height_m), min_clearance_mm);
}

double free_floor_m2(const scene::Scene& scene, double height_m) {
  double free = area_m2(plan::floor_of(scene.layout.shell));
  for (const RectMm& obstacle : obstacles_below(scene, height_m))
    free -= obstacle.area_m2();
  return std::max(free, 0.0);
}

}  // namespace marketgen::collect
