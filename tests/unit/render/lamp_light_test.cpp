// Lamps that are brighter or of another colour than the camera is set to.
#include "render/sensor/lamp_light.h"

#include <gtest/gtest.h>

#include "render/render.h"
#include "support/hand_made_scene.h"

namespace marketgen {
namespace {

double luminance_of(Vec3f c) {
  return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
}

TEST(LampLight, NothingIsExactlyOne) {
  EXPECT_EQ(render::lamp_light(0, 0), (Vec3f{1, 1, 1}));
  EXPECT_EQ(render::lamp_light(0, -0.0), (Vec3f{1, 1, 1}));
}

TEST(LampLight, StopsDoubleAndMiredTurnToRed) {
  EXPECT_EQ(render::lamp_light(1, 0), (Vec3f{2, 2, 2}));
  const Vec3f warm = render::lamp_light(0, 40), cold = render::lamp_light(0, -40);
  EXPECT_NEAR(luminance_of(warm), 1, 1e-4);
  EXPECT_NEAR(luminance_of(cold), 1, 1e-4);
  EXPECT_GT(warm.x, 1.05);
  EXPECT_LT(warm.z, 0.85);
  EXPECT_LT(cold.x, 0.97);
  EXPECT_GT(cold.z, 1.1);
}

struct Means {
  double red = 0, green = 0, blue = 0;
};
Means means_of(const Image& picture) {
  Means means;
  for (std::size_t i = 0; i < picture.pixels.size(); i += 3) {
    means.red += picture.pixels[i];
    means.green += picture.pixels[i + 1];
    means.blue += picture.pixels[i + 2];
  }
  const auto count = static_cast<double>(picture.pixels.size() / 3);
  return {means.red / count, means.green / count, means.blue / count};
}

// In both modes, pixels with an edge and others: only what is shown changes.
TEST(LampLight, PicturesAreTakenUnderIt) {
  HandMadeScene shop;
  shop.add(1, {2.8F, HandMadeScene::shelf_y_m - 0.12F, HandMadeScene::upper_board_m});
  const auto renderer = render::Renderer::create(shop.scene).value();
  render::Camera camera;
  camera.name = "eye";
  camera.from = {3, 1.2, 1.2};
  camera.at = {3, 3.7, 0.7};
  camera.width = 96;
  camera.height = 72;
  for (const render::RenderMode mode : {render::RenderMode::sensor, render::RenderMode::path}) {
    render::RenderOptions options;
    options.mode = mode;
    options.samples = 2;
    options.denoiser = render::Denoiser::none;
    const render::Frame usual = renderer->render(camera, options).value();
    options.light = render::lamp_light(0, 50);
    const render::Frame warm = renderer->render(camera, options).value();
    options.light = render::lamp_light(-1, 0);
    const render::Frame dark = renderer->render(camera, options).value();
    const Means before = means_of(usual.color), after = means_of(warm.color);
    EXPECT_GT(after.red, before.red + 2);
    EXPECT_LT(after.blue, before.blue - 4);
    EXPECT_LT(means_of(dark.color).green, before.green - 15);
    EXPECT_EQ(warm.depth_m, usual.depth_m);
    EXPECT_EQ(warm.instance, usual.instance);
    EXPECT_EQ(warm.radiance, usual.radiance) << "that of the store, whatever a camera is set to";
  }
}

}  // namespace
}  // namespace marketgen
