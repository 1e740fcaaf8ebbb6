// Lenses and poses: known answers of OpenCV, inverses, and that rays and projection are one model.
#include "render/cameras/camera_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "render/cameras/camera_file.h"
#include "render/cameras/view.h"

namespace marketgen {
namespace {

constexpr render::Intrinsics wide_lens{
    610.5, 608.25, 321.25, 236.75, {-0.28, 0.09, 0.0011, -0.0007, -0.013}};

struct KnownPoint {
  Vec3 camera_point;
  Vec2 picture_point;
};

// cv2.projectPoints (OpenCV 5.0.0) with K of `wide_lens` and its five coefficients.
TEST(CameraModel, ProjectsAsOpenCvDoes) {
  const KnownPoint known[] = {{{0, 0, 1}, {321.25, 236.75}},
                              {{0.35, -0.2, 1}, {525.430517891, 120.574611386}},
                              {{-0.9, 0.6, 2}, {66.519558341, 406.057099431}},
                              {{0.5, 0.4, 1.1}, {575.049652485, 439.383546402}},
                              {{-0.02, 0.31, 0.8}, {306.523332652, 463.277879725}}};
  for (const KnownPoint& row : known) {
    const auto p = render::project(wide_lens, row.camera_point);
    ASSERT_TRUE(p);
    EXPECT_NEAR(p->x, row.picture_point.x, 1e-8);
    EXPECT_NEAR(p->y, row.picture_point.y, 1e-8);
  }
  EXPECT_FALSE(render::project(wide_lens, {0, 0, -1}));
  EXPECT_FALSE(render::project(wide_lens, {0, 0, 0}));
}

TEST(CameraModel, TheInverseBringsEveryPixelBack) {
  ASSERT_TRUE(render::check_lens(wide_lens, 640, 480, "lens").ok());
  for (int y = 0; y < 480; y += 7) {
    for (int x = 0; x < 640; x += 7) {
      const Vec2 seen{(x - wide_lens.cx) / wide_lens.fx, (y - wide_lens.cy) / wide_lens.fy};
      const auto ideal = render::undistorted(wide_lens.distortion, seen);
      ASSERT_TRUE(ideal) << x << "," << y;
      const Vec2 again = render::distorted(wide_lens.distortion, *ideal);
      EXPECT_NEAR(again.x, seen.x, 1e-11);
      EXPECT_NEAR(again.y, seen.y, 1e-11);
    }
  }
}

// A centred lens without distortion is the plain camera with a field of view.
TEST(CameraModel, ACentredPinholeHasTheFieldOfView) {
  const render::Intrinsics k = render::centred_pinhole(640, 480, 60);
  EXPECT_DOUBLE_EQ(k.cx, 319.5);
  EXPECT_DOUBLE_EQ(k.cy, 239.5);
  const double upper_edge = (-0.5 - k.cy) / k.fy;
  EXPECT_NEAR(std::atan(-upper_edge) * 180 / std::numbers::pi, 30, 1e-12);
  EXPECT_EQ(k.fx, k.fy);
}

std::string code_of_lens(render::Intrinsics k) {
  const auto checked = render::check_lens(k, 640, 480, "lens");
  return checked.ok() ? "" : checked.error().code;
}

TEST(CameraModel, RefusesWhatIsNoLens) {
  EXPECT_EQ(code_of_lens(wide_lens), "");
  EXPECT_EQ(code_of_lens({0, 600, 320, 240, {}}), "camera.bad_lens");
  EXPECT_EQ(code_of_lens({600, -600, 320, 240, {}}), "camera.bad_lens");
  EXPECT_EQ(code_of_lens({600, 600, std::numeric_limits<double>::quiet_NaN(), 240, {}}),
            "camera.bad_lens");
  EXPECT_EQ(code_of_lens({600, 600, 320, 240, {std::numeric_limits<double>::infinity()}}),
            "camera.bad_lens");
  EXPECT_EQ(code_of_lens({20, 20, 320, 240, {}}), "camera.bad_lens");  // 172 degrees
  // Its radius r - r^3 is at most 0.385; the corners lie at 0.66.
  EXPECT_EQ(code_of_lens({600, 600, 320, 240, {-1.0}}), "camera.bad_lens");
  // It shrinks again between two radii that both lie in the picture: 1 - 9 r^2 + 15 r^4 < 0 there.
  EXPECT_EQ(code_of_lens({400, 400, 320, 240, {-3, 3}}), "camera.bad_lens");
  // The same far outside the picture does no harm.
  EXPECT_EQ(code_of_lens({4000, 4000, 320, 240, {-3, 3}}), "");
}

// What a lens has folded beyond its picture must not come back into it.
TEST(CameraModel, PointsBeyondTheFoldAreNotProjected) {
  const render::Intrinsics barrel{600, 600, 320, 240, {-0.3}};
  ASSERT_EQ(code_of_lens(barrel), "");
  EXPECT_TRUE(render::project(barrel, {0.5, 0.3, 1}));
  // 1 - 0.3 * 1.8^2 = 0.028: plainly computed it would fall near the middle.
  EXPECT_FALSE(render::project(barrel, {1.8, 0, 1}));
}

render::Camera wrist_camera() {
  const Pose pose{{2, 3, 1.2},
                  rotation_about({0, 0, 1}, 0.7) * rotation_about({1, 0, 0}, -1.9) *
                      rotation_about({0, 0, 1}, 0.4)};
  return render::posed_camera("wrist", pose, wide_lens, 640, 480);
}

// Rays and projection come from separate code: a point on a pixel's ray is projected to the pixel.
TEST(CameraModel, RaysAndProjectionAgree) {
  render::Camera plain;
  plain.from = {1, 2, 1.5};
  plain.at = {4, 3, 1.1};
  render::Camera shifted = wrist_camera();
  shifted.intrinsics->distortion = {};
  render::Camera plan = plain;
  plan.ortho_height_m = 5;
  for (const render::Camera& camera : {plain, shifted, wrist_camera(), plan}) {
    const render::raytrace::View view(camera);
    const render::Projection project(camera);
    for (const Vec2f pixel : {Vec2f{0, 0}, {17, 300}, {320, 240}, {600, 20}, {639, 479}}) {
      const render::raytrace::Ray ray = view.ray(pixel.x + 0.5F, pixel.y + 0.5F);
      const auto back = project(to_double(ray.origin + ray.direction * 3.0F));
      ASSERT_TRUE(back) << camera.name;
      EXPECT_NEAR(back->x, pixel.x, 1e-3) << camera.name;
      EXPECT_NEAR(back->y, pixel.y, 1e-3) << camera.name;
    }
  }
}

TEST(CameraModel, PosesAreThoseOfOpenCvAndOpenGl) {
  render::Camera camera;
  camera.from = {1, 2, 1.5};
  camera.at = {1, 5, 1.5};  // looks north
  const Pose cv = render::opencv_pose_of(camera), gl = render::opengl_pose_of(camera);
  const auto expect_axis = [](Vec3 found, Vec3 expected) {
    EXPECT_NEAR(length(found - expected), 0, 1e-12);
  };
  expect_axis(rotate(cv.rotation, {1, 0, 0}), {1, 0, 0});   // right is east
  expect_axis(rotate(cv.rotation, {0, 1, 0}), {0, 0, -1});  // down
  expect_axis(rotate(cv.rotation, {0, 0, 1}), {0, 1, 0});   // ahead is north
  expect_axis(rotate(gl.rotation, {0, 1, 0}), {0, 0, 1});   // up
  expect_axis(rotate(gl.rotation, {0, 0, 1}), {0, -1, 0});  // back
  expect_axis(cv.position, camera.from);
  const render::CameraAxes axes = render::axes_of(wrist_camera());
  EXPECT_NEAR(length(cross(axes.right, axes.down) - axes.ahead), 0, 1e-12);
}

TEST(CameraFiles, HoldTheWholeCamera) {
  const render::Camera wrist = wrist_camera();
  const Result<render::Camera> again =
      render::camera_of(render::camera_file_of(wrist), "wrist.json");
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(*again->intrinsics, *wrist.intrinsics);
  EXPECT_EQ(again->world_from_camera->rotation, wrist.world_from_camera->rotation);
  EXPECT_EQ(again->width, 640);
  render::Camera plan;
  plan.from = {3, 3, 9};
  plan.at = {3, 3, 0};
  plan.ortho_height_m = 8;
  const Result<render::Camera> flat = render::camera_of(render::camera_file_of(plan), "plan.json");
  ASSERT_TRUE(flat.ok());
  const render::raytrace::View one(plan), other(*flat);
  EXPECT_NEAR(length(one.ray(3, 5).origin - other.ray(3, 5).origin), 0, 1e-5F);
}

TEST(CameraFiles, RefuseWhatIsNoCamera) {
  const auto code_after = [](const auto& spoil) {
    render::CameraFile file = render::camera_file_of(wrist_camera());
    spoil(file);
    const Result<render::Camera> camera = render::camera_of(file, "wrist.json");
    return camera.ok() ? "" : camera.error().code;
  };
  EXPECT_EQ(code_after([](render::CameraFile& f) { f.width = 0; }), "camera.bad_size");
  EXPECT_EQ(code_after([](render::CameraFile& f) { f.width = f.height = 32768; }),
            "camera.bad_size");
  EXPECT_EQ(code_after([](render::CameraFile& f) {
              f.rotation_wxyz = {0, 0, 0, 0};
            }),
            "camera.degenerate");
  EXPECT_EQ(code_after([](render::CameraFile& f) {
              f.position_m[1] = std::numeric_limits<double>::quiet_NaN();
            }),
            "camera.degenerate");
  EXPECT_EQ(code_after([](render::CameraFile& f) {
              f.rotation_wxyz[2] = std::numeric_limits<double>::quiet_NaN();
            }),
            "camera.degenerate");
  EXPECT_EQ(code_after([](render::CameraFile& f) { f.fx = 0; }), "camera.bad_lens");
  EXPECT_EQ(code_after([](render::CameraFile& f) { f.distortion[0] = -1; }), "camera.bad_lens");
}

}  // namespace
}  // namespace marketgen
