#include "scene/floor_obstacles.h"

#include <algorithm>

#include "geometry/box_extents.h"

namespace marketgen::scene {
namespace {

// Over the floor, of the lowest corner of any of the fixture's parts.
double underside_m(const Scene& scene, std::uint32_t fixture) {
  const SceneFixture& row = scene.fixtures[fixture];
  double low = 1e9;
  for (std::uint32_t p = row.first_part; p < row.first_part + row.part_count; ++p) {
    const ScenePart& part = scene.parts[p];
    const Pose pose = world_from_fixture(scene, fixture) * fixture_from_part(part);
    const auto& [x, y, z] = part.half_size_m;
    low = std::min(low, pose.position.z - box_half_extents(pose.rotation, {x, y, z}).z);
  }
  return low;
}

}  // namespace

std::vector<layout::Fixture> fixtures_below(const Scene& scene, double height_m) {
  std::vector<layout::Fixture> below;
  for (std::uint32_t f = 0; f < scene.fixtures.size(); ++f) {
    if (underside_m(scene, f) < height_m) below.push_back(scene.layout.fixtures[f]);
  }
  return below;
}

}  // namespace marketgen::scene
