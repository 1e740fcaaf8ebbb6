// Every fixture generator keeps the promises of assets/fixtures/fixture_model.h: at the sizes of
// the table, anywhere in a run, and over the whole range of every row of data/fixtures.json.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "fixture_table.h"
#include "oriented_box.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

constexpr double tolerance_m = 0.0005;

// The four places of a module in its run.
std::vector<assets::FixtureShape> placings(const assets::FixtureShape& shape) {
  std::vector<assets::FixtureShape> result;
  for (const bool start : {true, false}) {
    for (const bool end : {true, false}) {
      result.push_back(shape);
      result.back().start = start;
      result.back().end = end;
    }
  }
  return result;
}

// By how much a point lies outside the module, metres; height is not looked at when `open_top`.
double outside(const assets::FixtureShape& shape, Vec3 p, bool open_top) {
  const double across =
      std::max(std::abs(p.x) - shape.width_mm * 0.0005, std::abs(p.y) - shape.depth_mm * 0.0005);
  const double above = open_top ? -1.0 : p.z - shape.height_mm * 0.001;
  return std::max({across, above, -p.z});
}

std::string part_text(const assets::FixtureModel& model, std::size_t i) {
  const assets::FixturePart& part = model.parts[i];
  const Vec3 at = part.fixture_from_part.position;
  const Vec3f half = part.half_size;
  return "part " + std::to_string(i) + " " + std::string(name_of(part.unit)) + " at (" +
         std::to_string(at.x) + ", " + std::to_string(at.y) + ", " + std::to_string(at.z) +
         ") half (" + std::to_string(half.x) + ", " + std::to_string(half.y) + ", " +
         std::to_string(half.z) + ")";
}

std::vector<OrientedBox> boxes_of(const assets::FixtureModel& model) {
  std::vector<OrientedBox> boxes;
  boxes.reserve(model.parts.size());
  for (const assets::FixturePart& part : model.parts) {
    boxes.push_back(oriented_box(part));
  }
  return boxes;
}

bool any_holds(const std::vector<OrientedBox>& boxes, Vec3 point) {
  return std::any_of(boxes.begin(), boxes.end(), [&](const OrientedBox& box) {
    return contains(box, point, 1e-4);
  });
}

void expect_parts_apart_and_inside(const assets::FixtureShape& shape,
                                   const assets::FixtureModel& model) {
  const std::vector<OrientedBox> boxes = boxes_of(model);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Vec3f half = model.parts[i].half_size;
    EXPECT_GT(std::min({half.x, half.y, half.z}), 0.0005F) << part_text(model, i);
    for (const Vec3& corner : corners(boxes[i])) {
      EXPECT_LE(outside(shape, corner, false), tolerance_m) << part_text(model, i);
    }
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      EXPECT_LE(penetration(boxes[i], boxes[j]), tolerance_m)
          << part_text(model, i) << " and " << part_text(model, j);
    }
  }
}

void expect_room_for_goods(const assets::FixtureShape& shape, const assets::FixtureModel& model) {
  const std::vector<OrientedBox> boxes = boxes_of(model);
  for (std::size_t i = 0; i < model.shelves.size(); ++i) {
    const OrientedBox room = free_volume(model.shelves[i]);
    EXPECT_GT(std::min({room.half.x, room.half.y, room.half.z}), 0.015) << "shelf " << i;
    for (const Vec3& corner : corners(room)) {
      EXPECT_LE(outside(shape, corner, true), tolerance_m) << "shelf " << i;
    }
    for (std::size_t j = 0; j < model.parts.size(); ++j) {
      EXPECT_LE(penetration(room, boxes[j]), tolerance_m)
          << "shelf " << i << " and " << part_text(model, j);
    }
    for (std::size_t j = i + 1; j < model.shelves.size(); ++j) {
      EXPECT_LE(penetration(room, free_volume(model.shelves[j])), tolerance_m)
          << "shelves " << i << " and " << j;
    }
  }
}

// Share of a grid of points just under the shelf's surface that lie in a part.
double supported_share(const std::vector<OrientedBox>& boxes, const assets::ShelfSurface& shelf) {
  constexpr int steps = 10;
  int held = 0;
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      const Vec3 under{
          ((i + 0.5) / steps - 0.5) * shelf.width_m, (j + 0.5) / steps * shelf.depth_m, -0.002};
      held += any_holds(boxes, shelf.fixture_from_shelf * under) ? 1 : 0;
    }
  }
  return static_cast<double>(held) / (steps * steps);
}

void expect_shelves_are_real(const assets::FixtureModel& model) {
  const std::vector<OrientedBox> boxes = boxes_of(model);
  std::set<std::pair<int, int>> seen;
  for (const assets::ShelfSurface& shelf : model.shelves) {
    EXPECT_TRUE(seen.insert({shelf.side, shelf.level}).second) << "two shelves have one place";
    if (shelf.use != assets::ShelfUse::hang) {
      EXPECT_GT(supported_share(boxes, shelf), 0.7)
          << "level " << shelf.level;  // pallets have gaps
    }
    if (!shelf.price_rail) continue;
    const double below = (assets::price_rail_top_m + assets::price_rail_bottom_m) / 2;
    const Vec3 behind_face{0, assets::price_rail_face_m + 0.001, below};
    const Vec3 before_face{0, assets::price_rail_face_m - 0.001, below};
    EXPECT_TRUE(any_holds(boxes, shelf.fixture_from_shelf * behind_face)) << "no rail";
    EXPECT_FALSE(any_holds(boxes, shelf.fixture_from_shelf * before_face)) << "label hidden";
  }
}

// Fixtures whose modules stand joined in runs.
const std::set<std::string> in_runs{"gondola",
                                    "wall_unit",
                                    "endcap",
                                    "multideck",
                                    "glass_door_cooler",
                                    "produce_table",
                                    "bakery_rack",
                                    "peg_wall",
                                    "wine_rack",
                                    "island_freezer",
                                    "serve_over",
                                    "fish_counter",
                                    "combi_freezer"};
const std::set<std::string> without_shelves{
    "self_checkout",    "kiosk",          "basket_stack",
    "trolley_bay",      "coffee_machine", "gate",
    "pillar",           "microwave",      "atm",
    "scales",           "lockers",        "queue_rails",
    "sliding_door",     "swing_door",     "hanging_sign",
    "a_board",          "ceiling_light",  "security_mirror",
    "cleaning_cart",    "bottle_return",  "flower_stand",
    "tasting_table",    "basket_trolley", "water_dispenser",
    "fire_cabinet",     "trash_bin",      "bench",
    "bread_slicer",     "orange_juicer",  "rotisserie",
    "deli_slicer",      "parcel_locker",  "photo_kiosk",
    "charging_station", "bulk_dispenser", "drawer_unit",
    "antenna_gate",     "pallet_truck",   "shopping_trolley",
    "salad_bar"};

// One shelf per side for each level that is asked for.
std::size_t shelves_wanted(const assets::FixtureShape& shape) {
  if (without_shelves.contains(shape.generator)) return 0;
  return static_cast<std::size_t>(shape.levels * shape.sides);
}

void expect_conforms(const assets::FixtureShape& shape, const catalog::Catalog& catalog) {
  SCOPED_TRACE(text_of(shape));
  const assets::FixtureModel model = made(shape, catalog);
  EXPECT_FALSE(model.parts.empty());
  EXPECT_EQ(model.shelves.size(), shelves_wanted(shape));
  expect_parts_apart_and_inside(shape, model);
  expect_room_for_goods(shape, model);
  expect_shelves_are_real(model);
}

// The reach of a module's parts along X, metres.
std::pair<double, double> reach_x(const assets::FixtureModel& model) {
  std::pair<double, double> reach{1e9, -1e9};
  for (const assets::FixturePart& part : model.parts) {
    for (const Vec3& corner : corners(oriented_box(part))) {
      reach.first = std::min(reach.first, corner.x);
      reach.second = std::max(reach.second, corner.x);
    }
  }
  return reach;
}

TEST(OrientedBoxes, KnowHowDeepTheyOverlap) {
  const OrientedBox unit = oriented_box(Pose{}, {0.5, 0.5, 0.5});
  EXPECT_NEAR(penetration(unit, oriented_box(Pose{{0.9, 0, 0}, {}}, {0.5, 0.5, 0.5})), 0.1, 1e-12);
  EXPECT_NEAR(penetration(unit, oriented_box(Pose{{1.2, 0, 0}, {}}, {0.5, 0.5, 0.5})), -0.2, 1e-12);
  // A cube standing on its edge reaches sqrt(2)/2 sideways: it touches the other at 0.5 + 0.7071.
  const Quaternion eighth = rotation_from_half_tangent({0, 0, 1}, 0.41421356237309503);
  EXPECT_NEAR(
      penetration(unit, oriented_box(Pose{{1.2071067811865475, 0, 0}, eighth}, {0.5, 0.5, 0.5})),
      0.0,
      1e-12);
}

TEST(Fixtures, EveryGeneratorIsInTheTable) {
  std::set<std::string> tested;
  for (const assets::FixtureShape& shape : table())
    tested.insert(shape.generator);
  for (const assets::FixtureGeneratorInfo& info : assets::fixture_generators()) {
    EXPECT_TRUE(tested.contains(std::string(info.name))) << info.name;
    EXPECT_FALSE(info.description.empty()) << info.name;
  }
  EXPECT_EQ(tested.size(), assets::fixture_generators().size());
  EXPECT_GE(assets::fixture_generators().size(), 45U);
}

TEST(Fixtures, EveryTableRowConformsAnywhereInARun) {
  const catalog::Catalog catalog = small_catalog();
  for (const assets::FixtureShape& shape : table()) {
    for (const assets::FixtureShape& placed : placings(shape))
      expect_conforms(placed, catalog);
  }
}

// Everything that a row allows: its widths, and the ends and middle of its ranges.
std::vector<assets::FixtureShape> shapes_of(const catalog::FixtureKind& kind) {
  std::vector<assets::FixtureShape> shapes;
  const assets::FixtureShape usual = shape_of(kind);
  const auto sizes = [](int size, const IntRange& range) {
    return std::set<int>{size, range[0], range[1]};
  };
  for (const int width : kind.module_widths_mm) {
    for (const int depth : sizes(kind.depth_mm, kind.depth_range_mm)) {
      for (const int height : sizes(kind.height_mm, kind.height_range_mm)) {
        for (const int levels : sizes(kind.levels, kind.level_range)) {
          shapes.push_back(usual);
          shapes.back().width_mm = width;
          shapes.back().depth_mm = depth;
          shapes.back().height_mm = height;
          shapes.back().levels = levels;
        }
      }
    }
  }
  return shapes;
}

TEST(Fixtures, EveryCatalogueRowConformsOverItsRanges) {
  const catalog::Catalog& catalog = committed_catalog();
  ASSERT_GE(catalog.fixture_kinds.size(), 150U);
  for (const catalog::FixtureKind& kind : catalog.fixture_kinds) {
    for (const assets::FixtureShape& shape : shapes_of(kind)) {
      expect_conforms(shape, catalog);
      if (HasFailure()) return;
    }
  }
}

// Widths that a plan may ask of any kind: the whole fixture, or a refusal.
TEST(Fixtures, OddWidthsAreWholeOrRefused) {
  int refused = 0;
  for (const catalog::FixtureKind& kind : committed_catalog().fixture_kinds) {
    for (const int width : {200, 400, 900, 1800, 3000, 4500}) {
      assets::FixtureShape shape = shape_of(kind);
      shape.width_mm = width;
      const auto model = assets::make_fixture_model(shape, committed_catalog());
      if (!model.ok()) {
        EXPECT_EQ(model.error().code, "assets.bad_row") << kind.kind << ", " << width << " mm";
        ++refused;
        continue;
      }
      for (std::size_t i = 0; i < model->parts.size(); ++i) {
        const Vec3f half = model->parts[i].half_size;
        EXPECT_GT(std::min({half.x, half.y, half.z}), 0)
            << kind.kind << ", " << width << " mm: " << part_text(*model, i);
      }
    }
  }
  EXPECT_GT(refused, 100);
}

TEST(Fixtures, ModulesOfARunMeetAtTheirJoint) {
  const catalog::Catalog catalog = small_catalog();
  for (const assets::FixtureShape& shape : table()) {
    if (!in_runs.contains(shape.generator)) continue;
    assets::FixtureShape inner = shape;
    inner.start = inner.end = false;
    const auto [low, high] = reach_x(made(inner, catalog));
    EXPECT_NEAR(low, -shape.width_mm * 0.0005, tolerance_m) << text_of(shape);
    EXPECT_NEAR(high, shape.width_mm * 0.0005, tolerance_m) << text_of(shape);
  }
}

}  // namespace
}  // namespace marketgen
