// Shapes that the tests of fixtures build: usual, small, large and odd sizes of every generator.
#pragma once
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "assets/fixture_model.h"
#include "catalog/catalog.h"

namespace marketgen {

inline Catalog small_catalog() {
  Catalog catalog;
  MaterialRow metal;
  metal.id = "metal-white";
  metal.roughness = 0.4;
  MaterialRow wood;
  wood.id = "wood-oak";
  wood.pattern = MaterialPattern::planks;
  wood.color = "#b98a56";
  catalog.materials = {metal, wood};
  return catalog;
}

inline FixtureShape shape_of(std::string generator,
                             int width,
                             int depth,
                             int height,
                             int levels,
                             int base,
                             int spacing,
                             int sides) {
  FixtureShape shape;
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

inline std::string text_of(const FixtureShape& s) {
  return s.generator + " " + std::to_string(s.width_mm) + "x" + std::to_string(s.depth_mm) + "x" +
         std::to_string(s.height_mm) + " levels " + std::to_string(s.levels) + " base " +
         std::to_string(s.base_mm) + " sides " + std::to_string(s.sides) +
         (s.start ? " start" : "") + (s.end ? " end" : "");
}

// Usual, small, large and odd sizes of every generator.
inline std::vector<FixtureShape> table() {
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
  };
}

// The model of a shape that must be buildable.
inline FixtureModel made(const FixtureShape& shape, const Catalog& catalog) {
  const Result<FixtureModel> model = make_fixture_model(shape, catalog);
  EXPECT_TRUE(model.ok()) << text_of(shape) << ": " << to_string(model.error());
  return model.ok() ? *model : FixtureModel{};
}

}  // namespace marketgen
