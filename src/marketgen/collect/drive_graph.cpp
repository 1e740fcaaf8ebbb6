#include "collect/drive_graph.h"

#include <algorithm>
#include <cmath>

#include "geometry/box_extents.h"
#include "layout/layout.h"
#include "plan/plan.h"

namespace marketgen::collect {
namespace {

// Over the floor, of the lowest corner of any of the fixture's parts.
double underside_m(const scene::Scene& scene, std::uint32_t fixture) {
  const scene::SceneFixture& row = scene.fixtures[fixture];
  double low = 1e9;
  for (std::uint32_t p = row.first_part; p < row.first_part + row.part_count; ++p) {
    const scene::ScenePart& part = scene.parts[p];
    const Pose pose = scene::world_from_fixture(scene, fixture) * scene::fixture_from_part(part);
    const auto& [x, y, z] = part.half_size_m;
    low = std::min(low, pose.position.z - box_half_extents(pose.rotation, {x, y, z}).z);
  }
  return low;
}

std::vector<RectMm> obstacles_below(const scene::Scene& scene, double height_m) {
  std::vector<RectMm> obstacles;
  for (std::uint32_t f = 0; f < scene.fixtures.size(); ++f) {
    if (underside_m(scene, f) < height_m)
      obstacles.push_back(layout::footprint_of(scene.layout.fixtures[f]));
  }
  for (const plan::Column& column : scene.layout.shell.columns)
    obstacles.push_back(plan::footprint_of(column));
  return obstacles;
}

}  // namespace

Result<navigation::VisibilityGraph> drive_graph(const scene::Scene& scene,
                                                const motion::BaseEnvelope& envelope,
                                                double margin_m) {
  const double room_m = envelope.radius_m + margin_m;
  return navigation::VisibilityGraph::make(plan::floor_of(scene.layout.shell),
                                           obstacles_below(scene, envelope.height_m),
                                           static_cast<int>(std::lround(room_m * 1e3)));
}

}  // namespace marketgen::collect
