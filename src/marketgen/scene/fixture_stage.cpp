#include "scene/fixture_stage.h"

#include <algorithm>

#include "layout/module_spec.h"

namespace marketgen::scene {
namespace {

constexpr int walk_mm = 6000;  // free floor all round the fixture
constexpr int ceiling_mm = 3000;
constexpr int over_mm = 300;  // from the fixture to the ceiling, at least
constexpr char zone_id[] = "stage";

plan::Shell room_for(const catalog::FixtureKind& kind) {
  plan::Shell shell;
  shell.width_mm = kind.module_widths_mm.front() + 2 * walk_mm;
  shell.depth_mm = kind.depth_mm + 2 * walk_mm;
  shell.ceiling_mm = std::max(ceiling_mm, kind.height_mm + over_mm);
  const int w = shell.width_mm, d = shell.depth_mm;
  shell.outline_mm = PolygonMm{{0, 0}, {w, 0}, {w, d}, {0, d}};
  return shell;
}

layout::Fixture module_of(const catalog::FixtureKind& kind, const plan::Shell& room) {
  layout::Fixture fixture = layout::lone_module(kind);
  fixture.id = fixture.run = kind.kind;
  fixture.zone = zone_id;
  fixture.x_mm = room.width_mm / 2;
  fixture.y_mm = room.depth_mm / 2;
  return fixture;
}

// A zone that sells no category that there is.
plan::Zone bare_zone() {
  plan::Zone zone;
  zone.id = zone.type = zone_id;
  zone.stock.categories = {"nothing"};
  return zone;
}

}  // namespace

Result<Scene> stage_fixture(const catalog::FixtureKind& kind, const catalog::Catalog& catalog) {
  layout::Layout layout;
  layout.name = kind.name;
  layout.shell = room_for(kind);
  layout.fixtures.push_back(module_of(kind, layout.shell));
  plan::Plan plan;
  plan.shell = layout.shell;
  plan.zones.push_back(bare_zone());
  return build_scene(layout, plan, catalog, Seed(0));
}

}  // namespace marketgen::scene
