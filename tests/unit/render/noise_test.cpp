// Sensor noise: its size, its steps, where depth is missing, and that it hangs on seed and frame
// number only.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "base/parallel.h"
#include "render/sensor/color_noise.h"
#include "render/sensor/depth_noise.h"

namespace marketgen {
namespace {

render::Camera sensor_camera(int width = 640, int height = 480) {
  render::Camera camera;
  camera.name = "sensor";
  camera.from = {0, 0, 1};
  camera.at = {0, 1, 1};
  camera.width = width;
  camera.height = height;
  return camera;
}

// A wall square to the axis.
render::Frame wall(const render::Camera& camera,
                   float depth_m,
                   render::Matter matter = render::Matter::solid) {
  const auto count = static_cast<std::size_t>(camera.width * camera.height);
  render::Frame frame;
  frame.color = Image(camera.width, camera.height);
  std::fill(frame.color.pixels.begin(), frame.color.pixels.end(), std::uint8_t{128});
  frame.depth_m.assign(count, depth_m);
  frame.instance.assign(count, 1);
  frame.matter.assign(count, static_cast<std::uint8_t>(matter));
  for (std::size_t i = 0; i < count; ++i)
    frame.normals.insert(frame.normals.end(), {0.0F, -1.0F, 0.0F});
  return frame;
}

std::vector<float> measured(const render::Frame& frame,
                            const render::Camera& camera,
                            render::NoiseSource source = {}) {
  return render::noisy_depth(frame, camera, render::StereoCamera{}, source).value();
}

double share_without(const std::vector<float>& depth_m, int width, int from_column, int to_column) {
  double missing = 0, count = 0;
  for (std::size_t i = 0; i < depth_m.size(); ++i) {
    const int x = static_cast<int>(i) % width;
    if (x < from_column || x >= to_column) continue;
    ++count;
    missing += depth_m[i] == 0 ? 1 : 0;
  }
  return missing / count;
}

// Of 0.08 px, and what rounding to 1/32 px adds: 0.08^2 + (1/32)^2 / 12.
TEST(DepthNoise, DisparityHasTheNoiseAndTheStepsOfTheSensor) {
  const render::Camera camera = sensor_camera();
  const std::vector<float> depth = measured(wall(camera, 2), camera);
  const double scale = render::intrinsics_of(camera).fx * 0.05, truth = scale / 2;
  double sum = 0, squares = 0, count = 0;
  std::set<long> steps;
  for (const float d : depth) {
    if (d == 0) continue;
    const double disparity = scale / static_cast<double>(d);
    EXPECT_NEAR(disparity * 32, std::round(disparity * 32), 1e-3);
    steps.insert(std::lround(disparity * 32));
    sum += disparity - truth;
    squares += (disparity - truth) * (disparity - truth);
    ++count;
  }
  EXPECT_GT(count, 0.95 * 640 * 480);
  // 290,000 pixels that err alike in windows of 49 are as good as 6,000: 1 % of sigma.
  EXPECT_NEAR(std::sqrt(squares / count), std::sqrt(0.08 * 0.08 + 1.0 / (32 * 32 * 12)), 2e-3);
  EXPECT_NEAR(sum / count, 0, 4e-3);
  EXPECT_GT(steps.size(), 10U);
}

// Of the errors of pixels dx and dy apart: the share of their windows of 7 x 7 that both have.
// z^2 * sigma / (fx * baseline), the error of depth of Intel's tuning guide.
TEST(DepthNoise, GrowsWithTheSquareOfTheDistance) {
  const render::Camera camera = sensor_camera();
  const double fx = 240 / std::tan(std::numbers::pi / 6);  // 480 rows, 60 degrees
  for (const double z : {0.4, 0.7, 1.2, 2.5, 4.0}) {
    double squares = 0, count = 0;
    for (const float d : measured(wall(camera, static_cast<float>(z)), camera)) {
      if (d == 0) continue;
      squares += (static_cast<double>(d) - z) * (static_cast<double>(d) - z);
      ++count;
    }
    const double sigma_px = std::hypot(0.08, 1.0 / 32 / std::sqrt(12)),
                 expected = z * z * sigma_px / (fx * 0.05);
    EXPECT_NEAR(std::sqrt(squares / count) / expected, 1, 0.04) << z << " m";
  }
}

TEST(DepthNoise, NeighboursErrAlikeAsFarAsTheirWindowsOverlap) {
  const render::Camera camera = sensor_camera(1280, 960);
  render::StereoCamera fine;
  fine.disparity_step_px = 1e-4;  // rounding is independent from pixel to pixel
  const std::vector<float> depth = render::noisy_depth(wall(camera, 2), camera, fine, {}).value();
  const double scale = render::intrinsics_of(camera).fx * 0.05;
  const auto error = [&](int x, int y) {
    const float d = depth[static_cast<std::size_t>(y * camera.width + x)];
    return scale / static_cast<double>(d) - scale / 2;
  };
  const auto correlation = [&](int dx, int dy) {
    double product = 0, square = 0;
    for (int y = 0; y + dy < camera.height; ++y) {
      for (int x = 100; x + dx < camera.width; ++x)
        product += error(x, y) * error(x + dx, y + dy), square += error(x, y) * error(x, y);
    }
    return product / square;
  };
  EXPECT_NEAR(correlation(1, 0), 6.0 / 7, 0.02);
  EXPECT_NEAR(correlation(0, 3), 4.0 / 7, 0.02);
  EXPECT_NEAR(correlation(3, 3), 16.0 / 49, 0.02);
  EXPECT_NEAR(correlation(7, 0), 0, 0.03);
  EXPECT_NEAR(correlation(0, 12), 0, 0.03);
}

// A matching window that holds the edge of a near thing takes its depth: what is near is a pixel
// wider on the side that both eyes see, above and below.
TEST(DepthNoise, NearThingsAreMeasuredTooWide) {
  const render::Camera camera = sensor_camera();
  render::Frame frame = wall(camera, 2);
  for (int y = 200; y < 240; ++y) {
    for (int x = 300; x < 340; ++x)
      frame.depth_m[static_cast<std::size_t>(y * camera.width + x)] = 1;
  }
  const std::vector<float> depth = measured(frame, camera);
  const auto near_share = [&](int x0, int x1, int y0, int y1) {
    double near = 0;
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x)
        near += depth[static_cast<std::size_t>(y * camera.width + x)] < 1.33F ? 1 : 0;
    }
    return near / ((x1 - x0) * (y1 - y0));
  };
  EXPECT_GT(near_share(340, 341, 205, 235), 0.6);  // the wall beside it
  EXPECT_GT(near_share(305, 335, 240, 241), 0.6);  // and below
  EXPECT_GT(near_share(339, 340, 205, 235), 0.9);  // its own last column
  EXPECT_LT(near_share(342, 343, 205, 235), 0.1);
}

// The right eye, 50 mm beside the left, does not see the left edge: fx * baseline / depth pixels.
TEST(DepthNoise, TheLeftEdgeHasNoDepth) {
  const render::Camera camera = sensor_camera();
  const std::vector<float> depth = measured(wall(camera, 1), camera);
  const int band = static_cast<int>(render::intrinsics_of(camera).fx * 0.05);  // 20 pixels
  EXPECT_EQ(band, 20);
  EXPECT_EQ(share_without(depth, camera.width, 0, band), 1);
  EXPECT_EQ(share_without(depth, camera.width, band + 1, camera.width), 0);
}

TEST(DepthNoise, WhatIsTooNearOrTooFarHasNoDepth) {
  const render::Camera camera = sensor_camera();
  const double least = render::min_depth_m(render::StereoCamera{}, render::intrinsics_of(camera));
  EXPECT_NEAR(least, 415.69 * 0.05 / 126, 1e-4);  // 165 mm
  EXPECT_EQ(share_without(
                measured(wall(camera, static_cast<float>(least * 0.98)), camera), 640, 200, 640),
            1);
  EXPECT_EQ(share_without(
                measured(wall(camera, static_cast<float>(least * 1.02)), camera), 640, 200, 640),
            0);
  EXPECT_EQ(share_without(measured(wall(camera, 12), camera), 640, 100, 640), 1);
}

// The datasheet's least depths of the D435, whose picture is 87 degrees wide at 16:9, 75 at 4:3.
TEST(DepthNoise, LeastDepthIsTheDatasheets) {
  struct Row {
    int width;
    double fov_deg, datasheet_m;
  };
  for (const Row& row : {Row{1280, 87, 0.280}, {848, 87, 0.195}, {640, 75, 0.175}}) {
    const double fx = row.width / 2.0 / std::tan(row.fov_deg * 3.14159265 / 360);
    const double least = render::min_depth_m(render::StereoCamera{}, {fx, fx, 0, 0, {}});
    EXPECT_NEAR(least, row.datasheet_m, 0.1 * row.datasheet_m) << row.width;
  }
}

// A post before a wall hides from the right eye a strip of wall to the post's left, as wide as the
// two disparities differ.
TEST(DepthNoise, APostCastsAStereoShadow) {
  const render::Camera camera = sensor_camera();
  render::Frame frame = wall(camera, 2);
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 300; x < 340; ++x)
      frame.depth_m[static_cast<std::size_t>(y * camera.width + x)] = 1;
  }
  const std::vector<float> depth = measured(frame, camera);
  const int shadow =
      static_cast<int>(render::intrinsics_of(camera).fx * 0.05 * (1.0 - 0.5));  // 10 pixels
  EXPECT_EQ(share_without(depth, camera.width, 300 - shadow, 300), 1);
  EXPECT_EQ(share_without(depth, camera.width, 300 - 3 * shadow, 300 - shadow - 2), 0);
  EXPECT_EQ(share_without(depth, camera.width, 302, 338), 0);
  // On its right side, both eyes see the wall; pixels at the edge fly between post and wall.
  int between = 0;
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 337; x < 343; ++x) {
      const float d = depth[static_cast<std::size_t>(y * camera.width + x)];
      between += d > 1.1F && d < 1.8F ? 1 : 0;
    }
  }
  EXPECT_GT(between, camera.height / 4);
}

TEST(DepthNoise, GlassAndClearPacksHaveHolesAndMetalAtAGlance) {
  const render::Camera camera = sensor_camera();
  EXPECT_NEAR(share_without(measured(wall(camera, 1, render::Matter::glass), camera), 640, 40, 640),
              0.5,
              0.1);
  EXPECT_NEAR(share_without(measured(wall(camera, 1, render::Matter::clear), camera), 640, 40, 640),
              0.35,
              0.12);
  EXPECT_EQ(share_without(measured(wall(camera, 1, render::Matter::none), camera), 640, 40, 640),
            1);
  render::Frame metal = wall(camera, 1, render::Matter::metal);
  EXPECT_EQ(share_without(measured(metal, camera), 640, 40, 640), 0);  // seen squarely
  for (std::size_t i = 0; i < metal.depth_m.size(); ++i) {
    metal.normals[3 * i] = std::sqrt(1 - 0.01F);  // nearly edge on
    metal.normals[3 * i + 1] = -0.1F;
  }
  EXPECT_GT(share_without(measured(metal, camera), 640, 280, 360), 0.99);
  render::Frame glare = wall(camera, 1);
  std::fill(glare.color.pixels.begin(), glare.color.pixels.end(), std::uint8_t{255});
  EXPECT_EQ(share_without(measured(glare, camera), 640, 40, 640), 1);
}

TEST(DepthNoise, SeedAndFrameDecideItAndThreadsDoNot) {
  const render::Camera camera = sensor_camera(160, 120);
  const render::Frame frame = wall(camera, 2, render::Matter::glass);
  const std::vector<float> first = measured(frame, camera, {7, 3});
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(measured(frame, camera, {7, 3}), first);
  }
  const std::vector<float> later = measured(frame, camera, {7, 4});
  EXPECT_NE(later, first);
  EXPECT_NE(measured(frame, camera, {8, 3}), first);
  for (std::size_t i = 0; i < first.size(); ++i)
    EXPECT_EQ(first[i] == 0, later[i] == 0) << "holes stay where they are";
}

TEST(DepthNoise, NeedsAPairOfEyes) {
  render::Camera camera = sensor_camera(16, 16);
  camera.ortho_height_m = 3;
  const auto none = render::noisy_depth(wall(camera, 2), camera, render::StereoCamera{}, {});
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.error().code, "camera.degenerate");
}

// Mid grey 128 is 0.2159 of white: 971 electrons of 4500, sigma sqrt(971 + 16) = 31.4, which is
// 0.00698 of white; the sRGB curve has the slope 2.0285 there, so 3.61 codes; rounding adds 1/12.
TEST(ColorNoise, GreyHasShotNoiseOfItsElectrons) {
  const render::Camera camera = sensor_camera(200, 200);
  Image grey(200, 200);
  std::fill(grey.pixels.begin(), grey.pixels.end(), std::uint8_t{128});
  render::ColorSensor sensor;
  sensor.vignette = 0;
  const Image noisy = render::noisy_color(grey, camera, sensor, {});
  double sum = 0, squares = 0;
  for (const std::uint8_t code : noisy.pixels)
    sum += code, squares += double(code) * code;
  const double count = static_cast<double>(noisy.pixels.size()), mean = sum / count;
  const double slope = 255 * 1.055 / 2.4 * std::pow(0.2159, 1 / 2.4 - 1) / 255;
  const double sigma = std::sqrt(971.4 + 16) / 4500 * slope * 255;
  EXPECT_NEAR(mean, 128, 0.15);
  EXPECT_NEAR(std::sqrt(squares / count - mean * mean), std::sqrt(sigma * sigma + 1.0 / 12), 0.05);
  EXPECT_EQ(render::noisy_color(grey, camera, sensor, {}).pixels, noisy.pixels);
  EXPECT_NE(render::noisy_color(grey, camera, sensor, {1, 1}).pixels, noisy.pixels);
}

TEST(ColorNoise, TheLensDarkensItsCorners) {
  const render::Camera camera = sensor_camera(200, 200);
  Image grey(200, 200);
  std::fill(grey.pixels.begin(), grey.pixels.end(), std::uint8_t{128});
  render::ColorSensor sensor;
  sensor.vignette = 1;
  sensor.read_noise_e = 0;
  sensor.full_well_e = 1e12;
  const Image noisy = render::noisy_color(grey, camera, sensor, {});
  EXPECT_EQ(noisy.at(100, 100)[1], 128);
  // Corner: cos^2 = 1 / (1 + 2 * 0.332), light 0.2159 * cos^4 = 0.0780, code 79.
  EXPECT_NEAR(noisy.at(0, 0)[1], 79, 1);
}

}  // namespace
}  // namespace marketgen
