// Finding a product on a shelf, on boxes whose answer is known: which spot, which of several alike,
// and the top one of a stack.
#include <gtest/gtest.h>

#include <numbers>

#include "base/seed.h"
#include "perception/shelf_choice.h"
#include "support/drawn_boxes.h"

namespace marketgen {
namespace {

constexpr Rgb8 carton_red{200, 40, 30}, tea_green{40, 170, 60}, milk_white{235, 235, 230},
    board_grey{120, 120, 120};
constexpr Vec3 pack_size{0.06, 0.05, 0.12};
constexpr double board_z = 1.0, edge_x = 1.0;  // the robot looks along X
constexpr double front_behind_m = 0.015;

// Facing the robot: its right is -Y, into the shelf is +X.
Pose board_pose() {
  return {{edge_x, 0, board_z}, rotation_about({0, 0, 1}, -std::numbers::pi / 2)};
}

perception::BoardAhead board_ahead() {
  return {board_pose(), 1.0, 0.4, 0.4};
}

DrawnBox pack_at(double x, Rgb8 color, double z = 0, Vec3 size = pack_size) {
  return {board_pose() * Pose{{x, front_behind_m + size.y / 2, z}, {}}, size, plain(color)};
}

std::vector<perception::ViewCloud> look_at(std::vector<DrawnBox> boxes) {
  boxes.push_back(
      {board_pose() * Pose{{0, 0.2, -0.025}, {}}, {1.0, 0.4, 0.025}, plain(board_grey)});
  boxes.push_back({board_pose() * Pose{{0, 0.41, -1}, {}}, {1.2, 0.02, 2.5}, plain(board_grey)});
  const Vec3 ahead = normalized(Vec3{0.9, 0, -0.4});
  const Pose eye{{0.1, 0, 1.5}, rotation_with_axes(cross(ahead, {0, -1, 0}), ahead)};
  std::vector<perception::ViewCloud> views;
  views.emplace_back(drawn_view(boxes, eye, 640, 480, 460));
  return views;
}

perception::ProductLook look_of(const char* sku, Rgb8 color, Vec3 size = pack_size) {
  auto made = perception::ProductLook::make(sku, drawn_pictures(size, plain(color)));
  if (!made.ok()) fatal(to_string(made.error()).c_str());
  return std::move(made).value();
}

std::vector<perception::FoundOnShelf> find_on_shelf(
    const perception::WantedProduct& wanted, const std::vector<perception::ViewCloud>& views) {
  const std::vector<perception::BoardAhead> boards{board_ahead()};
  const Vec3f size = wanted.look->high() - wanted.look->low();
  return perception::UprightMatching().find(
      wanted, views, boards, perception::SweptSpots().spots(views, boards, size));
}

double off_from(const perception::FoundOnShelf& found, const DrawnBox& truth) {
  return length(found.pose.base_from_product.position - truth.pose.position);
}

TEST(SweptSpots, LieOnTheFrontsThatWereMeasured) {
  const auto views = look_at({pack_at(-0.2, carton_red), pack_at(0.1, tea_green)});
  const auto spots = perception::SweptSpots().spots(views, {board_ahead()}, to_float(pack_size));
  ASSERT_FALSE(spots.empty());
  bool near_first = false;
  for (const perception::ShelfSpot& spot : spots) {
    if (std::abs(spot.x_m + 0.2) > 0.003) continue;
    near_first = true;
    EXPECT_NEAR(spot.front_m, front_behind_m, 0.003);
  }
  EXPECT_TRUE(near_first);
  EXPECT_TRUE(perception::SweptSpots().spots(views, {board_ahead()}, {0.06F, 0.05F, 0.5F}).empty())
      << "higher than the shelf's clearance";
}

TEST(UprightMatching, FindsTheOneThatIsAskedFor) {
  const std::vector<DrawnBox> packs{
      pack_at(-0.2, carton_red), pack_at(0.1, tea_green), pack_at(0.3, milk_white)};
  const auto views = look_at(packs);
  const perception::ProductLook green = look_of("tea", tea_green);
  const auto found = find_on_shelf({&green, {}}, views);
  ASSERT_FALSE(found.empty());
  EXPECT_LT(off_from(found.front(), packs[1]), 0.005);
}

TEST(UprightMatching, WhatARivalExplainsBetterIsLeftOut) {
  const auto views = look_at({pack_at(-0.2, {190, 60, 50})});
  const perception::ProductLook red = look_of("red", carton_red),
                                meant = look_of("meant", {190, 60, 50});
  EXPECT_FALSE(find_on_shelf({&red, {}}, views).empty());
  EXPECT_TRUE(find_on_shelf({&red, {&meant}}, views).empty());
  EXPECT_FALSE(find_on_shelf({&meant, {&red}}, views).empty());
}

TEST(UprightMatching, TakesTheTopOfAStack) {
  const std::vector<DrawnBox> stack{pack_at(0, carton_red), pack_at(0, carton_red, pack_size.z)};
  const perception::ProductLook red = look_of("red", carton_red);
  const auto found = find_on_shelf({&red, {}}, look_at(stack));
  ASSERT_FALSE(found.empty());
  EXPECT_LT(off_from(found.front(), stack[1]), 0.006);
}

TEST(UprightMatching, TheFootOfSomethingTallerIsNotIt) {
  const auto tall = look_at({pack_at(0, carton_red, 0, {0.06, 0.05, 0.20})});
  const perception::ProductLook red = look_of("red", carton_red);
  EXPECT_TRUE(find_on_shelf({&red, {}}, tall).empty());
}

TEST(UprightMatching, FindsAgainWhatMovedALittle) {
  const DrawnBox pack = pack_at(0.05, carton_red);
  const auto views = look_at({pack});
  const perception::ProductLook red = look_of("red", carton_red);
  const Pose before = pack.pose * Pose{{0.012, -0.006, 0}, {}};
  const perception::FittedPose again = perception::UprightMatching().again({&red}, views, before);
  EXPECT_LT(length(again.base_from_product.position - pack.pose.position), 0.004);
  const Pose elsewhere = board_pose() * Pose{{-0.3, 0.1, 0}, {}};
  EXPECT_LT(perception::UprightMatching().again({&red}, views, elsewhere).evidence.score, 0.1);
}

double turned_by(const perception::FoundOnShelf& found) {
  return yaw_of((inverse(board_pose()) * found.pose.base_from_product).rotation);
}

// What is measured of a front errs by millimetres: that is no reason to take it for turned.
TEST(UprightMatching, IsFacedStraightUnlessItIsClearlyTurned) {
  const perception::ProductLook red = look_of("red", carton_red);
  std::vector<perception::ViewCloud> exact = look_at({pack_at(0.05, carton_red)});
  agent::View view = exact.front().view();
  Stream draw = Seed(5).stream();
  for (float& depth : view.depth_m)
    depth += 0.0015F * static_cast<float>(draw.normal());
  std::vector<perception::ViewCloud> noisy;
  noisy.emplace_back(std::move(view));
  const auto straight = find_on_shelf({&red, {}}, noisy);
  ASSERT_FALSE(straight.empty());
  EXPECT_NEAR(turned_by(straight.front()), 0, 1e-9);
  constexpr double turn = 0.3;
  DrawnBox turned = pack_at(0.05, carton_red);
  turned.pose.rotation = turned.pose.rotation * rotation_about({0, 0, 1}, turn);
  const auto found = find_on_shelf({&red, {}}, look_at({turned}));
  ASSERT_FALSE(found.empty());
  EXPECT_NEAR(turned_by(found.front()), turn, 0.1);
}

TEST(UprightMatching, ARivalOfAnySizeIsNotTakenForIt) {
  const Vec3 large{0.11, 0.09, 0.20};
  const DrawnBox jug = pack_at(0.05, {190, 60, 50}, 0, large);
  const auto views = look_at({jug});
  const perception::ProductLook red = look_of("red", carton_red),
                                meant = look_of("meant", {190, 60, 50}, large);
  // Its front on the jug's: a part of that looks like it.
  const Pose before = jug.pose * Pose{{0, (pack_size.y - large.y) / 2, 0}, {}};
  const auto again = [&](const perception::WantedProduct& wanted) {
    return perception::UprightMatching().again(wanted, views, before).evidence.score;
  };
  EXPECT_GT(again({&red}), 0.3);
  EXPECT_EQ(again({&red, {&meant}}), 0);
}

}  // namespace
}  // namespace marketgen
