// Where shelf pictures are taken, what they say of a shelf that was stocked by hand, and what their
// check sees.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "export/coco_cameras.h"
#include "export/coco_read.h"
#include "export/export.h"
#include "io/file.h"
#include "support/hand_made_scene.h"

namespace marketgen {
namespace {
namespace fs = std::filesystem;

constexpr double shelf_front_m = 3.48;          // of HandMadeScene, store frame
constexpr double focal_px = 360 / 0.577350269;  // 720 pixels over 60 degrees

class Coco : public testing::Test {
 protected:
  Coco() : folder_(fs::temp_directory_path() / ("marketgen-coco-" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
    one_camera_.camera_spacing_m = 5;  // one stop, in the middle of the shelf
    one_camera_.camera_heights_m = {0.6};
  }
  ~Coco() override { fs::remove_all(folder_); }

  fs::path file() const { return folder_ / "shelves.json"; }

  exporters::ReadCoco exported(const scene::Scene& scene) const {
    const Result<void> written = exporters::export_scene(scene, "coco", file(), one_camera_);
    EXPECT_TRUE(written.ok()) << to_string(written.error());
    const auto read = exporters::read_coco(file());
    EXPECT_TRUE(read.ok()) << to_string(read.error());
    return read.ok() ? *read : exporters::ReadCoco{};
  }
  // Annotations of one category in the only picture.
  static std::vector<exporters::ReadCocoAnnotation> of(const exporters::ReadCoco& coco,
                                                       const std::string& category) {
    std::vector<exporters::ReadCocoAnnotation> found = coco.annotations.at(1);
    std::erase_if(found,
                  [&](const auto& a) { return coco.categories.at(a.category).first != category; });
    return found;
  }
  std::string fault_of(const scene::Scene& scene, const std::string& text) const {
    EXPECT_TRUE(io::write_file(file(), text).ok());
    const auto checked = exporters::check_export(scene, "coco", file(), one_camera_);
    if (checked.ok()) return "";
    EXPECT_EQ(checked.error().code, "export.mismatch");
    return checked.error().where + ": " + checked.error().message;
  }

  fs::path folder_;
  exporters::ExportOptions one_camera_;
};

testing::AssertionResult names(const std::string& fault, const std::string& what) {
  if (fault.find(what) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "\"" << fault << "\" says nothing of " << what;
}

// What a camera in the shelf's middle, 1 m before it and 0.6 m up, sees of an upright rectangle:
// left, top, width, height, by the rule of three.
std::array<double, 4> seen_box(
    double left_m, double right_m, double low_m, double high_m, double y_m) {
  const double depth_m = y_m - (shelf_front_m - 1);
  const auto x = [&](double at_m) { return 639.5 + focal_px * (at_m - 3.0) / depth_m; };
  const auto y = [&](double at_m) { return 359.5 + focal_px * (0.6 - at_m) / depth_m; };
  return {x(left_m), y(high_m), x(right_m) - x(left_m), y(low_m) - y(high_m)};
}

void expect_box(const std::array<int, 4>& box, const std::array<double, 4>& wanted) {
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(box[i], wanted[i], 1.5) << "number " << i;
}

catalog::Catalog real_catalog() {
  return *catalog::load_catalog(*io::data_folder());
}

TEST(ShelfShots, StandEvenlyBeforeTheRunAndLookAtItSquarely) {
  HandMadeScene made;
  made.stock();
  const auto found = exporters::shelf_shots(made.scene, real_catalog(), {});
  ASSERT_EQ(found.shots.size(), 6U);  // a shelf of 1.24 m: three stops, two cameras each
  EXPECT_EQ(found.stops_without_room, 0);
  for (std::size_t i = 0; i < 6; ++i) {
    const exporters::ShelfShot& shot = found.shots[i];
    const Vec3 at = render::place_of(shot.camera), ahead = render::axes_of(shot.camera).ahead;
    EXPECT_NEAR(at.x, 2.38 + 1.24 / 3 * (static_cast<double>(i / 2) + 0.5), 1e-6);
    EXPECT_NEAR(at.y, shelf_front_m - 1, 1e-6);
    EXPECT_NEAR(at.z, i % 2 == 0 ? 0.6 : 1.5, 1e-9);
    EXPECT_NEAR(ahead.y, 1, 1e-9);
    EXPECT_EQ(shot.run, "dry/run-1");
  }
}

TEST(ShelfShots, ComeAsNearToTheDistanceAsTheFloorAllows) {
  HandMadeScene made;
  exporters::ExportOptions options;
  options.camera_distance_m = 4;  // the room's south wall is 3.48 m from the shelf
  const auto near = exporters::shelf_shots(made.scene, real_catalog(), options);
  ASSERT_FALSE(near.shots.empty());
  EXPECT_NEAR(near.shots.front().distance_m, shelf_front_m - 0.42, 0.051);
  made.scene.layout.fixtures.push_back(made.scene.layout.fixtures.front());  // a freezer before it
  made.scene.layout.fixtures.back().y_mm = 2700;
  made.scene.fixtures.push_back({0, 4, 0, 0, {3.0F, 2.7F, 0}, 0});
  const auto none = exporters::shelf_shots(made.scene, real_catalog(), {});
  EXPECT_TRUE(none.shots.empty());
  EXPECT_EQ(none.stops_without_room, 3);
}

TEST_F(Coco, AnEmptyFacingIsAGapWhereItsPacksWouldStand) {
  HandMadeScene made;
  made.stock();
  scene::Facing empty;  // cans, two wide; one column sold
  empty.shelf = 1, empty.sku = 1, empty.x_m = 0.9F, empty.width_m = 0.14F, empty.facings = 2;
  empty.position = 8;
  empty.first_product = static_cast<std::uint32_t>(made.scene.products.size());
  empty.product_count = 1;
  made.scene.products.push_back(
      {1, 8, {2.38F + 0.9F + 0.035F, 3.523F, HandMadeScene::upper_board_m}});
  made.scene.facings.push_back(empty);
  const exporters::ReadCoco coco = exported(made.scene);
  const auto gaps = of(coco, "gap");
  ASSERT_EQ(gaps.size(), 1U);
  EXPECT_EQ(gaps[0].sku, "can-cola");
  EXPECT_EQ(gaps[0].column, 2);
  EXPECT_EQ(gaps[0].place->shelf, 2);
  EXPECT_EQ(gaps[0].place->position, 9);
  expect_box(gaps[0].box, seen_box(3.35, 3.42, 0.55, 0.665, shelf_front_m + 0.01));
  EXPECT_EQ(fault_of(made.scene, *io::read_file(file())), "");
}

TEST_F(Coco, APriceTagHasItsPlaceAndWhatItSays) {
  HandMadeScene made;
  made.stock();
  const auto tags = of(exported(made.scene), "price_tag");
  ASSERT_EQ(tags.size(), 2U);
  EXPECT_EQ(tags[0].text,
            (std::vector<std::string>{
                "Fonda Cola", "330 ml", "0.99 \u20ac", "\u20ac 3.00 / l", "2000000000015"}));
  EXPECT_EQ(tags[0].sku, "can-cola");
  EXPECT_FALSE(tags[0].promotion);
  EXPECT_TRUE(tags[1].promotion);
  EXPECT_EQ(tags[1].text.front(), "SPECIAL OFFER");
  // The tags hang 6.8 mm before the board, their middles 18 mm below what packs stand on.
  const double y_m = shelf_front_m - 0.0068;
  expect_box(tags[0].box, seen_box(2.545, 2.615, 0.113, 0.151, y_m));
  EXPECT_DOUBLE_EQ(tags[0].occlusion, 0);
}

TEST_F(Coco, TagsThatAreMissingOrWrongSayWhatShouldHangThere) {
  HandMadeScene made;
  made.stock();
  made.scene.price_labels[0].price_cents = 129;
  made.scene.price_labels.pop_back();
  made.scene.facings[5].x_m = 0.2F, made.scene.facings[5].width_m = 0.2F;
  scene::ScenePart rail;  // before the upper board, as shelves have it
  rail.unit = assets::UnitKind::price_rail;
  rail.position_m = {0, -0.224F, HandMadeScene::upper_board_m - 0.018F};
  rail.half_size_m = {0.62F, 0.002F, 0.02F};
  made.scene.parts.push_back(rail);
  made.scene.fixtures[0].part_count = 5;
  const exporters::ReadCoco coco = exported(made.scene);
  const auto tags = of(coco, "price_tag"), missing = of(coco, "missing_price_tag");
  ASSERT_EQ(tags.size(), 1U);
  EXPECT_EQ(tags[0].fault, "wrong_price");
  EXPECT_EQ(tags[0].price, 1.29);
  EXPECT_EQ(tags[0].text[2], "1.29 \u20ac");
  ASSERT_EQ(missing.size(), 1U);  // blocks without a width have no place for one
  EXPECT_EQ(missing[0].sku, "box-cereal");
  EXPECT_EQ(missing[0].place->shelf, 2);
  const double rail_m = HandMadeScene::upper_board_m - 0.018, face_m = shelf_front_m - 0.006;
  expect_box(missing[0].box, seen_box(2.645, 2.715, rail_m - 0.019, rail_m + 0.019, face_m));
  EXPECT_EQ(fault_of(made.scene, *io::read_file(file())), "");
  made.scene.price_labels[0].price_cents = 99;  // the same pictures of another store
  const auto other = exported(made.scene);
  EXPECT_EQ(of(other, "price_tag")[0].fault, "");
  // A tag of cola where cereal belongs.
  const std::uint32_t cereal = made.scene.facings[5].sku;
  made.scene.price_labels[0].facing = 5, made.scene.price_labels[0].shelf = 1;
  const auto strange = of(exported(made.scene), "price_tag");
  ASSERT_EQ(strange.size(), 1U);
  EXPECT_EQ(strange[0].fault, "wrong_product");
  EXPECT_EQ(strange[0].sku, "can-cola");
  EXPECT_EQ(strange[0].planogram_sku, made.scene.catalog[cereal].sku);
}

// The same item alone in the store covers what its occlusion is measured by.
TEST_F(Coco, OcclusionIsTheShareThatOtherThingsHide) {
  HandMadeScene both, alone;
  const std::array<float, 3> at{3.0F, HandMadeScene::shelf_y_m, HandMadeScene::upper_board_m};
  const std::uint32_t cereal = both.add(0, at);
  both.add(1, {3.02F, HandMadeScene::shelf_y_m - 0.12F, HandMadeScene::upper_board_m});
  alone.add(0, at);
  const exporters::ReadCoco coco = exported(both.scene);
  const auto hidden = of(coco, "box-cereal"), can = of(coco, "can-cola");
  const auto whole = of(exported(alone.scene), "box-cereal");
  ASSERT_EQ(hidden.size() + can.size() + whole.size(), 3U);
  EXPECT_EQ(hidden[0].instance, scene::product_id(both.scene, cereal));
  EXPECT_GT(hidden[0].occlusion, 0.1);
  EXPECT_NEAR(hidden[0].occlusion, 1 - static_cast<double>(hidden[0].area) / whole[0].area, 2e-3);
  EXPECT_NEAR(whole[0].occlusion, 0, 2e-3);
  EXPECT_NEAR(can[0].occlusion, 0, 2e-3);
}

TEST_F(Coco, AnItemOfAnotherBlockIsMisplaced) {
  HandMadeScene made;
  made.stock();
  made.scene.products[0].sku = 2;  // an apple among the cans
  made.scene.products[0].flags = scene::product_misplaced;
  const auto apple = of(exported(made.scene), "fruit-apple");
  ASSERT_EQ(apple.size(), 1U);
  EXPECT_TRUE(apple[0].misplaced);
  EXPECT_EQ(apple[0].planogram_sku, "can-cola");
}

class FaultyCoco : public Coco {
 protected:
  FaultyCoco() {
    HandMadeScene made;
    made.stock();
    scene_ = made.scene;
    exported(scene_);
    text_ = *io::read_file(file());
  }
  // Of the text with the first `from` after `after` changed.
  std::string fault_with(const std::string& after, const std::string& from, const std::string& to) {
    std::string text = text_;
    const std::size_t place = text.find(from, text.find(after));
    EXPECT_NE(place, std::string::npos) << from;
    text.replace(place, from.size(), to);
    return fault_of(scene_, text);
  }

  scene::Scene scene_;
  std::string text_;
};

TEST_F(FaultyCoco, EachFaultIsNamedWithItsPlace) {
  EXPECT_EQ(fault_of(scene_, text_), "");
  EXPECT_TRUE(names(fault_with("\"annotations\"", "\"area\": ", "\"area\": 1"), "its area is 1"));
  EXPECT_TRUE(
      names(fault_with("\"annotations\"", "\"bbox\": [", "\"bbox\": [1"), "around its mask"));
  EXPECT_TRUE(names(fault_with("\"text\"", "\"price\": 0.99", "\"price\": 9.99"), "at 9.99 hangs"));
  EXPECT_TRUE(names(fault_with("\"text\"", "0.99 \u20ac", "0.89 \u20ac"), "does not say 0.99"));
  EXPECT_TRUE(
      names(fault_with("\"text\"", "\"promotion\": false", "\"promotion\": true"), "offer"));
  EXPECT_TRUE(names(fault_with("\"annotations\"", "\"misplaced\": false", "\"misplaced\": true"),
                    "the planogram has \"can-cola\" where \"can-cola\" stands"));
  EXPECT_TRUE(names(fault_with("\"annotations\"", "\"sku\": \"can-cola\"", "\"sku\": \"can-lime\""),
                    "is no \"can-lime\" but \"can-cola\""));
  EXPECT_TRUE(names(fault_with("\"annotations\"", "item-0", "item-7"), "has no item"));
  EXPECT_TRUE(names(fault_with("\"annotations\"", "\"position\": 1", "\"position\": 2"),
                    "stands in another place"));
  EXPECT_TRUE(
      names(fault_with("\"annotations\"", "\"image_id\": 1", "\"image_id\": 7"), "of picture 7"));
  EXPECT_TRUE(names(fault_with("\"annotations\"", "\"id\": 2", "\"id\": 1"), "annotation 1 twice"));
  EXPECT_TRUE(names(fault_with("\"categories\"", "fruit-apple", "fruit-pear"),
                    "its 6 categories are not the 3 products"));
  EXPECT_TRUE(names(fault_with("\"images\"", "color/000001", "color/000009"), "color/000009"));
  EXPECT_TRUE(names(fault_with("\"images\"", "shelves_assets/color", "../shelves_assets/color"),
                    "does not lie beside it"));
  EXPECT_TRUE(names(fault_with("\"scene_hash\"", "\"scene_hash\": \"", "\"scene_hash\": \"0"),
                    "of another store"));
}

// A picture of the same store from elsewhere shows other pixels.
TEST_F(FaultyCoco, AMovedCameraAndAMissingItemAreNoticed) {
  EXPECT_TRUE(names(fault_with("\"position_m\"", "[3", "[3.01"), "shelves.json, picture 1"));
  std::string text = text_;
  const std::size_t first = text.find("\n{\"id\": 1, \"image_id\"");
  text.erase(first, text.find('\n', first + 1) - first);
  EXPECT_TRUE(names(fault_of(scene_, text), "it has no annotation of"));
}

TEST_F(FaultyCoco, DepthOfAnotherPictureIsNoticed) {
  const fs::path depth = folder_ / "shelves_assets/depth/000001.png";
  HandMadeScene farther;
  farther.stock();
  for (scene::SceneProduct& item : farther.scene.products)
    item.position_m[1] -= 0.08F;
  exported(farther.scene);
  const std::string others = *io::read_file(depth);
  exported(scene_);
  ASSERT_TRUE(io::write_file(depth, others).ok());
  EXPECT_TRUE(names(fault_of(scene_, text_), "beside their items"));
}

TEST(CocoMask, MaskOfKnownRuns) {
  // 2 outside, 3 inside, 4 outside, of 9: the third run is not yet less the one two before.
  EXPECT_EQ(exporters::mask_pixels("234", 9), (std::vector<std::uint32_t>{2, 3, 4}));
  EXPECT_EQ(exporters::mask_pixels("234", 10), std::nullopt);
  EXPECT_EQ(exporters::mask_pixels("2\n", 9), std::nullopt);
}

TEST_F(Coco, OptionsOutOfRangeAreNamed) {
  HandMadeScene made;
  const auto fault = [&](auto change) {
    exporters::ExportOptions options;
    change(options);
    const auto written = exporters::export_scene(made.scene, "coco", file(), options);
    return written.ok() ? "" : written.error().code + " " + written.error().where;
  };
  EXPECT_EQ(fault([](auto& o) { o.camera_spacing_m = 0; }), "usage.bad_flag --camera-spacing");
  EXPECT_EQ(fault([](auto& o) { o.camera_distance_m = 0.1; }), "usage.bad_flag --camera-distance");
  EXPECT_EQ(fault([](auto& o) { o.camera_heights_m = {std::nan("")}; }),
            "usage.bad_flag --camera-height");
  EXPECT_EQ(fault([](auto& o) { o.picture_px = {0, 720}; }), "camera.bad_size --size");
  EXPECT_TRUE(fs::is_empty(folder_));
}

}  // namespace
}  // namespace marketgen
