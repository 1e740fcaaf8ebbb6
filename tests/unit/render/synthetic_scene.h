// Rooms made of a few boxes, whose pictures are known by geometry.
#pragma once
#include "scene/scene.h"

namespace marketgen {

// An empty room with a white look; parts stand in one fixture at the room's south-west floor
// corner.
inline scene::Scene empty_room(int width_mm, int depth_mm, int ceiling_mm) {
  scene::Scene scene;
  scene.layout.shell.width_mm = width_mm;
  scene.layout.shell.depth_mm = depth_mm;
  scene.layout.shell.ceiling_mm = ceiling_mm;
  return scene;
}

// Adds a fixture made of one box; its frame stands at `position_m`, the box around `middle_m` in
// it. Returns its Frame id.
inline std::uint32_t add_box_fixture(scene::Scene& scene,
                                     std::array<float, 3> position_m,
                                     std::array<float, 3> middle_m,
                                     std::array<float, 3> half_size_m,
                                     assets::SurfaceKind kind = assets::SurfaceKind::opaque) {
  scene::ScenePart part;
  part.fixture = static_cast<std::uint32_t>(scene.fixtures.size());
  part.kind = kind;
  part.position_m = middle_m;
  part.half_size_m = half_size_m;
  part.color = {0.8F, 0.8F, 0.8F};
  scene::SceneFixture fixture;
  fixture.first_part = static_cast<std::uint32_t>(scene.parts.size());
  fixture.part_count = 1;
  fixture.position_m = position_m;
  scene.parts.push_back(part);
  scene.fixtures.push_back(fixture);
  layout::Fixture row;
  row.id = "zone/run/module-" + std::to_string(scene.fixtures.size());
  row.run = "zone/run";
  row.zone = "zone";
  row.kind = "gondola";
  row.x_mm = static_cast<int>((position_m[0] + middle_m[0]) * 1000);
  row.y_mm = static_cast<int>((position_m[1] + middle_m[1]) * 1000);
  row.width_mm = static_cast<int>(half_size_m[0] * 2000);
  row.depth_mm = static_cast<int>(half_size_m[1] * 2000);
  row.height_mm = static_cast<int>((middle_m[2] + half_size_m[2]) * 1000);
  scene.layout.fixtures.push_back(row);
  return 1 + static_cast<std::uint32_t>(scene.fixtures.size());
}

}  // namespace marketgen
