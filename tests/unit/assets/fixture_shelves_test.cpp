// What the parameters of shelves do: spacing of each tier, thickness, slope, fence and header.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "fixture_table.h"

namespace marketgen {
namespace {

assets::FixtureShape gondola() {
  return shape_of("gondola", 1250, 1000, 2000, 5, 150, 350, 1);
}

double height_of(const assets::ShelfSurface& shelf) {
  return shelf.fixture_from_shelf.position.z;
}

const assets::FixturePart* first_of(const assets::FixtureModel& model, assets::UnitKind unit) {
  const auto found = std::ranges::find(model.parts, unit, &assets::FixturePart::unit);
  return found == model.parts.end() ? nullptr : &*found;
}

Error error_of(const assets::FixtureShape& shape) {
  const Result<assets::FixtureModel> model = assets::make_fixture_model(shape, small_catalog());
  EXPECT_FALSE(model.ok()) << text_of(shape);
  return model.ok() ? Error{} : model.error();
}

TEST(Shelves, StandAsTheListOfSpacingsSays) {
  assets::FixtureShape shape = gondola();
  shape.spacings_mm = {500, 300, 250};  // the fourth is spacing_mm
  const assets::FixtureModel model = made(shape, small_catalog());
  ASSERT_EQ(model.shelves.size(), 5U);
  const double heights[] = {0.150, 0.650, 0.950, 1.200, 1.550};
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(height_of(model.shelves[i]), heights[i], 1e-12);
  EXPECT_NEAR(model.shelves[0].clearance_m, 0.500 - 0.025 - 0.003, 1e-12);
  EXPECT_NEAR(model.shelves[2].clearance_m, 0.250 - 0.025 - 0.003, 1e-12);
}

TEST(Shelves, SpacingsThatDoNotFitShareTheHeightInTheirProportion) {
  assets::FixtureShape shape = gondola();
  shape.levels = 3;
  shape.height_mm = 1800;
  shape.spacings_mm = {1200, 600, 1500};  // twice the 1,650 mm over the base
  const assets::FixtureModel model = made(shape, small_catalog());
  ASSERT_EQ(model.shelves.size(), 3U);
  EXPECT_NEAR(height_of(model.shelves[1]), 0.150 + 0.600, 1e-12);
  EXPECT_NEAR(height_of(model.shelves[2]), 0.150 + 0.900, 1e-12);
}

TEST(Shelves, AThickerBoardTakesItsRoomFromTheGoodsUnderIt) {
  assets::FixtureShape shape = gondola();
  shape.board_mm = 45;
  const assets::FixtureModel model = made(shape, small_catalog());
  const assets::FixturePart* board = first_of(model, assets::UnitKind::board);
  ASSERT_NE(board, nullptr);
  EXPECT_NEAR(2 * double(board->half_size.z), 0.045, 1e-6);
  EXPECT_NEAR(model.shelves[0].clearance_m, 0.350 - 0.045 - 0.003, 1e-12);
  EXPECT_NEAR(height_of(model.shelves[1]), 0.500, 1e-12);  // its top stays
}

TEST(Shelves, SlopeTowardsTheShopperOverALevelBase) {
  assets::FixtureShape shape = gondola();
  shape.levels = 4;
  shape.shelf_tilt_deg = 10;
  const assets::FixtureModel model = made(shape, small_catalog());
  ASSERT_EQ(model.shelves.size(), 4U);
  const Vec3 level = rotate(model.shelves[0].fixture_from_shelf.rotation, {0, 1, 0});
  EXPECT_NEAR(level.z, 0, 1e-12);
  for (std::size_t i = 1; i < 4; ++i) {
    const Vec3 inward = rotate(model.shelves[i].fixture_from_shelf.rotation, {0, 1, 0});
    EXPECT_NEAR(inward.z, 0.17364817766693033, 1e-7);  // sin 10 degrees
    EXPECT_NEAR(inward.y, 0.98480775301220802, 1e-7);
    EXPECT_NEAR(height_of(model.shelves[i]), 0.150 + 0.350 * double(i), 1e-12);
  }
}

TEST(Shelves, AFenceStandsOnTheFrontEdge) {
  assets::FixtureShape shape = gondola();
  EXPECT_EQ(first_of(made(shape, small_catalog()), assets::UnitKind::fence), nullptr);
  shape.fence_mm = 80;
  const assets::FixtureModel model = made(shape, small_catalog());
  const assets::FixturePart* fence = first_of(model, assets::UnitKind::fence);
  ASSERT_NE(fence, nullptr);
  const double top = fence->fixture_from_part.position.z + double(fence->half_size.z);
  EXPECT_NEAR(top, 0.150 + 0.080, 1e-6);
  EXPECT_LT(fence->fixture_from_part.position.y, model.shelves[0].fixture_from_shelf.position.y);
  EXPECT_EQ(std::ranges::count(model.parts, assets::UnitKind::fence, &assets::FixturePart::unit),
            5);
}

TEST(Shelves, AHeaderIsAsHighAsItsNumber) {
  assets::FixtureShape shape = gondola();
  shape.header_mm = 200;
  shape.accent = "#ff0000";
  const assets::FixtureModel model = made(shape, small_catalog());
  const auto red = std::ranges::find_if(model.parts, [](const assets::FixturePart& p) {
    return p.surface.color == Vec3f{1, 0, 0};
  });
  ASSERT_NE(red, model.parts.end());
  EXPECT_NEAR(2 * double(red->half_size.z), 0.200, 1e-6);

  assets::FixtureShape wall = shape_of("wall_unit", 1250, 500, 2200, 5, 150, 350, 1);
  EXPECT_NE(first_of(made(wall, small_catalog()), assets::UnitKind::light), nullptr);
  wall.header_mm = 0;
  EXPECT_EQ(first_of(made(wall, small_catalog()), assets::UnitKind::light), nullptr);  // no canopy
}

TEST(Shelves, ProduceTiersTakeTheirSlopeAndFence) {
  assets::FixtureShape shape = shape_of("produce_table", 1250, 1100, 1200, 2, 500, 350, 1);
  shape.shelf_tilt_deg = 14;
  shape.fence_mm = 90;
  const assets::FixtureModel model = made(shape, small_catalog());
  for (const assets::ShelfSurface& shelf : model.shelves)
    EXPECT_NEAR(rotate(shelf.fixture_from_shelf.rotation, {0, 1, 0}).z, 0.24192189559966773, 1e-7);
  const assets::FixturePart* fence = first_of(model, assets::UnitKind::fence);
  ASSERT_NE(fence, nullptr);
  EXPECT_NEAR(2 * double(fence->half_size.z), 0.090 - 0.002, 1e-6);  // over the price rail
}

TEST(Shelves, WrongNumbersAreErrorsThatNameTheField) {
  const auto expect_error = [](auto change, const char* field) {
    assets::FixtureShape shape = gondola();
    change(shape);
    const Error error = error_of(shape);
    EXPECT_EQ(error.code, "assets.bad_row");
    EXPECT_NE(error.where.find(field), std::string::npos) << to_string(error);
  };
  expect_error([](assets::FixtureShape& s) { s.board_mm = 5; }, "board_mm");
  expect_error([](assets::FixtureShape& s) { s.shelf_tilt_deg = 40; }, "shelf_tilt_deg");
  expect_error([](assets::FixtureShape& s) { s.shelf_tilt_deg = std::nan(""); }, "shelf_tilt_deg");
  expect_error([](assets::FixtureShape& s) { s.fence_mm = 500; }, "fence_mm");
  expect_error([](assets::FixtureShape& s) { s.header_mm = 900; }, "header_mm");
  expect_error([](assets::FixtureShape& s) { s.spacings_mm = {20, 20}; }, "levels");
  expect_error(
      [](assets::FixtureShape& s) {
        s.levels = 15;
        s.shelf_tilt_deg = 25;
      },
      "shelf_tilt_deg");
}

}  // namespace
}  // namespace marketgen
