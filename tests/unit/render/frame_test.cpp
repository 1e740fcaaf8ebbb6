// Depth, segmentation and normals of scenes whose answer is known by geometry, and what must not
// change pixels.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "render/render.h"
#include "synthetic_scene.h"

namespace marketgen {
namespace {

constexpr float millimetre = 1e-3F;

render::Frame rendered(const scene::Scene& scene,
                       const render::Camera& camera,
                       render::RenderOptions options = {}) {
  const Result<std::unique_ptr<render::Renderer>> renderer = render::Renderer::create(scene);
  EXPECT_TRUE(renderer.ok()) << (renderer.ok() ? "" : to_string(renderer.error()));
  const Result<render::Frame> frame = (*renderer)->render(camera, options);
  EXPECT_TRUE(frame.ok());
  return *frame;
}

std::size_t pixel(const render::Camera& camera, int x, int y) {
  return static_cast<std::size_t>(y * camera.width + x);
}

// A box of 1 x 1 x 1 m on the floor, its near face at y = 3, seen along +y from y = 1.
struct BoxScene {
  scene::Scene scene = empty_room(6000, 6000, 3000);
  std::uint32_t box = add_box_fixture(scene, {3, 3.5F, 0}, {0, 0, 0.5F}, {0.5F, 0.5F, 0.5F});
  render::Camera camera;
  BoxScene() {
    camera.from = {3, 1, 0.5};
    camera.at = {3, 2, 0.5};
    camera.fov_deg = 60;
    camera.width = 121;
    camera.height = 81;
  }
};

TEST(Frame, DepthOfABoxAndTheWallBehindIt) {
  const BoxScene s;
  const render::Frame frame = rendered(s.scene, s.camera);
  EXPECT_NEAR(frame.depth_m[pixel(s.camera, 60, 40)], 2.0F, millimetre);  // the near face
  EXPECT_NEAR(frame.depth_m[pixel(s.camera, 30, 40)],
              5.0F,
              millimetre);  // the wall at y = 6: the same depth all over it
  EXPECT_NEAR(frame.depth_m[pixel(s.camera, 90, 40)], 5.0F, millimetre);
  EXPECT_EQ(frame.instance[pixel(s.camera, 60, 40)], s.box);
  EXPECT_EQ(frame.instance[pixel(s.camera, 30, 40)], 1U);
}

TEST(Frame, TheFloorLiesWhereItsPixelsSay) {
  const BoxScene s;
  const render::Frame frame = rendered(s.scene, s.camera);
  const double tan_half = std::tan(30 * std::numbers::pi / 180);
  for (const int y : {60, 70, 80}) {
    const double slope =
        (2 * (y + 0.5) / s.camera.height - 1) * tan_half;  // metres down per metre ahead
    const double expected = 0.5 / slope;
    if (expected > 5) continue;
    EXPECT_NEAR(frame.depth_m[pixel(s.camera, 5, y)], expected, 1e-3) << y;
    EXPECT_NEAR(frame.normals[3 * pixel(s.camera, 5, y) + 2], 1.0F, 1e-3F);
  }
}

TEST(Frame, NormalsFaceTheEye) {
  const BoxScene s;
  const render::Frame frame = rendered(s.scene, s.camera);
  const std::size_t i = 3 * pixel(s.camera, 60, 40);
  EXPECT_NEAR(frame.normals[i], 0, 1e-3F);
  EXPECT_NEAR(frame.normals[i + 1], -1, 1e-3F);
  EXPECT_NEAR(frame.normals[i + 2], 0, 1e-3F);
}

TEST(Frame, GlassReportsWhatIsBehind) {
  BoxScene s;
  add_box_fixture(s.scene, {3, 2, 0}, {0, 0, 0.5F}, {2, 0.005F, 0.5F}, assets::SurfaceKind::glass);
  const render::Frame frame = rendered(s.scene, s.camera);
  EXPECT_EQ(frame.instance[pixel(s.camera, 60, 40)], s.box);
  EXPECT_NEAR(frame.depth_m[pixel(s.camera, 60, 40)], 2.0F, millimetre);
  const auto matter_at = [&](int x, int y) {
    return static_cast<render::Matter>(frame.matter[pixel(s.camera, x, y)]);
  };
  EXPECT_EQ(matter_at(60, 40), render::Matter::glass);
  EXPECT_EQ(matter_at(30, 40), render::Matter::glass);  // the wall seen through it
  EXPECT_EQ(matter_at(60, 3), render::Matter::solid);   // above the pane
}

TEST(Frame, OrthographicPixelsAreEvenlySpaced) {
  BoxScene s;
  s.camera.from = {3, 3, 10};
  s.camera.at = {3, 3, 0};
  s.camera.width = 120;
  s.camera.height = 80;
  s.camera.ortho_height_m = 8;  // 0.1 m a pixel
  render::RenderOptions options;
  options.hide_ceiling = true;
  const render::Frame frame = rendered(s.scene, s.camera, options);
  int box_pixels = 0;
  for (std::size_t i = 0; i < frame.instance.size(); ++i) {
    if (frame.instance[i] != s.box) continue;
    ++box_pixels;
    EXPECT_NEAR(frame.depth_m[i], 9.0F, millimetre);  // its top at z = 1
  }
  EXPECT_EQ(box_pixels, 100);  // 1 x 1 m
  EXPECT_NEAR(frame.depth_m[pixel(s.camera, 40, 60)], 10.0F, millimetre);
}

TEST(Frame, OutsideThereIsNothing) {
  BoxScene s;
  s.camera.from = {3, -5, 1};
  s.camera.at = {3, -6, 1};  // away from the shop
  const render::Frame frame = rendered(s.scene, s.camera);
  EXPECT_EQ(frame.depth_m[pixel(s.camera, 60, 40)], 0.0F);
  EXPECT_EQ(frame.instance[pixel(s.camera, 60, 40)], 0U);
}

TEST(Frame, AnEyeInsideABoxStillSees) {
  BoxScene s;
  s.camera.from = {3, 3.5, 0.5};
  s.camera.at = {3, 4, 0.5};
  const render::Frame frame = rendered(s.scene, s.camera);
  EXPECT_NEAR(
      frame.depth_m[pixel(s.camera, 60, 40)], 0.5F, millimetre);  // its far wall, from within
}

class ThreadsTest : public testing::TestWithParam<render::RenderMode> {};

TEST_P(ThreadsTest, ThreadCountDoesNotChangePixels) {
  const BoxScene s;
  render::RenderOptions options;
  options.mode = GetParam();
  options.samples = 2;
  std::vector<render::Frame> frames;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    frames.push_back(rendered(s.scene, s.camera, options));
  }
  for (const render::Frame& frame : frames) {
    EXPECT_EQ(frame.color.pixels, frames[0].color.pixels);
    EXPECT_EQ(frame.depth_m, frames[0].depth_m);
    EXPECT_EQ(frame.instance, frames[0].instance);
    EXPECT_EQ(frame.normals, frames[0].normals);
  }
}
INSTANTIATE_TEST_SUITE_P(BothModes,
                         ThreadsTest,
                         testing::Values(render::RenderMode::sensor, render::RenderMode::path));

TEST(Frame, BadCamerasAreErrors) {
  const BoxScene s;
  const Result<std::unique_ptr<render::Renderer>> renderer = render::Renderer::create(s.scene);
  ASSERT_TRUE(renderer.ok());
  render::Camera camera = s.camera;
  camera.width = 0;
  const Result<render::Frame> frame = (*renderer)->render(camera, {});
  ASSERT_FALSE(frame.ok());
  EXPECT_EQ(frame.error().code, "camera.bad_size");
}

}  // namespace
}  // namespace marketgen
