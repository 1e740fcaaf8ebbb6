// Cameras: what is refused and why, and where the standard ones stand.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "render/cameras/camera.h"
#include "synthetic_scene.h"

namespace marketgen {
namespace {

render::Camera good_camera() {
  render::Camera camera;
  camera.from = {1, 1, 1.5};
  camera.at = {2, 2, 1.5};
  return camera;
}

std::string code_of(const render::Camera& camera) {
  const Result<void> checked = render::check_camera(camera, "--camera");
  return checked.ok() ? "" : checked.error().code;
}

TEST(Camera, GoodOnesPass) {
  EXPECT_EQ(code_of(good_camera()), "");
  render::Camera plan = good_camera();
  plan.at = plan.from - Vec3{0, 0, 1};  // straight down
  plan.ortho_height_m = 10;
  plan.fov_deg = 0;  // ignored
  EXPECT_EQ(code_of(plan), "");
}

TEST(Camera, RefusesWhatSeesNothing) {
  render::Camera camera = good_camera();
  camera.at = camera.from;
  EXPECT_EQ(code_of(camera), "camera.degenerate");
  camera = good_camera();
  camera.from.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(code_of(camera), "camera.degenerate");
  for (const double fov : {0.0, 0.5, 170.5, 180.0, std::numeric_limits<double>::quiet_NaN()}) {
    camera = good_camera();
    camera.fov_deg = fov;
    EXPECT_EQ(code_of(camera), "camera.degenerate") << fov;
  }
  camera = good_camera();
  camera.ortho_height_m = -1;
  EXPECT_EQ(code_of(camera), "camera.degenerate");
}

TEST(Camera, RefusesImpossibleSizes) {
  for (const auto& [width, height] : {std::pair{0, 10}, {10, -1}, {16385, 10}, {9000, 9000}}) {
    render::Camera camera = good_camera();
    camera.width = width;
    camera.height = height;
    EXPECT_EQ(code_of(camera), "camera.bad_size") << width << "x" << height;
  }
}

TEST(Camera, UnknownNameNamesTheNearest) {
  const Result<render::Camera> camera =
      render::camera_named(empty_room(8000, 6000, 3000), "entrnce", 64, 48);
  ASSERT_FALSE(camera.ok());
  EXPECT_EQ(camera.error().code, "camera.unknown");
  EXPECT_NE(camera.error().message.find("did you mean \"entrance\"?"), std::string::npos)
      << camera.error().message;
}

TEST(StandardCameras, StandInFreeFloor) {
  scene::Scene scene = empty_room(10000, 8000, 3000);
  scene.layout.shell.openings.push_back(
      {"door", plan::OpeningKind::entrance, plan::Wall::south, 0.5, 2000});
  add_box_fixture(scene, {0, 0, 0}, {5, 1.2F, 1}, {1, 0.7F, 1});  // right behind the door
  layout::LayoutZone zone;
  zone.id = "zone";
  zone.polygon_mm = {{3000, 0}, {7000, 0}, {7000, 3000}, {3000, 3000}};
  scene.layout.zones.push_back(zone);
  const std::vector<render::Camera> cameras = render::standard_cameras(scene, 160, 90);
  ASSERT_EQ(cameras.size(), 5U);
  EXPECT_EQ(cameras[4].name, "zone:zone");
  for (const render::Camera& camera : cameras) {
    EXPECT_TRUE(render::check_camera(camera, camera.name).ok()) << camera.name;
    if (camera.ortho_height_m > 0) continue;
    EXPECT_GT(camera.from.x, 0.29);
    EXPECT_LT(camera.from.x, 9.71);
    EXPECT_GT(camera.from.y, 0.29);
    EXPECT_LT(camera.from.y, 7.71);
    const bool in_fixture =
        std::fabs(camera.from.x - 5) < 1 && std::fabs(camera.from.y - 1.2) < 0.7;
    EXPECT_FALSE(in_fixture) << camera.name;
  }
}

TEST(StandardCameras, TopSeesTheWholeFloor) {
  const render::Camera top = render::standard_cameras(empty_room(20000, 5000, 3000), 160, 90).at(0);
  EXPECT_EQ(top.name, "top");
  EXPECT_GE(top.ortho_height_m, 20 * 90.0 / 160);
  EXPECT_DOUBLE_EQ(top.from.x, 10);
  EXPECT_DOUBLE_EQ(top.from.y, 2.5);
}

}  // namespace
}  // namespace marketgen
