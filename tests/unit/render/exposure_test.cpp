// Pictures are exposed for the light on goods.
#include <gtest/gtest.h>

#include "render/render.h"
#include "synthetic_scene.h"

namespace marketgen {
namespace {

constexpr float paper = 0.8F;

// A white block on a shelf that looks south.
scene::Scene shelf_in_a_room(int lux) {
  scene::Scene scene = empty_room(8000, 6000, 3200);
  scene.layout.look.light_lux = lux;
  add_box_fixture(scene, {4, 4.5F, 0}, {0, 0.25F, 1.2F}, {0.5F, 0.2F, 0.15F});
  scene.parts.back().color = {paper, paper, paper};
  scene::SceneShelf shelf;
  shelf.position_m = {0, 0, 1.05F};
  shelf.width_m = 1.2F;
  shelf.depth_m = 0.5F;
  shelf.clearance_m = 0.4F;
  scene.fixtures.back().first_shelf = 0;
  scene.fixtures.back().shelf_count = 1;
  scene.shelves.push_back(shelf);
  return scene;
}

// The block's front as a picture has it, in sRGB's green.
int front_seen(const scene::Scene& scene, render::RenderMode mode, Vec3 from) {
  const auto renderer = render::Renderer::create(scene).value();
  render::Camera camera;
  camera.from = from;
  camera.at = {4, 4.55, 1.2};
  camera.width = camera.height = 9;
  camera.fov_deg = 3;
  render::RenderOptions options{.mode = mode, .samples = 64, .denoiser = render::Denoiser::own};
  const render::Frame frame = renderer->render(camera, options).value();
  return frame.color.at(4, 4)[1];
}

TEST(Exposure, WhiteGoodsAreWhiteInDimAndBrightShopsFromEverywhere) {
  for (const int lux : {250, 1500}) {
    const scene::Scene scene = shelf_in_a_room(lux);
    for (const render::RenderMode mode : {render::RenderMode::sensor, render::RenderMode::path}) {
      for (const Vec3 from : {Vec3{4, 2, 1.4}, {2.5, 1, 1.6}})
        EXPECT_NEAR(front_seen(scene, mode, from), 230, 10) << lux << " " << name_of(mode);
    }
  }
}

}  // namespace
}  // namespace marketgen
