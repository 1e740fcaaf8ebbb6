// Shapes that the tests of fixtures build: usual, small, large and odd sizes of every generator.
#pragma once
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "assets/fixtures/fixture_model.h"
#include "catalog/catalog.h"
#include "catalog/fixture_kind.h"

namespace marketgen {

inline catalog::Catalog small_catalog() {
  catalog::Catalog catalog;
  catalog::MaterialRow metal;
  metal.id = "metal-white";
  metal.roughness = 0.4;
  catalog::MaterialRow wood;
  wood.id = "wood-oak";
  wood.pattern = catalog::MaterialPattern::planks;
  wood.color = "#b98a56";
  catalog.materials = {metal, wood};
  return catalog;
}

inline assets::FixtureShape shape_of(std::string generator,
                                     int width,
                                     int depth,
                                     int height,
                                     int levels,
                                     int base,
                                     int spacing,
                                     int sides) {
  assets::FixtureShape shape;
  shape.generator = std::move(generator);
  shape.width_mm = width;
  shape.depth_mm = depth;
  shape.height_mm = height;
  shape.levels = levels;
  shape.base_mm = base;
  shape.spacing_mm = spacing;
  shape.sides = sides;
  return shape;
}

inline std::string text_of(const assets::FixtureShape& s) {
  return s.generator + " " + std::to_string(s.width_mm) + "x" + std::to_string(s.depth_mm) + "x" +
         std::to_string(s.height_mm) + " levels " + std::to_string(s.levels) + " base " +
         std::to_string(s.base_mm) + " sides " + std::to_string(s.sides) +
         (s.start ? " start" : "") + (s.end ? " end" : "");
}

// Usual, small, large and odd sizes of every generator.
inline std::vector<assets::FixtureShape> table() {
  return {
      shape_of("gondola", 1250, 940, 1800, 5, 150, 350, 2),
      shape_of("gondola", 1250, 470, 1400, 4, 150, 300, 1),
      shape_of("gondola", 1330, 1180, 2200, 7, 100, 300, 2),
      shape_of("gondola", 301, 443, 601, 3, 0, 900, 2),
      shape_of("gondola", 1250, 940, 1800, 1, 150, 350, 2),
      shape_of("wall_unit", 1250, 500, 2200, 6, 150, 350, 1),
      shape_of("wall_unit", 1000, 620, 1500, 4, 150, 350, 1),
      shape_of("wall_unit", 333, 301, 2400, 10, 80, 200, 1),
      shape_of("endcap", 900, 500, 1600, 4, 150, 350, 1),
      shape_of("endcap", 1250, 420, 1300, 3, 120, 500, 1),
      shape_of("multideck", 1250, 1000, 2000, 5, 350, 350, 1),
      shape_of("multideck", 2500, 900, 2200, 6, 300, 300, 1),
      shape_of("multideck", 625, 650, 1300, 2, 100, 350, 1),
      shape_of("multideck", 1250, 1100, 2000, 1, 350, 350, 1),
      shape_of("glass_door_cooler", 1250, 710, 2200, 6, 250, 300, 1),
      shape_of("glass_door_cooler", 700, 600, 2000, 5, 220, 350, 1),
      shape_of("glass_door_cooler", 3750, 900, 2100, 5, 300, 330, 1),
      shape_of("chest_freezer", 1500, 800, 900, 1, 450, 350, 1),
      shape_of("chest_freezer", 2500, 1100, 950, 1, 0, 350, 1),
      shape_of("island_freezer", 2000, 1800, 900, 1, 450, 350, 2),
      shape_of("island_freezer", 1250, 1000, 850, 1, 400, 350, 1),
      shape_of("serve_over", 1250, 1100, 1280, 1, 750, 350, 1),
      shape_of("serve_over", 2500, 1200, 1400, 1, 0, 350, 1),
      shape_of("serve_over", 1000, 850, 1200, 1, 900, 350, 1),
      shape_of("serve_over", 1250, 1100, 1250, 2, 800, 350, 1),
      shape_of("produce_table", 1250, 1100, 1000, 3, 500, 350, 1),
      shape_of("produce_table", 1500, 1800, 1000, 2, 600, 350, 2),
      shape_of("produce_table", 1250, 1000, 1900, 2, 450, 350, 1),
      shape_of("produce_table", 1000, 800, 900, 1, 700, 350, 1),
      shape_of("bakery_rack", 1000, 600, 1900, 4, 250, 350, 1),
      shape_of("bakery_rack", 1250, 500, 1300, 3, 200, 300, 1),
      shape_of("bin", 800, 800, 800, 1, 300, 350, 1),
      shape_of("bin", 1200, 600, 900, 1, 0, 350, 1),
      shape_of("pallet", 1200, 800, 1200, 1, 144, 350, 1),
      shape_of("pallet", 800, 600, 300, 1, 144, 350, 1),
      shape_of("promo_stack", 1200, 800, 1500, 1, 144, 350, 1),
      shape_of("promo_stack", 800, 1200, 900, 1, 144, 350, 1),
      shape_of("promo_stack", 800, 600, 1500, 3, 150, 350, 1),
      shape_of("peg_wall", 1000, 500, 1800, 5, 150, 350, 1),
      shape_of("peg_wall", 1250, 900, 2000, 4, 150, 400, 2),
      shape_of("wine_rack", 1000, 450, 2000, 5, 400, 350, 1),
      shape_of("wine_rack", 1250, 350, 1700, 4, 120, 350, 1),
      shape_of("checkout_lane", 3000, 1100, 2000, 0, 0, 0, 1),
      shape_of("checkout_lane", 4000, 1300, 2200, 4, 200, 250, 1),
      shape_of("checkout_lane", 1100, 3200, 1500, 1, 500, 350, 1),
      shape_of("checkout_lane", 1100, 2400, 1200, 0, 0, 0, 1),
      shape_of("checkout_lane", 1800, 800, 1080, 0, 0, 0, 1),
      shape_of("self_checkout", 1500, 700, 1800, 0, 0, 0, 1),
      shape_of("self_checkout", 1000, 550, 1500, 0, 0, 0, 1),
      shape_of("kiosk", 2400, 900, 2200, 0, 0, 0, 1),
      shape_of("kiosk", 1200, 600, 1150, 0, 0, 0, 1),
      shape_of("basket_stack", 1000, 400, 1000, 0, 0, 0, 1),
      shape_of("basket_stack", 500, 700, 600, 0, 0, 0, 1),
      shape_of("trolley_bay", 3500, 1400, 1800, 0, 0, 0, 1),
      shape_of("trolley_bay", 1000, 2500, 1100, 0, 0, 0, 1),
      shape_of("coffee_machine", 1200, 650, 2000, 0, 0, 0, 1),
      shape_of("coffee_machine", 600, 600, 1600, 0, 0, 0, 1),
      shape_of("gate", 2000, 300, 1000, 0, 0, 0, 1),
      shape_of("gate", 900, 200, 1200, 0, 0, 0, 1),
      shape_of("pillar", 500, 500, 2600, 0, 0, 0, 1),
      shape_of("pillar", 300, 800, 1000, 0, 0, 0, 1),
      shape_of("microwave", 600, 550, 1500, 0, 0, 0, 1),
      shape_of("microwave", 800, 500, 1215, 0, 0, 0, 1),
      shape_of("hot_food_cabinet", 1000, 700, 1450, 2, 0, 350, 1),
      shape_of("hot_food_cabinet", 500, 450, 1000, 1, 0, 350, 1),
      shape_of("atm", 560, 650, 1650, 0, 0, 0, 1),
      shape_of("atm", 480, 450, 1480, 0, 0, 0, 1),
      shape_of("scales", 520, 520, 1600, 0, 0, 0, 1),
      shape_of("scales", 900, 480, 1400, 0, 0, 0, 1),
      shape_of("lockers", 960, 450, 1850, 4, 0, 0, 1),
      shape_of("lockers", 300, 300, 600, 2, 0, 0, 1),
      shape_of("queue_rails", 2700, 350, 1000, 1, 0, 0, 1),
      shape_of("queue_rails", 800, 200, 700, 3, 0, 0, 1),
      shape_of("sliding_door", 2800, 250, 2400, 0, 0, 0, 1),
      shape_of("sliding_door", 1300, 200, 2000, 0, 0, 0, 1),
      shape_of("swing_door", 1700, 150, 2200, 0, 0, 0, 1),
      shape_of("swing_door", 900, 110, 2000, 0, 0, 0, 1),
      shape_of("hanging_sign", 1200, 60, 2600, 0, 0, 0, 1),
      shape_of("hanging_sign", 600, 40, 900, 0, 0, 0, 1),
      shape_of("a_board", 620, 650, 1050, 0, 0, 0, 1),
      shape_of("a_board", 300, 320, 600, 0, 0, 0, 1),
      shape_of("ceiling_light", 1500, 150, 2600, 0, 0, 0, 1),
      shape_of("ceiling_light", 450, 450, 2400, 0, 0, 0, 1),
      shape_of("ceiling_light", 1500, 250, 2600, 5, 0, 0, 1),
      shape_of("security_mirror", 600, 320, 2400, 0, 0, 0, 1),
      shape_of("security_mirror", 350, 400, 1200, 0, 0, 0, 1),
      shape_of("cleaning_cart", 1150, 550, 1050, 0, 0, 0, 1),
      shape_of("cleaning_cart", 950, 460, 900, 0, 0, 0, 1),
      shape_of("bottle_return", 850, 800, 1950, 0, 0, 0, 1),
      shape_of("bottle_return", 1300, 600, 1850, 0, 0, 0, 1),
      shape_of("vending_machine", 900, 850, 1830, 6, 0, 280, 1),
      shape_of("vending_machine", 700, 600, 1650, 3, 0, 350, 1),
      shape_of("counter_fridge", 1350, 550, 880, 2, 0, 350, 1),
      shape_of("counter_fridge", 450, 450, 700, 1, 0, 350, 1),
      shape_of("ice_cream_chest", 1050, 680, 1500, 1, 250, 350, 1),
      shape_of("ice_cream_chest", 700, 560, 860, 1, 0, 350, 1),
      shape_of("flower_stand", 1200, 850, 1250, 3, 0, 0, 1),
      shape_of("flower_stand", 400, 300, 700, 1, 0, 0, 1),
      shape_of("magazine_rack", 1000, 600, 1600, 3, 120, 350, 1),
      shape_of("magazine_rack", 500, 350, 900, 1, 120, 350, 1),
      shape_of("newspaper_stand", 480, 420, 1300, 4, 130, 350, 1),
      shape_of("newspaper_stand", 900, 350, 800, 2, 130, 250, 1),
      shape_of("cigarette_cabinet", 1250, 380, 2100, 7, 350, 200, 1),
      shape_of("cigarette_cabinet", 800, 300, 1400, 3, 350, 250, 1),
      shape_of("plant_table", 1250, 900, 1000, 2, 220, 350, 1),
      shape_of("plant_table", 2000, 700, 800, 1, 700, 350, 1),
      shape_of("tasting_table", 1100, 550, 1950, 0, 0, 0, 1),
      shape_of("tasting_table", 1500, 500, 1100, 0, 0, 0, 1),
      shape_of("roll_cage", 720, 810, 1700, 1, 170, 350, 1),
      shape_of("roll_cage", 600, 700, 1500, 4, 170, 300, 1),
      shape_of("basket_trolley", 420, 520, 640, 0, 0, 0, 1),
      shape_of("basket_trolley", 320, 400, 520, 0, 0, 0, 1),
      shape_of("water_dispenser", 420, 360, 1400, 0, 0, 0, 1),
      shape_of("water_dispenser", 300, 320, 1340, 0, 0, 0, 1),
      shape_of("fire_cabinet", 420, 260, 1600, 0, 600, 0, 1),
      shape_of("fire_cabinet", 350, 240, 1000, 0, 900, 0, 1),
      shape_of("trash_bin", 1260, 420, 1150, 0, 0, 0, 1),
      shape_of("trash_bin", 300, 300, 700, 0, 0, 0, 1),
      shape_of("bench", 1500, 600, 820, 0, 0, 0, 1),
      shape_of("bench", 900, 350, 420, 0, 0, 0, 1),
      shape_of("bread_slicer", 620, 780, 1300, 0, 0, 0, 1),
      shape_of("bread_slicer", 500, 650, 1150, 0, 0, 0, 1),
      shape_of("orange_juicer", 620, 640, 1750, 0, 0, 0, 1),
      shape_of("orange_juicer", 800, 600, 1700, 0, 0, 0, 1),
      shape_of("rotisserie", 900, 750, 1850, 0, 0, 0, 1),
      shape_of("rotisserie", 700, 600, 1350, 0, 0, 0, 1),
      shape_of("fish_counter", 2000, 1200, 1400, 1, 800, 350, 1),
      shape_of("fish_counter", 900, 900, 1050, 1, 700, 350, 1),
      shape_of("deli_slicer", 1400, 700, 1400, 0, 0, 0, 1),
      shape_of("deli_slicer", 800, 600, 1320, 0, 0, 0, 1),
      shape_of("parcel_locker", 2400, 500, 2100, 8, 0, 0, 1),
      shape_of("parcel_locker", 1250, 400, 1750, 3, 0, 0, 1),
      shape_of("photo_kiosk", 1400, 600, 1700, 0, 0, 0, 1),
      shape_of("photo_kiosk", 600, 520, 1500, 0, 0, 0, 1),
      shape_of("charging_station", 520, 420, 1700, 4, 0, 0, 1),
      shape_of("charging_station", 380, 300, 1400, 2, 0, 0, 1),
      shape_of("bulk_dispenser", 1250, 600, 2000, 0, 0, 0, 1),
      shape_of("bulk_dispenser", 450, 450, 1300, 0, 0, 0, 1),
      shape_of("drawer_unit", 900, 500, 950, 5, 0, 0, 1),
      shape_of("drawer_unit", 350, 350, 500, 2, 0, 0, 1),
      shape_of("combi_freezer", 1950, 1050, 2050, 5, 380, 300, 1),
      shape_of("combi_freezer", 700, 950, 1800, 3, 380, 300, 1),
      shape_of("antenna_gate", 1300, 380, 1550, 0, 0, 0, 1),
      shape_of("antenna_gate", 200, 300, 1000, 0, 0, 0, 1),
      shape_of("pallet_truck", 1550, 540, 1220, 0, 0, 0, 1),
      shape_of("pallet_truck", 1100, 480, 1050, 0, 0, 0, 1),
      shape_of("shopping_trolley", 960, 570, 1020, 0, 0, 0, 1),
      shape_of("shopping_trolley", 650, 400, 760, 0, 0, 0, 1),
      shape_of("produce_bins", 1200, 1100, 1050, 3, 400, 350, 1),
      shape_of("produce_bins", 600, 500, 700, 1, 500, 350, 1),
      shape_of("bread_cabinet", 1330, 750, 2000, 4, 650, 350, 1),
      shape_of("bread_cabinet", 500, 500, 1300, 2, 650, 350, 1),
      shape_of("salad_bar", 1800, 1050, 1400, 0, 0, 0, 1),
      shape_of("salad_bar", 800, 800, 1300, 0, 0, 0, 1),
  };
}

// A row at its default size.
inline assets::FixtureShape shape_of(const catalog::FixtureKind& kind) {
  assets::FixtureShape shape = shape_of(kind.generator,
                                        kind.module_widths_mm.front(),
                                        kind.depth_mm,
                                        kind.height_mm,
                                        kind.levels,
                                        kind.base_mm,
                                        350,
                                        kind.double_sided ? 2 : 1);
  shape.material = kind.material;
  shape.color = kind.color;
  if (!kind.accent.empty()) shape.accent = kind.accent;
  shape.spacings_mm = kind.spacings_mm;
  shape.board_mm = kind.board_mm;
  shape.shelf_tilt_deg = kind.shelf_tilt_deg;
  shape.fence_mm = kind.fence_mm;
  shape.header_mm = kind.header_mm;
  return shape;
}

// The model of a shape that must be buildable.
inline assets::FixtureModel made(const assets::FixtureShape& shape,
                                 const catalog::Catalog& catalog) {
  const Result<assets::FixtureModel> model = assets::make_fixture_model(shape, catalog);
  EXPECT_TRUE(model.ok()) << text_of(shape) << ": " << to_string(model.error());
  return model.ok() ? *model : assets::FixtureModel{};
}

}  // namespace marketgen
