// A fixture row: a kind of shelf, cabinet, counter or lane, with the sizes it is built in.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "catalog/product.h"

namespace marketgen::catalog {

// What a fixture is for in the layout.
enum class FixtureRole { shelving, checkout, equipment };
constexpr std::array<std::string_view, 3> names_of(FixtureRole) {
  return {"shelving", "checkout", "equipment"};
}

// What carries it.
enum class FixtureMount { floor, wall, ceiling };
constexpr std::array<std::string_view, 3> names_of(FixtureMount) {
  return {"floor", "wall", "ceiling"};
}

struct FixtureKind {
  std::string kind;       // "gondola"
  std::string name;       // "Double-sided gondola"
  std::string generator;  // assembly in assets/fixtures/fixture_generators.inc
  FixtureRole role = FixtureRole::shelving;
  FixtureMount mount = FixtureMount::floor;
  Storage temperature = Storage::ambient;
  bool double_sided = false;                // stocked from both sides
  bool against_wall = false;                // prefers a wall behind it
  std::vector<int> module_widths_mm{1250};  // widths it is made in, preferred first
  int depth_mm = 500;                       // overall, over both sides
  IntRange depth_range_mm{300, 1400};
  int height_mm = 1800;
  IntRange height_range_mm{400, 2400};
  int levels = 5;  // stocked levels, base included
  IntRange level_range{1, 8};
  int base_mm = 150;                // top of the lowest stocked level above the floor
  double front_clearance_mm = 900;  // free floor a shopper needs before it
  double door_swing_mm = 0;         // how far its doors open into the aisle
  std::string material = "metal-white";
  std::string color = "#f2f2f0";
  std::string accent;            // header bands and signs; empty: the store's own
  int board_mm = 25;             // thickness of its shelves
  double shelf_tilt_deg = 0;     // shelves over the base slope to the shopper by this
  int fence_mm = 0;              // bar along the shelves' front edges, this high; 0: none
  int header_mm = -1;            // band along its top, this high; -1: the generator's usual
  std::vector<int> spacings_mm;  // from each level to the next, lowest first; empty: even
  int slot_mm = 0;  // its boards hang in slots this far apart; 0: they stay where they are
  std::vector<std::string> keywords;  // words of plans; a mere variant has none
  std::vector<std::string> tags;      // words that only the asset search knows

  // One person works behind it: it needs floor at its back.
  bool is_desk() const { return generator == "kiosk"; }

  static constexpr auto fields = field_list(
      field("kind", &FixtureKind::kind, "id used in plans", identifier()),
      field("name", &FixtureKind::name, "what people call it", required()),
      field("generator",
            &FixtureKind::generator,
            "how it is assembled from minimal units",
            required()),
      field("role", &FixtureKind::role, "place in the layout"),
      field("mount", &FixtureKind::mount, "what carries it"),
      field("temperature", &FixtureKind::temperature, "temperature it keeps"),
      field("double_sided", &FixtureKind::double_sided, "stocked from both sides"),
      field("against_wall", &FixtureKind::against_wall, "prefers a wall behind it"),
      field("module_widths_mm",
            &FixtureKind::module_widths_mm,
            "widths it is made in, preferred first",
            range(100, 4500)),
      field("depth_mm", &FixtureKind::depth_mm, "overall depth", range(40, 4500)),
      field("depth_range_mm",
            &FixtureKind::depth_range_mm,
            "smallest and largest depth",
            range(40, 4500)),
      field("height_mm", &FixtureKind::height_mm, "overall height", range(300, 3000)),
      field(
          "height_range_mm", &FixtureKind::height_range_mm, "lowest and highest", range(300, 3000)),
      field("levels", &FixtureKind::levels, "stocked levels, base included", range(0, 10)),
      field("level_range", &FixtureKind::level_range, "fewest and most levels", range(0, 10)),
      field("base_mm",
            &FixtureKind::base_mm,
            "top of the lowest level above the floor",
            range(0, 1200)),
      field("front_clearance_mm",
            &FixtureKind::front_clearance_mm,
            "free floor a shopper needs before it",
            range(0, 3000)),
      field("door_swing_mm",
            &FixtureKind::door_swing_mm,
            "how far its doors open into the aisle",
            range(0, 1000)),
      field("material", &FixtureKind::material, "material id of its body"),
      field("color", &FixtureKind::color, "colour of its body, #rrggbb"),
      field("accent",
            &FixtureKind::accent,
            "colour of its header bands and signs, #rrggbb; empty: the store's own"),
      field("board_mm", &FixtureKind::board_mm, "thickness of its shelves", range(12, 60)),
      field("shelf_tilt_deg",
            &FixtureKind::shelf_tilt_deg,
            "slope of the shelves over the base towards the shopper",
            range(0, 25)),
      field("fence_mm",
            &FixtureKind::fence_mm,
            "height of the bar along the shelves' front edges; 0: none",
            range(0, 200)),
      field("header_mm",
            &FixtureKind::header_mm,
            "height of the band along its top; -1: the generator's usual",
            range(-1, 400)),
      field("spacings_mm",
            &FixtureKind::spacings_mm,
            "from each level to the next, lowest first; empty: even",
            range(80, 2000)),
      field("slot_mm",
            &FixtureKind::slot_mm,
            "raster of the slots that its boards hang in; 0: they cannot be moved",
            range(0, 100)),
      field("keywords", &FixtureKind::keywords, "words that plans name it by"),
      field("tags", &FixtureKind::tags, "more words that the asset search finds it by"));
};

}  // namespace marketgen::catalog
