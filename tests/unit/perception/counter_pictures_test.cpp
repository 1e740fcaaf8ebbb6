// What is made of a counter's pictures before anything is looked for in them, on drawn boxes.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/seed.h"
#include "perception/camera_correction.h"
#include "perception/seen_basket.h"
#include "support/drawn_boxes.h"

namespace marketgen {
namespace {

constexpr int across_px = 320, down_px = 240;
constexpr double drawn_focal_px = 265;
constexpr double degree = std::numbers::pi / 180;
constexpr Rgb8 of_counter{120, 120, 120}, of_basket{40, 60, 180}, of_goods{200, 40, 30};

agent::Workplace counter_with_basket() {
  agent::Workplace place;
  place.counter = {{-0.25, -0.95}, {0.85, 0.95}};
  place.base_from_basket = {{0.52, 0, 0.003}, {}};
  place.rim_m = 0.15;
  place.wall_m = 0.01;
  place.inner_half = {0.15, 0.215, 0};
  // Outer faces are towards their own +X.
  const double half_z = 0.075, off = place.wall_m / 2;
  const auto wall = [&](Vec3 at, double turn, double half_y) {
    place.walls.push_back({{at, rotation_about({0, 0, 1}, turn)}, {off, half_y, half_z}});
  };
  wall({0.15 + off, 0, half_z}, 0, 0.225);
  wall({-0.15 - off, 0, half_z}, std::numbers::pi, 0.225);
  wall({0, 0.215 + off, half_z}, std::numbers::pi / 2, 0.15);
  wall({0, -0.215 - off, half_z}, -std::numbers::pi / 2, 0.15);
  return place;
}

// The counter, the basket where it truly stands, and goods in it.
std::vector<DrawnBox> drawn(const agent::Workplace& place, const Pose& base_from_basket) {
  std::vector<DrawnBox> boxes{{{{0.3, 0, -0.02}, {}}, {1.1, 1.9, 0.02}, plain(of_counter)}};
  for (const agent::WorkBox& wall : place.walls)
    boxes.push_back({base_from_basket * wall.pose * Pose{{0, 0, -wall.half_size.z}, {}},
                     wall.half_size * 2,
                     plain(of_basket)});
  boxes.push_back({base_from_basket * Pose{{0.03, 0.05, 0}, rotation_about({0, 0, 1}, 0.5)},
                   {0.08, 0.12, 0.09},
                   plain(of_goods)});
  boxes.push_back({base_from_basket * Pose{{-0.05, -0.1, 0}, rotation_about({0, 0, 1}, -0.3)},
                   {0.06, 0.07, 0.2},
                   plain(of_goods)});
  return boxes;
}

agent::View seen_from(const std::vector<DrawnBox>& boxes, Vec3 eye) {
  return drawn_view(boxes, camera_over(eye), across_px, down_px, drawn_focal_px);
}

const Vec3 high{0.66, 0, 0.95}, low{0.46, 0.02, 0.5};

agent::View noisy(agent::View view, std::uint64_t number) {
  Stream draw = Seed(7).child("noise", number).stream();
  for (float& depth : view.depth_m)
    if (depth > 0) depth += static_cast<float>(0.002 * draw.normal());
  return view;
}

TEST(SeenBasket, IsWhereItStandsNotWhereItIsSaidTo) {
  const agent::Workplace place = counter_with_basket();
  for (const Pose& shift : {Pose{{0.021, -0.017, 0}, rotation_about({0, 0, 1}, 3 * degree)},
                            Pose{{-0.03, 0.03, 0}, rotation_about({0, 0, 1}, -5 * degree)},
                            Pose{{}, {}}}) {
    const Pose truth{place.base_from_basket.position + shift.position, shift.rotation};
    const auto boxes = drawn(place, truth);
    std::vector<perception::ViewCloud> views;
    for (const Vec3 eye : {high, low})
      views.emplace_back(noisy(seen_from(boxes, eye), 1));
    const auto found = perception::seen_basket(views, place, 0.04, 0.12);
    ASSERT_TRUE(found);
    EXPECT_LT(length(found->position - truth.position), 0.002);
    EXPECT_LT(turn_between(found->rotation, truth.rotation), 0.5 * degree);
  }
}

TEST(SeenBasket, IsNowhereWhereNoneStands) {
  const agent::Workplace place = counter_with_basket();
  const std::vector<DrawnBox> bare{{{{0.3, 0, -0.02}, {}}, {1.1, 1.9, 0.02}, plain(of_counter)}};
  std::vector<perception::ViewCloud> views;
  views.emplace_back(seen_from(bare, high));
  EXPECT_FALSE(perception::seen_basket(views, place, 0.04, 0.12));
}

TEST(ViewCloud, MovedIsAsIfItHadBeenTakenFromThere) {
  const agent::Workplace place = counter_with_basket();
  const Pose way{{0.01, -0.02, 0.005}, rotation_about(normalized(Vec3{1, 2, -1}), 0.05)};
  agent::View view = seen_from(drawn(place, place.base_from_basket), low);
  perception::ViewCloud moved(view);
  moved.move(way);
  view.base_from_camera = way * view.base_from_camera;
  const perception::ViewCloud there(view);
  for (std::size_t i = 0; i < there.size(); ++i) {
    ASSERT_LT(length(moved.point(i) - there.point(i)), 1e-6F) << i;
    ASSERT_LT(length(moved.normal(i) - there.normal(i)), 1e-4F) << i;
  }
}

std::vector<agent::View> corrected_views(const std::vector<agent::View>& said,
                                         const agent::Workplace& place) {
  std::vector<perception::ViewCloud> clouds(said.begin(), said.end());
  perception::correct_cameras(clouds, place);
  std::vector<agent::View> views;
  for (const perception::ViewCloud& cloud : clouds)
    views.push_back(cloud.view());
  return views;
}

TEST(CorrectedViews, AgreeWithTheCounterAndWithEachOther) {
  const agent::Workplace place = counter_with_basket();
  const auto boxes = drawn(place, place.base_from_basket);
  std::vector<agent::View> truth;
  for (const Vec3 eye : {high, low})
    truth.push_back(seen_from(boxes, eye));
  std::vector<agent::View> said = truth;
  const Pose off{{0.003, -0.004, 0.004}, rotation_about(normalized(Vec3{1, -1, 0.5}), 0.004)};
  said[0].base_from_camera = off * said[0].base_from_camera;
  const auto views = corrected_views(said, place);
  // Where the two take a point of the heap for, one against the other and over the counter.
  const Vec3 point{0.52, 0.05, 0.09};
  const auto taken_for = [&](const std::vector<agent::View>& as, std::size_t v) {
    return as[v].base_from_camera * (inverse(truth[v].base_from_camera) * point);
  };
  EXPECT_GT(length(taken_for(said, 0) - taken_for(said, 1)), 0.004);
  EXPECT_LT(length(taken_for(views, 0) - taken_for(views, 1)), 0.0015);
  for (std::size_t v = 0; v < views.size(); ++v)
    EXPECT_NEAR(taken_for(views, v).z, point.z, 0.001) << v;
}

TEST(CorrectedViews, WhatIsRightStays) {
  const agent::Workplace place = counter_with_basket();
  const auto boxes = drawn(place, place.base_from_basket);
  std::vector<agent::View> said;
  for (const Vec3 eye : {high, low})
    said.push_back(seen_from(boxes, eye));
  const auto views = corrected_views(said, place);
  for (std::size_t v = 0; v < views.size(); ++v) {
    EXPECT_LT(length(views[v].base_from_camera.position - said[v].base_from_camera.position),
              0.001);
    EXPECT_LT(turn_between(views[v].base_from_camera.rotation, said[v].base_from_camera.rotation),
              0.1 * degree);
  }
}

}  // namespace
}  // namespace marketgen
