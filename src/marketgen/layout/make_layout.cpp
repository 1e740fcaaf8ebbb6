#include <algorithm>

#include "layout/aisles.h"
#include "layout/faces.h"
#include "layout/floor.h"
#include "layout/layout.h"
#include "layout/module_spec.h"
#include "layout/overrides.h"
#include "layout/reach.h"
#include "layout/zone_build.h"
#include "plan/bsp.h"

namespace marketgen::layout {
namespace {

// A kind that stands in a group does not line the zone's walls besides.
void add_groups(Build& build, std::size_t index) {
  ZoneBuild& zone = build.zones[index];
  if (!zone.zone->also) return;
  for (const plan::FixtureSpec& also : *zone.zone->also) {
    const ZoneKinds kinds = kinds_beside(also, build.design.catalog);
    if (zone.kinds.wall == kinds.main && zone.kinds.wall != zone.kinds.main)
      zone.kinds.wall = nullptr;
    if (also.count == 0) continue;
    const plan::Zone& own = build.group_zones.emplace_back(with_fixtures(*zone.zone, also));
    build.groups.push_back({index, {&own, kinds, zone.zone->id + "/" + also.kind}});
  }
}

Build start_build(const Design& design, Seed seed) {
  Build build{design, Site(design), {}, {}, seed};
  for (const plan::Zone& zone : design.plan.zones) {
    build.zones.push_back({&zone, kinds_of(zone, design.catalog), zone.id});
    add_groups(build, build.zones.size() - 1);
  }
  for (Ground& ground : zone_grounds(design.plan, design.floor)) {
    const std::size_t zone = ground.zone;
    build.grounds.push_back({std::move(ground), zone});
  }
  return build;
}

std::vector<Fixture> furnish(const Design& design, Seed seed) {
  Build build = start_build(design, seed);
  place_checkouts(build);
  place_entrance(build);
  line_walls_with_groups(build);
  line_walls(build);
  stand_groups(build);
  fill_floor(build);
  fill_empty_zones(build);
  return opened_up(design, build.site.take_fixtures());
}

std::vector<LayoutZone> make_zones(const Design& design) {
  std::vector<LayoutZone> zones;
  const std::vector<RectMm> rectangles = plan::zone_rectangles(design.plan);
  for (std::size_t i = 0; i < rectangles.size(); ++i) {
    const plan::Zone& zone = design.plan.zones[i];
    const catalog::ZoneTypeRow* type = design.catalog.zone_type(zone.type);
    const std::string label = zone.label.empty() && type != nullptr ? type->label : zone.label;
    const PolygonMm polygon = zone_polygon(rectangles[i], design.floor);
    zones.push_back({zone.id, zone.type, label, polygon, area_m2(polygon)});
  }
  return zones;
}

}  // namespace

Result<Layout> make_layout(const plan::Plan& plan, const catalog::Catalog& catalog, Seed seed) {
  MARKETGEN_CHECK(check_floor(plan.shell));
  const Design design = make_design(plan, catalog);
  MARKETGEN_CHECK(check_modules(design));
  Layout layout;
  layout.name = plan.name;
  layout.profile = plan.profile;
  layout.shell = plan.shell;
  layout.shell.outline_mm = design.floor.outline;
  layout.look = plan.look;
  layout.fixtures = furnish(design, seed.child("layout"));
  if (layout.fixtures.empty()) {
    return Error{"layout.impossible",
                 "/zones",
                 "not one fixture fits into the zones; make the shop larger or the gaps between "
                 "zones narrower"};
  }
  MARKETGEN_CHECK(apply_overrides(layout.fixtures, plan, catalog));
  mark_run_ends(layout.fixtures);
  std::ranges::sort(layout.fixtures, {}, &Fixture::id);
  layout.zones = make_zones(design);
  layout.aisles = find_aisles(design, layout.fixtures);
  layout.violations = check_layout(layout, plan, catalog);
  return layout;
}

}  // namespace marketgen::layout
