// A small catalogue and small plans with round numbers, so that tests can say what must come out.
#pragma once
#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "layout/layout.h"
#include "plan/plan.h"

namespace marketgen::sample {

inline catalog::FixtureKind kind(
    std::string name, std::vector<int> widths, int depth, int height, int levels) {
  catalog::FixtureKind k;
  k.kind = name;
  k.name = name;
  k.generator = name;
  k.module_widths_mm = std::move(widths);
  k.depth_mm = depth;
  k.depth_range_mm = {200, 4000};
  k.height_mm = height;
  k.height_range_mm = {300, 2500};
  k.levels = levels;
  k.level_range = {0, 8};
  k.base_mm = 150;
  k.front_clearance_mm = 900;
  return k;
}

inline catalog::ZoneTypeRow zone_type(std::string type,
                                      std::string fixture,
                                      catalog::Storage temperature = catalog::Storage::ambient) {
  catalog::ZoneTypeRow row;
  row.type = type;
  row.label = type;
  row.fixture = std::move(fixture);
  row.temperature = temperature;
  row.categories = {type};
  return row;
}

inline catalog::Catalog catalog() {
  catalog::Catalog c;
  catalog::FixtureKind gondola = kind("gondola", {1000, 500}, 1000, 1800, 5);
  gondola.double_sided = true;
  catalog::FixtureKind wall_unit = kind("wall_unit", {1000, 500}, 500, 2100, 6);
  wall_unit.against_wall = true;
  catalog::FixtureKind endcap = kind("endcap", {1000}, 400, 1700, 5);
  catalog::FixtureKind multideck = kind("multideck", {1250}, 1000, 2000, 5);
  multideck.against_wall = true;
  multideck.temperature = catalog::Storage::chilled;
  catalog::FixtureKind cooler = kind("glass_door_cooler", {1250}, 700, 2000, 5);
  cooler.against_wall = true;
  cooler.temperature = catalog::Storage::chilled;
  cooler.door_swing_mm = 600;
  catalog::FixtureKind table = kind("produce_table", {1200}, 1200, 1100, 2);
  catalog::FixtureKind lane = kind("checkout_lane", {1100}, 2400, 1500, 1);
  lane.role = catalog::FixtureRole::checkout;
  catalog::FixtureKind kiosk = kind("kiosk", {2000}, 800, 1100, 0);
  kiosk.role = catalog::FixtureRole::equipment;
  c.fixture_kinds = {gondola, wall_unit, endcap, multideck, cooler, table, lane, kiosk};
  c.zone_types = {zone_type("dry_goods", "gondola"),
                  zone_type("snacks", "gondola"),
                  zone_type("household", "gondola"),
                  zone_type("bakery", "gondola"),
                  zone_type("deli", "multideck", catalog::Storage::chilled),
                  zone_type("dairy", "multideck", catalog::Storage::chilled),
                  zone_type("chilled", "glass_door_cooler", catalog::Storage::chilled),
                  zone_type("meat_fish", "multideck", catalog::Storage::chilled),
                  zone_type("produce", "produce_table"),
                  zone_type("checkout", "checkout_lane"),
                  zone_type("backroom", "")};
  catalog::ProfileRow profile;
  profile.id = "test";
  profile.name = "Test shop";
  profile.gondola_shelf_mm = 470;
  profile.module_mm = 1000;
  c.profiles = {profile};
  for (const char* id :
       {"terrazzo-white", "plaster-white", "ceiling-grid-white", "metal-white", "metal-grey"}) {
    catalog::MaterialRow material;
    material.id = id;
    material.name = id;
    material.color = "#808080";
    material.uses = {"floor", "wall", "ceiling", "fixture"};
    c.materials.push_back(material);
  }
  return c;
}

inline plan::Zone zone(std::string id, std::string type, std::string fixture) {
  plan::Zone z;
  z.id = std::move(id);
  z.type = std::move(type);
  z.fixture.kind = std::move(fixture);
  return z;
}

inline plan::Node leaf(std::string id, std::string zone_id) {
  plan::Node n;
  n.id = std::move(id);
  n.zone = std::move(zone_id);
  return n;
}

inline plan::Node cut(
    std::string id, plan::Axis axis, double ratio, int gap, std::string first, std::string second) {
  plan::Node n;
  n.id = std::move(id);
  n.split = axis;
  n.ratio = ratio;
  n.gap_mm = gap;
  n.children = {std::move(first), std::move(second)};
  return n;
}

inline plan::Opening door(
    std::string id, plan::OpeningKind kind, plan::Wall wall, double center, int width = 2000) {
  return {std::move(id), kind, wall, center, width};
}

// One zone that fills the whole room; the door is in the south wall's west corner.
inline plan::Plan one_zone(int width, int depth, plan::Zone z) {
  plan::Plan plan;
  plan.profile = "test";
  plan.look.fixture = "metal-grey";
  plan.shell.width_mm = width;
  plan.shell.depth_mm = depth;
  plan.shell.openings = {door("entrance", plan::OpeningKind::entrance, plan::Wall::south, 0.5)};
  plan.nodes = {leaf("root", z.id)};
  plan.zones = {std::move(z)};
  return plan;
}

// Tills along the south wall, gondolas north of them: 16 x 14 m.
inline plan::Plan small_shop() {
  plan::Plan plan;
  plan.name = "Small shop";
  plan.profile = "test";
  plan.look.fixture = "metal-grey";
  plan.shell.width_mm = 16000;
  plan.shell.depth_mm = 14000;
  plan.shell.openings = {door("entrance", plan::OpeningKind::entrance, plan::Wall::south, 0.15),
                         door("exit", plan::OpeningKind::exit, plan::Wall::south, 0.7)};
  plan.nodes = {cut("root", plan::Axis::y, 0.4, 2400, "front", "back"),
                leaf("front", "tills"),
                leaf("back", "goods")};
  plan.zones = {zone("tills", "checkout", "checkout_lane"), zone("goods", "dry_goods", "gondola")};
  plan.zones[0].fixture.count = 2;
  return plan;
}

// A fixture of a hand-made layout.
inline layout::Fixture fixture(std::string id,
                               std::string kind_name,
                               std::string zone_id,
                               int x,
                               int y,
                               int yaw,
                               int width,
                               int depth,
                               int sides = 1) {
  layout::Fixture f;
  f.run = id.substr(0, id.rfind('/'));
  f.id = std::move(id);
  f.kind = std::move(kind_name);
  f.zone = std::move(zone_id);
  f.x_mm = x;
  f.y_mm = y;
  f.yaw_deg = yaw;
  f.width_mm = width;
  f.depth_mm = depth;
  f.sides = sides;
  return f;
}

inline layout::LayoutZone layout_zone(std::string id, std::string type, RectMm rect) {
  return {std::move(id), std::move(type), "", polygon_of(rect), rect.area_m2()};
}

}  // namespace marketgen::sample
