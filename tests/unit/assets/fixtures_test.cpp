// What the numbers of a fixture's shape do, and what is wrong with wrong ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "fixture_table.h"
#include "oriented_box.h"

namespace marketgen {
namespace {

std::size_t count_units(const assets::FixtureModel& model, assets::UnitKind unit) {
  return static_cast<std::size_t>(
      std::count_if(model.parts.begin(), model.parts.end(), [&](const assets::FixturePart& part) {
        return part.unit == unit;
      }));
}

TEST(Fixtures, SidePanelsStandOnlyAtTheRunsEnds) {
  const catalog::Catalog catalog = small_catalog();
  assets::FixtureShape shape = shape_of("gondola", 1250, 940, 1800, 5, 150, 350, 2);
  EXPECT_EQ(count_units(made(shape, catalog), assets::UnitKind::side_panel), 2U);
  shape.end = false;
  EXPECT_EQ(count_units(made(shape, catalog), assets::UnitKind::side_panel), 1U);
  shape.start = false;
  EXPECT_EQ(count_units(made(shape, catalog), assets::UnitKind::side_panel), 0U);
}

TEST(Fixtures, GondolaStandsWhereItsNumbersSay) {
  const assets::FixtureModel model =
      made(shape_of("gondola", 1250, 940, 1800, 4, 150, 350, 2), small_catalog());
  ASSERT_EQ(model.shelves.size(), 8U);
  const assets::ShelfSurface& second = model.shelves[1];
  EXPECT_EQ(second.level, 1);
  EXPECT_EQ(second.side, 0);
  EXPECT_NEAR(second.fixture_from_shelf.position.y, -0.470 + 0.006, 1e-12);  // behind its rail
  EXPECT_NEAR(second.fixture_from_shelf.position.z, 0.150 + 0.350, 1e-12);
  EXPECT_NEAR(second.width_m, 1.250 - 2 * 0.020, 1e-12);          // between side panels
  EXPECT_NEAR(second.depth_m, 0.470 - 0.006 - 0.020, 1e-12);      // half a 40 mm spine
  EXPECT_NEAR(second.clearance_m, 0.350 - 0.025 - 0.003, 1e-12);  // board and slack
  EXPECT_NEAR(model.shelves[3].clearance_m, 0.350, 1e-12);        // open top
  const assets::ShelfSurface& behind = model.shelves[5];
  EXPECT_EQ(behind.side, 1);
  EXPECT_NEAR(behind.fixture_from_shelf.position.y, 0.470 - 0.006, 1e-12);
  EXPECT_EQ(behind.fixture_from_shelf.rotation, yaw_from_quarter_turns(2));
}

TEST(Fixtures, LevelsThatDoNotFitShareTheHeight) {
  const assets::FixtureModel model =
      made(shape_of("gondola", 1250, 500, 1800, 5, 150, 350, 1), small_catalog());
  ASSERT_EQ(model.shelves.size(), 5U);  // (1800 - 150) / 5 = 330 apart instead of 350
  EXPECT_NEAR(model.shelves[4].fixture_from_shelf.position.z, 0.150 + 4 * 0.330, 1e-12);
}

TEST(Fixtures, AnotherLevelAddsOneBoardAndOneRailASide) {
  const catalog::Catalog catalog = small_catalog();
  assets::FixtureShape shape = shape_of("gondola", 1250, 940, 2000, 4, 150, 300, 2);
  const assets::FixtureModel before = made(shape, catalog);
  shape.levels = 5;
  const assets::FixtureModel after = made(shape, catalog);
  EXPECT_EQ(count_units(after, assets::UnitKind::board),
            count_units(before, assets::UnitKind::board) + 2);
  EXPECT_EQ(count_units(after, assets::UnitKind::price_rail),
            count_units(before, assets::UnitKind::price_rail) + 2);
  EXPECT_EQ(after.parts.size(), before.parts.size() + 4);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(after.shelves[i].fixture_from_shelf.position,
              before.shelves[i].fixture_from_shelf.position);
  }
}

TEST(Fixtures, HeightLeavesTheBoardsWhereTheyAre) {
  const catalog::Catalog catalog = small_catalog();
  assets::FixtureShape shape = shape_of("gondola", 1250, 940, 1900, 5, 150, 350, 2);
  const assets::FixtureModel low = made(shape, catalog);
  shape.height_mm = 2200;
  const assets::FixtureModel high = made(shape, catalog);
  ASSERT_EQ(low.shelves.size(), high.shelves.size());
  for (std::size_t i = 0; i < low.shelves.size(); ++i) {
    EXPECT_EQ(low.shelves[i].fixture_from_shelf.position,
              high.shelves[i].fixture_from_shelf.position);
    EXPECT_EQ(low.shelves[i].depth_m, high.shelves[i].depth_m);
  }
}

TEST(Fixtures, DepthGoesToTheShelvesAlone) {
  const catalog::Catalog catalog = small_catalog();
  assets::FixtureShape shape = shape_of("multideck", 1250, 900, 2000, 4, 350, 350, 1);
  const assets::FixtureModel shallow = made(shape, catalog);
  shape.depth_mm = 1000;
  const assets::FixtureModel deep = made(shape, catalog);
  ASSERT_EQ(shallow.parts.size(), deep.parts.size());
  for (std::size_t i = 0; i < shallow.shelves.size(); ++i) {
    EXPECT_NEAR(deep.shelves[i].depth_m - shallow.shelves[i].depth_m, 0.1, 1e-9);
    EXPECT_EQ(deep.shelves[i].width_m, shallow.shelves[i].width_m);
    EXPECT_EQ(deep.shelves[i].clearance_m, shallow.shelves[i].clearance_m);
  }
}

TEST(Fixtures, ACoolerHasOnePaneForEveryDoorAndAHandleOnEach) {
  const catalog::Catalog catalog = small_catalog();
  for (const auto& [width, doors] : {std::pair{700, 1U}, {1250, 2U}, {1500, 2U}, {2100, 3U}}) {
    const assets::FixtureModel model =
        made(shape_of("glass_door_cooler", width, 710, 2200, 5, 250, 350, 1), catalog);
    std::size_t panes = 0;
    for (const assets::FixturePart& part : model.parts) {
      panes +=
          part.unit == assets::UnitKind::door && part.surface.kind == assets::SurfaceKind::glass
              ? 1
              : 0;
    }
    EXPECT_EQ(panes, doors) << width;
    EXPECT_EQ(count_units(model, assets::UnitKind::handle), 3 * doors)
        << width;  // a bar on two brackets
  }
}

TEST(Fixtures, CabinetsAndLanesAreLit) {
  const catalog::Catalog catalog = small_catalog();
  for (const assets::FixtureShape& shape : table()) {
    if (shape.generator != "multideck" && shape.generator != "glass_door_cooler") continue;
    const assets::FixtureModel model = made(shape, catalog);
    EXPECT_GE(count_units(model, assets::UnitKind::light), 1U) << text_of(shape);
    for (const assets::FixturePart& part : model.parts) {
      EXPECT_EQ(part.unit == assets::UnitKind::light,
                part.surface.kind == assets::SurfaceKind::emissive);
    }
  }
}

TEST(Fixtures, MaterialAndColoursComeFromTheShape) {
  const catalog::Catalog catalog = small_catalog();
  assets::FixtureShape shape = shape_of("pillar", 500, 500, 2600, 0, 0, 0, 1);
  shape.color = "#ff0000";
  const assets::Surface painted = made(shape, catalog).parts.front().surface;
  EXPECT_EQ(painted.color, (Vec3f{1, 0, 0}));
  EXPECT_EQ(painted.texture, "");
  EXPECT_FLOAT_EQ(painted.roughness, 0.4F);
  shape.material = "wood-oak";
  EXPECT_EQ(made(shape, catalog).parts.front().surface.texture, "wood-oak");
}

TEST(Fixtures, BadShapesAreErrorsThatSayWhatToDo) {
  const catalog::Catalog catalog = small_catalog();
  const auto error_of = [&](const assets::FixtureShape& shape) {
    const Result<assets::FixtureModel> model = assets::make_fixture_model(shape, catalog);
    EXPECT_FALSE(model.ok()) << text_of(shape);
    return model.ok() ? Error{} : model.error();
  };
  const assets::FixtureShape good = shape_of("gondola", 1250, 940, 1800, 5, 150, 350, 2);

  assets::FixtureShape shape = good;
  shape.generator = "gondolla";
  EXPECT_EQ(error_of(shape).code, "catalog.unknown_kind");
  EXPECT_NE(error_of(shape).message.find("\"gondola\""), std::string::npos);

  shape = good;
  shape.material = "metal-whit";
  EXPECT_EQ(error_of(shape).code, "catalog.unknown_kind");
  EXPECT_NE(error_of(shape).message.find("\"metal-white\""), std::string::npos);

  shape = good;
  shape.color = "white";
  EXPECT_EQ(error_of(shape).code, "assets.bad_row");

  shape = good;
  shape.levels = 40;
  EXPECT_EQ(error_of(shape).code, "assets.bad_row");
  EXPECT_NE(error_of(shape).message.find("at most 20"), std::string::npos);  // (1800 - 150) / 80

  shape = good;
  shape.levels = 0;
  EXPECT_EQ(error_of(shape).code, "assets.bad_row");

  shape = good;
  shape.depth_mm = 100;
  EXPECT_EQ(error_of(shape).code, "assets.bad_row");
  EXPECT_NE(error_of(shape).message.find("at least"), std::string::npos);

  shape = good;
  shape.sides = 3;
  EXPECT_EQ(error_of(shape).code, "assets.bad_row");
}

TEST(Fixtures, PartMeshesAreClosedAndAsLargeAsTheirParts) {
  const catalog::Catalog catalog = small_catalog();
  for (const assets::FixtureShape& shape : table()) {
    for (const assets::FixturePart& part : made(shape, catalog).parts) {
      Mesh mesh;
      assets::add_part_mesh(mesh, part, 7);
      ASSERT_TRUE(is_watertight(mesh)) << text_of(shape);
      const Vec3f half = part.half_size;
      const double box = 8.0 * double(half.x) * double(half.y) * double(half.z);
      // A cylinder of 24 sides fills 24/2 sin(2 pi/24) / 4 of its box; bevels take a little of
      // either.
      const double full = part.shape == assets::PartShape::box ? box : box * 0.776457;
      EXPECT_NEAR(volume_of(mesh) / full, 1.0, 0.06) << name_of(part.unit);
      const OrientedBox bounds = oriented_box(part);
      for (const Vec3f& p : mesh.positions)
        ASSERT_TRUE(contains(bounds, to_double(p), 1e-5));
      for (const std::uint16_t surface : mesh.surfaces)
        ASSERT_EQ(surface, 7);
    }
  }
}

TEST(Fixtures, TextureCoordinatesAreMetres) {
  assets::FixturePart board;
  board.half_size = {0.6F, 0.25F, 0.0125F};
  Mesh mesh;
  assets::add_part_mesh(mesh, board, 0);
  // Any triangle without bevel: as long in UV as in space.
  double stretch_sum = 0;
  for (const auto& t : mesh.triangles) {
    const Vec3f edge = mesh.positions[t[1]] - mesh.positions[t[0]];
    const Vec2f uv = mesh.uvs[t[1]] - mesh.uvs[t[0]];
    if (length(edge) > 0.1F) {
      const double ratio = std::sqrt(double(uv.x * uv.x + uv.y * uv.y)) / double(length(edge));
      EXPECT_NEAR(ratio, 1.0, 0.02);
      stretch_sum += ratio;
    }
  }
  EXPECT_GT(stretch_sum, 0);
}

}  // namespace
}  // namespace marketgen
