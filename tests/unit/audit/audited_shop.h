// A shop of 20 x 10 m put down by hand, in which every kind of wish has a known answer.
//
//   north wall:  dairy (a multideck) at x = 12-20, y = 8.5-10
//   middle:      canned (two runs of gondolas) at x = 2-8, y = 4-8; frozen (empty) at x = 9-11, y =
//   4-6 south wall:  produce x = 0-4, bakery x = 5-8, snacks x = 8-9 (all y = 0-3), checkout x =
//   14-19, y = 0-2 entrance at x = 4, exit at x = 16, both in the south wall
#pragma once
#include <string>

#include "scene/price_tags.h"
#include "scene/scene.h"
#include "support/hand_made_scene.h"

namespace marketgen {

class AuditedShop {
 public:
  AuditedShop() {
    layout::Layout& layout = scene.layout;
    layout.profile = "supermarket-eu";
    layout.shell.width_mm = 20000, layout.shell.depth_mm = 10000, layout.shell.ceiling_mm = 3000;
    layout.shell.openings = {
        {"entrance", plan::OpeningKind::entrance, plan::Wall::south, 0.2, 2000},
        {"exit", plan::OpeningKind::exit, plan::Wall::south, 0.8, 2000}};
    add_zone("produce", {0, 0, 4000, 3000});
    add_zone("bakery", {5000, 0, 8000, 3000});
    add_zone("snacks", {8000, 0, 9000, 3000});
    add_zone("checkout", {14000, 0, 19000, 2000});
    add_zone("canned", {2000, 4000, 8000, 8000});
    add_zone("frozen", {9000, 4000, 11000, 6000});
    add_zone("dairy", {12000, 8500, 20000, 10000});
    scene.catalog = {hand_made_product("box-cereal", "box", {190, 60, 280}, 0.45),
                     hand_made_product("can-cola", "can", {66, 66, 115}, 0.35)};
    scene.catalog[0].name = "Cereal";
    scene.catalog[0].subcategory = "breakfast cereal";
    add_run("canned/run-1", 5000, 2, 0);
    add_run("canned/run-2", 7300, 1, 180);
    layout::Fixture& cap = add_fixture("canned/run-1/endcap-1", "endcap", "canned", 2500, 5000, 1);
    cap.endcap_of = "canned/run-1";
    add_fixture("dairy/run-1/module-1", "multideck", "dairy", 16000, 9500, 4);
    for (int lane = 0; lane < 3; ++lane)
      add_fixture("checkout/lane-" + std::to_string(lane),
                  "checkout_lane",
                  "checkout",
                  14800 + 1500 * lane,
                  1000,
                  0);
    layout.aisles.push_back({"aisle-1",
                             layout::AisleKind::secondary,
                             {{3000, 5250}, {5500, 5250}, {5500, 7050}, {3000, 7050}},
                             1800});
    stock();
  }

  scene::Scene scene;

 private:
  void add_zone(const std::string& type, RectMm r) {
    scene.layout.zones.push_back({type, type, type, polygon_of(r), r.area_m2()});
  }

  layout::Fixture& add_fixture(const std::string& id,
                               const std::string& kind,
                               const std::string& zone,
                               int x_mm,
                               int y_mm,
                               int levels) {
    layout::Fixture f;
    f.id = id;
    f.run = id.substr(0, id.rfind('/'));
    f.kind = kind;
    f.zone = zone;
    f.x_mm = x_mm, f.y_mm = y_mm, f.levels = levels;
    scene::SceneFixture row;
    row.first_shelf = static_cast<std::uint32_t>(scene.shelves.size());
    row.shelf_count = static_cast<std::uint32_t>(levels);
    row.position_m = {static_cast<float>(x_mm) * 1e-3F, static_cast<float>(y_mm) * 1e-3F, 0};
    for (int level = 0; level < levels; ++level) {
      scene::SceneShelf shelf;
      shelf.fixture = static_cast<std::uint32_t>(scene.fixtures.size());
      shelf.level = level;
      shelf.position_m = {0, -0.25F, 0.15F + 0.35F * static_cast<float>(level)};
      shelf.width_m = 1.0F, shelf.depth_m = 0.4F, shelf.clearance_m = 0.32F;
      scene.shelves.push_back(shelf);
    }
    scene.fixtures.push_back(row);
    scene.layout.fixtures.push_back(f);
    return scene.layout.fixtures.back();
  }

  void add_run(const std::string& run, int y_mm, int modules, int yaw_deg) {
    for (int m = 0; m < modules; ++m) {
      layout::Fixture& f = add_fixture(
          run + "/module-" + std::to_string(m), "gondola", "canned", 3625 + 1250 * m, y_mm, 5);
      f.yaw_deg = yaw_deg;
      scene.fixtures.back().quarter_turns = yaw_deg / 90;
    }
  }

  // A block of 0.8 m on every shelf; each tenth block is sold out.
  void stock() {
    for (std::uint32_t shelf = 0; shelf < scene.shelves.size(); ++shelf) {
      scene::Facing block;
      block.shelf = shelf;
      block.sku = shelf % 2;
      block.width_m = 0.8F;
      block.facings = 3;
      block.first_product = static_cast<std::uint32_t>(scene.products.size());
      block.product_count = scene.facings.size() % 10 == 9 ? 0 : 1;
      const Vec3 at = scene::world_from_shelf(scene, shelf) * Vec3{0, 0.2, 0};
      if (block.product_count > 0) {
        scene.products.push_back(
            {block.sku,
             static_cast<std::uint32_t>(scene.facings.size()),
             {static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)},
             {1, 0, 0, 0},
             scene::product_front_row});
      }
      scene::PriceLabel label;
      label.shelf = shelf;
      label.sku = block.sku;
      label.facing = static_cast<std::uint32_t>(scene.facings.size());
      label.price_cents = scene::price_cents(scene.catalog[block.sku]);
      scene.price_labels.push_back(label);
      scene.facings.push_back(block);
    }
  }
};

}  // namespace marketgen
