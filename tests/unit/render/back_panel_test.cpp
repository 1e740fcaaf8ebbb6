// Light that is stored between the boards of a shelf stays there.
#include <gtest/gtest.h>

#include "render/render.h"
#include "synthetic_scene.h"

namespace marketgen {
namespace {

constexpr float half_width = 0.5F, half_depth = 0.25F, height = 1.6F, board = 0.012F;

// A cabinet of thin white boards that is shut all round: no light gets in. It opens to the south.
void add_dark_cabinet(scene::Scene& scene, std::array<float, 3> position_m) {
  const float mid = height / 2;
  add_box_fixture(scene, position_m, {0, half_depth, mid}, {half_width, board / 2, mid});  // back
  const auto add = [&](std::array<float, 3> middle, std::array<float, 3> half) {
    scene::ScenePart part = scene.parts.back();
    part.position_m = middle;
    part.half_size_m = half;
    scene.parts.push_back(part);
    ++scene.fixtures.back().part_count;
  };
  add({0, -half_depth, mid}, {half_width, board / 2, mid});
  for (const float side : {-1.0F, 1.0F})
    add({side * half_width, 0, mid}, {board / 2, half_depth, mid});
  for (const float z : {board / 2, height - board / 2})
    add({0, 0, z}, {half_width, half_depth, board / 2});
  scene::SceneShelf shelf;
  shelf.fixture = static_cast<std::uint32_t>(scene.fixtures.size()) - 1;
  shelf.position_m = {0, -half_depth, 0.1F};
  shelf.width_m = 2 * half_width;
  shelf.depth_m = 2 * half_depth - board;
  shelf.clearance_m = height - 0.2F;
  scene.fixtures.back().first_shelf = static_cast<std::uint32_t>(scene.shelves.size());
  scene.fixtures.back().shelf_count = 1;
  scene.shelves.push_back(shelf);
}

TEST(BackPanel, IsLitFromBehindByTheRoom) {
  scene::Scene scene = empty_room(8000, 6000, 3200);
  add_dark_cabinet(scene, {2.6F, 3, 0});
  add_box_fixture(scene,  // as large, as white, and solid
                  {5.4F, 3, 0},
                  {0, 0, height / 2},
                  {half_width, half_depth + board / 2, height / 2});
  render::Camera camera;
  camera.from = {4, 5.8, 0.8};
  camera.at = {4, 3, 0.8};
  camera.fov_deg = 40;
  camera.width = 161;
  camera.height = 81;
  const auto renderer = render::Renderer::create(scene).value();
  const render::Frame frame =
      renderer->render(camera, {.mode = render::RenderMode::sensor}).value();
  for (const int y : {20, 40, 60}) {
    // Seen from the north, the cabinet is on the right.
    const int cabinet = frame.color.at(122, y)[1], solid = frame.color.at(38, y)[1];
    EXPECT_EQ(frame.instance[static_cast<std::size_t>(y * camera.width + 122)], 2U);
    EXPECT_EQ(frame.instance[static_cast<std::size_t>(y * camera.width + 38)], 3U);
    EXPECT_NEAR(cabinet, solid, 8) << y;
    EXPECT_GT(solid, 60);
  }
}

}  // namespace
}  // namespace marketgen
