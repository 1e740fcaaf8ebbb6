// A small shop built by hand: a room of 6 x 4 m with one two-level shelf, for tests that need a
// scene but no generator.
#pragma once
#include <string>

#include "scene/scene.h"

namespace marketgen {

// Products of a few archetypes, one row each.
inline catalog::Product hand_made_product(std::string sku,
                                          std::string archetype,
                                          std::array<int, 3> size_mm,
                                          double mass_kg) {
  catalog::Product product;
  product.sku = std::move(sku);
  product.ean = "2000000000015";
  product.name = "Cola";
  product.brand = "Fonda";
  product.category = "beverages";
  product.subcategory = "soft drinks";
  product.archetype = std::move(archetype);
  product.size_mm = size_mm;
  product.mass_kg = mass_kg;
  product.net = "330 ml";
  product.unit_of_measure = "l";
  product.unit_amount = 0.33;
  product.price = 0.99;
  return product;
}

// The room: entrance and window in the south wall, a service door in the north wall, one column, no
// goods. The shelf stands against the north wall, front to the south, boards' tops at 0.15 and 0.55
// m.
class HandMadeScene {
 public:
  static constexpr float lower_board_m = 0.15F, upper_board_m = 0.55F;
  static constexpr float shelf_x_m = 3.0F, shelf_y_m = 3.7F;  // middle of its footprint

  HandMadeScene() {
    scene.seed = 7;
    scene.layout.name = "Corner & Co <test>";
    scene.layout.profile = "supermarket-eu";
    plan::Shell& shell = scene.layout.shell;
    shell.width_mm = 6000, shell.depth_mm = 4000, shell.ceiling_mm = 3000;
    shell.outline_mm = PolygonMm{{0, 0}, {6000, 0}, {6000, 4000}, {0, 4000}};
    shell.openings = {{"entrance", plan::OpeningKind::entrance, plan::Wall::south, 0.25, 1500},
                      {"front", plan::OpeningKind::window, plan::Wall::south, 0.75, 1200},
                      {"dock", plan::OpeningKind::service, plan::Wall::north, 0.15, 1000}};
    shell.columns = {{600, 600, 300}};
    add_shelf_unit();
    scene.layout.aisles.push_back({"aisle-1",
                                   layout::AisleKind::main,
                                   {{500, 1500}, {5500, 1500}, {5500, 3300}, {500, 3300}},
                                   1800});
    scene.catalog = {hand_made_product("box-cereal", "box", {190, 60, 280}, 0.45),
                     hand_made_product("can-cola", "can", {66, 66, 115}, 0.35),
                     hand_made_product("fruit-apple", "round_produce", {75, 75, 70}, 0.18)};
  }

  // One item on a facing of its own, its bottom centre at `position_m`. Returns its row in
  // products.
  std::uint32_t add(std::uint32_t sku,
                    std::array<float, 3> position_m,
                    std::array<float, 4> rotation_wxyz = {1, 0, 0, 0}) {
    const bool upper = position_m[2] > 0.5F;
    scene::Facing facing;
    facing.shelf = upper ? 1 : 0;
    facing.sku = sku;
    facing.position = static_cast<std::uint16_t>(scene.facings.size());
    facing.first_product = static_cast<std::uint32_t>(scene.products.size());
    facing.product_count = 1;
    scene.products.push_back(
        {sku, static_cast<std::uint32_t>(scene.facings.size()), position_m, rotation_wxyz, 0});
    scene.facings.push_back(facing);
    return facing.first_product;
  }

  // Cans and cereal on both boards, apart from one another by a few millimetres.
  void stock() {
    for (int i = 0; i < 5; ++i)
      add(1, {2.6F + 0.072F * static_cast<float>(i), shelf_y_m - 0.1F, lower_board_m});
    for (int i = 0; i < 3; ++i)
      add(0, {2.6F + 0.2F * static_cast<float>(i), shelf_y_m - 0.05F, upper_board_m});
    scene.price_labels.push_back({0, 1, 0, 0.2F, 0.07F, 0.038F, 0, 99});
    scene.price_labels.push_back({1, 0, 5, 0.3F, 0.07F, 0.038F, 1, 249});
  }

  scene::Scene scene;

 private:
  void add_part(assets::UnitKind unit,
                std::array<float, 3> position_m,
                std::array<float, 3> half_size_m) {
    scene::ScenePart part;
    part.unit = unit;
    part.position_m = position_m;
    part.half_size_m = half_size_m;
    part.color = {0.8F, 0.8F, 0.75F};
    scene.parts.push_back(part);
  }

  void add_shelf_unit() {
    layout::Fixture fixture;
    fixture.id = "dry/run-1/module-1";
    fixture.run = "dry/run-1";
    fixture.kind = "wall_unit";
    fixture.zone = "dry";
    fixture.x_mm = 3000, fixture.y_mm = 3700, fixture.width_mm = 1250, fixture.depth_mm = 500,
    fixture.height_mm = 1000;
    scene.layout.fixtures.push_back(fixture);
    constexpr float half_board = 0.015F;
    add_part(assets::UnitKind::base,
             {0, 0, (lower_board_m - 0.03F) / 2},
             {0.6F, 0.2F, (lower_board_m - 0.03F) / 2});
    add_part(
        assets::UnitKind::board, {0, 0, lower_board_m - half_board}, {0.62F, 0.22F, half_board});
    add_part(
        assets::UnitKind::board, {0, 0, upper_board_m - half_board}, {0.62F, 0.22F, half_board});
    add_part(assets::UnitKind::back_panel, {0, 0.235F, 0.5F}, {0.62F, 0.01F, 0.5F});
    scene.fixtures.push_back({0, 4, 0, 2, {shelf_x_m, shelf_y_m, 0}, 0});
    for (int level = 0; level < 2; ++level) {
      scene::SceneShelf shelf;
      shelf.level = level;
      shelf.position_m = {0, -0.22F, level == 0 ? lower_board_m : upper_board_m};
      shelf.width_m = 1.24F, shelf.depth_m = 0.44F, shelf.clearance_m = level == 0 ? 0.36F : 0.45F;
      scene.shelves.push_back(shelf);
    }
  }
};

}  // namespace marketgen
