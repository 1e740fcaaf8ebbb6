// Masks, recognition and poses, on boxes whose answer is known.
#include <gtest/gtest.h>

#include "perception/placed_surface.h"

#include <numbers>

#include "perception/grasp_source.h"
#include "perception/hidden_room.h"
#include "perception/target_choice.h"
#include "support/drawn_boxes.h"

namespace marketgen {
namespace {

constexpr Rgb8 red{200, 40, 30}, green{40, 170, 60}, white{235, 235, 230}, grey{120, 120, 120};
constexpr int width = 640, height = 480;  // as the station's cameras
constexpr double focal_px = 530;

// A table with a tall carton, a flat box that leans on nothing, and one that lies across the
// carton's foot.
std::vector<DrawnBox> table_with_goods() {
  return {{{{0.5, 0, -0.02}, {}}, {1.0, 1.0, 0.02}, plain(grey)},
          {{{0.45, 0.05, 0}, rotation_about({0, 0, 1}, 0.4)}, {0.06, 0.09, 0.12}, plain(red)},
          {{{0.60, -0.06, 0}, rotation_about({0, 0, 1}, -0.7)}, {0.05, 0.16, 0.04}, plain(green)}};
}

std::vector<std::uint8_t> over_table(const perception::ViewCloud& cloud) {
  return perception::goods_over(cloud, {{0, -0.5}, {1, 0.5}});
}

TEST(GeometricMasks, OneMaskForEachBoxWhateverItsSides) {
  std::vector<int> shown;
  const perception::ViewCloud cloud(drawn_view(
      table_with_goods(), camera_over({0.5, 0.1, 0.6}), width, height, focal_px, &shown));
  const std::vector<perception::Mask> masks =
      perception::GeometricMasks().masks(cloud, over_table(cloud));
  ASSERT_EQ(masks.size(), 2U);
  for (const perception::Mask& mask : masks) {
    const int box = shown[mask.pixels[mask.pixels.size() / 2]];
    double common = 0;
    for (const std::uint32_t pixel : mask.pixels)
      common += shown[pixel] == box ? 1 : 0;
    const auto all = static_cast<double>(std::ranges::count(shown, box));
    EXPECT_GT(common / static_cast<double>(mask.pixels.size()), 0.99) << box;
    EXPECT_GT(common / all, 0.8) << box;  // but for a seam at its edges
  }
}

TEST(ViewCloud, PointsProjectOntoTheirPixels) {
  const perception::ViewCloud cloud(
      drawn_view(table_with_goods(), camera_over({0.5, 0, 0.6}), width, height, focal_px));
  for (std::size_t pixel = 5; pixel < cloud.size(); pixel += 997) {
    const auto seen = cloud.project(cloud.point(pixel));
    ASSERT_TRUE(seen) << pixel;
    EXPECT_EQ(seen->pixel, pixel);
  }
}

class Matching : public ::testing::Test {
 protected:
  static perception::ProductLook look(const char* sku,
                                      Vec3 size,
                                      const std::array<Rgb8, 6>& colors) {
    auto made = perception::ProductLook::make(sku, drawn_pictures(size, colors));
    if (!made.ok()) fatal(to_string(made.error()).c_str());
    return std::move(made).value();
  }
  Matching() {
    for (const Vec3 eye : {Vec3{0.5, 0.1, 0.6}, Vec3{0.35, -0.1, 0.7}})
      views_.emplace_back(
          drawn_view(table_with_goods(), camera_over(eye), width, height, focal_px));
    for (std::size_t v = 0; v < views_.size(); ++v)
      masked_.push_back({v, perception::GeometricMasks().masks(views_[v], over_table(views_[v]))});
  }
  std::vector<perception::FoundProduct> find(
      const std::vector<const perception::ProductLook*>& looks) const {
    std::vector<perception::WantedProduct> wanted;
    for (const perception::ProductLook* look : looks)
      wanted.push_back({look, {}});
    return perception::CatalogueMatching(poses_).find(wanted, views_, masked_);
  }

  perception::SweptPoses poses_;
  std::vector<perception::ViewCloud> views_;
  std::vector<perception::MaskedView> masked_;
};

TEST_F(Matching, FindsProductsByShapeAndColourWithinMillimetres) {
  const perception::ProductLook carton = look("carton", {0.06, 0.09, 0.12}, plain(red));
  const perception::ProductLook box = look("box", {0.05, 0.16, 0.04}, plain(green));
  const auto found = find({&carton, &box});
  ASSERT_EQ(found.size(), 2U);
  const std::vector<DrawnBox> truth = table_with_goods();
  for (const perception::FoundProduct& f : found) {
    const perception::ProductLook& of = f.look == 0 ? carton : box;
    const Vec3 middle = to_double((of.low() + of.high()) * 0.5F);
    const Vec3 off = f.pose.base_from_product * middle - truth[f.look + 1].pose * middle;
    // Surfels end up to 3.5 mm before an edge, and plain sides have no print to hold on to.
    EXPECT_LT(length(off), 0.005) << of.sku();
    EXPECT_GT(f.pose.evidence.fit, 0.9);
  }
}

TEST(TwoOfOne, AreFoundWhereTwoAreWanted) {
  std::vector<DrawnBox> goods = table_with_goods();
  goods[2] = goods[1];
  goods[2].pose = {{0.62, -0.12, 0}, rotation_about({0, 0, 1}, -0.7)};
  std::vector<perception::ViewCloud> views;
  std::vector<perception::MaskedView> masked;
  for (const Vec3 eye : {Vec3{0.5, 0.1, 0.6}, Vec3{0.35, -0.1, 0.7}}) {
    views.emplace_back(drawn_view(goods, camera_over(eye), width, height, focal_px));
    masked.push_back({masked.size(),
                      perception::GeometricMasks().masks(views.back(), over_table(views.back()))});
  }
  const auto made =
      perception::ProductLook::make("carton", drawn_pictures({0.06, 0.09, 0.12}, plain(red)));
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  const perception::SweptPoses poses;
  const perception::CatalogueMatching matching(poses);
  EXPECT_EQ(matching.find({{&*made, {}, 1}}, views, masked).size(), 1U);
  const auto both = matching.find({{&*made, {}, 2}}, views, masked);
  ASSERT_EQ(both.size(), 2U);
  EXPECT_GT(
      length(both[0].pose.base_from_product.position - both[1].pose.base_from_product.position),
      0.1);
}

TEST_F(Matching, WhatIsNotThereIsNotFound) {
  const perception::ProductLook white_carton = look("white", {0.06, 0.09, 0.12}, plain(white));
  const perception::ProductLook slab = look("slab", {0.2, 0.2, 0.02}, plain(red));
  EXPECT_TRUE(find({&slab}).empty());
  // The right shape in the wrong colour comes behind the right one, and gives way to it.
  const perception::ProductLook carton = look("carton", {0.06, 0.09, 0.12}, plain(red));
  const auto found = find({&white_carton, &carton});
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.front().look, 1U);
}

TEST_F(Matching, WhatARivalExplainsBetterIsNotTaken) {
  const perception::ProductLook white_carton = look("white", {0.06, 0.09, 0.12}, plain(white));
  const perception::ProductLook carton = look("carton", {0.06, 0.09, 0.12}, plain(red));
  const perception::CatalogueMatching matching(poses_);
  const std::vector<perception::WantedProduct> wrong{
      perception::WantedProduct{&white_carton, {&carton}}};
  const std::vector<perception::WantedProduct> right{
      perception::WantedProduct{&carton, {&white_carton}}};
  EXPECT_TRUE(matching.find(wrong, views_, masked_).empty());
  EXPECT_EQ(matching.find(right, views_, masked_).size(), 1U);
}

TEST(ProductLook, PicturesWithoutTheProductAreAnError) {
  auto pictures = drawn_pictures({0.05, 0.05, 0.1}, plain(red));
  for (agent::ProductPicture& picture : pictures)
    std::ranges::fill(picture.depth_m, 0.0F);
  const auto made = perception::ProductLook::make("ghost", pictures);
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().code, "perception.no_picture");
}

// A crate of 24 bottles has 0.6 m2 of surface; every agent of a store that sells it knows it, too.
TEST(ProductLook, ACrateHasItsPiecesFartherApart) {
  const Vec3 size{0.4, 0.3, 0.3};
  const auto crate = perception::ProductLook::make("crate", drawn_pictures(size, plain(red)));
  ASSERT_TRUE(crate.ok()) << to_string(crate.error());
  EXPECT_LE(crate->surfels().size(), 30000U);
  EXPECT_GT(crate->surfels().size(), 15000U);
  EXPECT_NEAR(crate->diagonal_m(), length(size), 0.01);
}

// A carton hides what is behind it from a camera beside it, and nothing on the camera's side.
// Right under the eye, with a normal that is a little longer than one, as a look on disk has it.
TEST(ShownPiece, HasAToleranceWhenItIsSeenSquarely) {
  const perception::ViewCloud cloud(
      drawn_view(table_with_goods(), camera_over({0.5, 0.1, 0.6}), width, height, focal_px));
  const auto shown =
      perception::shown_piece(cloud, {0.5F, 0.1F, 0}, {0, 0, 1.00004F}, 0.25F, 0.003F);
  ASSERT_TRUE(shown);
  EXPECT_EQ(shown->tolerance_m, 0.003F);
}

TEST(HiddenRoom, IsBehindWhatIsSeen) {
  const std::vector<DrawnBox> goods{{{{0.5, 0, -0.02}, {}}, {1.0, 1.0, 0.02}, plain(grey)},
                                    {{{0.5, 0, 0}, {}}, {0.1, 0.1, 0.2}, plain(red)}};
  std::vector<perception::ViewCloud> views;
  views.emplace_back(drawn_view(goods, camera_over({0.5, 0.2, 0.6}), width, height, 300));
  const std::vector<robots::ToolSolid> finger{{{}, {0.008, 0.008, 0.03}}};
  const auto hidden = [&](double y, const perception::SeenIn& seen_in) {
    return perception::hidden_length_m(finger, {{0.5, y, 0.04}, {}}, seen_in);
  };
  EXPECT_EQ(hidden(0.09, {&views}), 0);
  EXPECT_NEAR(hidden(-0.09, {&views}), 0.06, 0.01);
  EXPECT_EQ(hidden(-0.09, {}), 0);
  // The same pictures, said in another frame.
  EXPECT_EQ(perception::hidden_length_m(finger, {{1.5, 0.09, 0.04}, {}}, {&views, {{1, 0, 0}, {}}}),
            0);
}

}  // namespace
}  // namespace marketgen
