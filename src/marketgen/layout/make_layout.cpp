#include <algorithm>
#include <set>

#include "layout/accessories.h"
#include "layout/aisles.h"
#include "layout/faces.h"
#include "layout/finish.h"
#include "layout/floor.h"
#include "layout/in_line.h"
#include "layout/kept_layout.h"
#include "layout/layout.h"
#include "layout/module_spec.h"
#include "layout/overrides.h"
#include "layout/reach.h"
#include "layout/standing_site.h"
#include "layout/zone_build.h"
#include "layout/zone_ground.h"

namespace marketgen::layout {
namespace {

// A kind that stands in a group does not line the zone's walls besides. Without a count or runs it
// is no group: `also` says how what lines the walls is built.
void add_groups(Build& build, std::size_t index) {
  ZoneBuild& zone = build.zones[index];
  if (!zone.zone->also) return;
  for (const plan::FixtureSpec& also : *zone.zone->also) {
    if (!also.count && !also.runs) continue;
    const ZoneKinds kinds = kinds_beside(also, build.design.catalog);
    if (zone.kinds.wall == kinds.main && zone.kinds.wall != zone.kinds.main)
      zone.kinds.wall = nullptr;
    if (also.count == 0) continue;
    const plan::Zone& own = build.group_zones.emplace_back(with_fixtures(*zone.zone, also));
    build.groups.push_back({index, {&own, kinds, zone.zone->id + "/" + also.kind}});
  }
}

// Whether a run of the make finds the floor that one of the kind has.
bool has_room(const RectMm& floor,
              const catalog::FixtureKind& kind,
              const catalog::FixtureKind& make,
              const Design& design) {
  constexpr int modules = 3;  // of a run that is worth it
  const auto [shorter, longer] = std::minmax(floor.width(), floor.depth());
  const auto narrowest = [](const catalog::FixtureKind& row) {
    return *std::ranges::min_element(row.module_widths_mm);
  };
  const bool long_enough =
      narrowest(make) <= narrowest(kind) || longer >= modules * narrowest(make);
  const int aisle = std::max(design.min_aisle_mm() + static_cast<int>(make.door_swing_mm),
                             static_cast<int>(make.front_clearance_mm));
  return long_enough && (make.depth_mm <= kind.depth_mm || shorter >= make.depth_mm + aisle);
}

// What the store has in the place of the kind in this zone.
const catalog::FixtureKind* make_in_zone(const Build& build,
                                         std::size_t zone,
                                         const catalog::FixtureKind* kind) {
  if (kind == nullptr) return nullptr;
  const Design& design = build.design;
  const catalog::FixtureKind& make = design.makes.of(*kind, design.plan.zones[zone].type);
  const bool fits = std::ranges::any_of(build.grounds, [&](const GroundBuild& ground) {
    return ground.zone == zone && has_room(ground.ground.rect, *kind, make, design);
  });
  return fits && may_have(design.plan, zone, *kind, make) ? &make : kind;
}

// Whether the plan says how the kind along the zone's walls is built: by its name in `also`, or by
// how far all of the zone's boards are apart.
bool walls_are_described(const plan::Zone& zone, const catalog::FixtureKind* wall) {
  return zone.fixture.spacing_mm ||
         (zone.also && wall != nullptr &&
          std::ranges::find(*zone.also, wall->kind, &plan::FixtureSpec::kind) != zone.also->end());
}

// Along walls nothing stands that is taken from on both sides.
void choose_makes(Build& build) {
  for (std::size_t i = 0; i < build.zones.size(); ++i) {
    ZoneKinds& kinds = build.zones[i].kinds;
    const catalog::FixtureKind* wall = walls_are_described(*build.zones[i].zone, kinds.wall)
                                           ? kinds.wall
                                           : make_in_zone(build, i, kinds.wall);
    kinds.main = make_in_zone(build, i, kinds.main);
    if (wall == nullptr || !wall->double_sided) kinds.wall = wall;
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
  choose_makes(build);
  return build;
}

void furnish_zones(Build& build) {
  place_checkouts(build);
  place_entrance(build);
  line_walls_with_groups(build);
  line_walls(build);
  stand_groups(build);
  fill_floor(build);
  fill_empty_zones(build);
}

// What stands, where the plan pins it, and accessories round it.
Result<std::vector<Fixture>> with_pins(const Build& build, std::vector<Fixture> fixtures) {
  std::vector<ZoneFloor> floors;
  for (const GroundBuild& ground : build.grounds)
    floors.push_back({build.zones[ground.zone].zone->id, ground.ground.rect});
  MARKETGEN_CHECK(move_runs(fixtures, build.design.plan, floors));
  put_in_line(fixtures, build);
  return with_accessories(build, std::move(fixtures));
}

Result<std::vector<Fixture>> furnish(const Design& design, Seed seed) {
  Build build = start_build(design, seed);
  furnish_zones(build);
  return with_pins(build, opened_up(design, build.site.take_fixtures()));
}

// Puts the fixtures of zones that are not furnished anew where they stood.
void keep_fixtures(Build& build, const Layout& before) {
  std::vector<Fixture> kept;
  for (const ZoneBuild& zone : build.zones) {
    if (!zone.stands) continue;
    for (const Fixture& stood : before.fixtures) {
      if (stood.zone != zone.zone->id) continue;
      change_finish(
          kept.emplace_back(stood), before.look, build.design.plan.look, build.design.catalog);
    }
  }
  stand_again(build.site, build.design, kept);
}

Result<std::vector<Fixture>> furnish_round(const Design& design,
                                           Seed seed,
                                           const Layout& before,
                                           const std::set<std::string>& furnish) {
  Build build = start_build(design, seed);
  std::set<std::string> standing;
  for (ZoneBuild& zone : build.zones) {
    zone.stands = !furnish.contains(zone.zone->id);
    if (zone.stands) standing.insert(zone.zone->id);
  }
  std::erase_if(build.groups,
                [&](const GroupBuild& group) { return build.zones[group.zone].stands; });
  keep_fixtures(build, before);
  furnish_zones(build);
  return with_pins(build, opened_up(design, build.site.take_fixtures(), standing));
}

// Everything of the layout but its fixtures, and what depends on all of them.
Result<Layout> with_fixtures(const Design& design, std::vector<Fixture> fixtures) {
  const plan::Plan& plan = design.plan;
  Layout layout;
  layout.name = plan.name;
  layout.profile = plan.profile;
  layout.shell = plan.shell;
  layout.shell.outline_mm = design.floor.outline;
  layout.look = plan.look;
  layout.time = plan.time;
  if (plan.outfit == plan::Outfit::full) {
    layout.outfit = plan.outfit;
    layout.country = plan.country;
  }
  layout.fixtures = std::move(fixtures);
  if (layout.fixtures.empty()) {
    return Error{"layout.impossible",
                 "/zones",
                 "not one fixture fits into the zones; make the shop larger or the gaps between "
                 "zones narrower"};
  }
  MARKETGEN_CHECK(apply_overrides(layout.fixtures, plan, design.catalog));
  mark_run_ends(layout.fixtures);
  if (layout.outfit) close_joints_of_kinds(layout.fixtures);
  std::ranges::sort(layout.fixtures, {}, &Fixture::id);
  layout.zones = layout_zones(design);
  layout.aisles = find_aisles(design, layout.fixtures);
  layout.violations = check_layout(layout, plan, design.catalog);
  return layout;
}

constexpr std::string_view fixtures_stream = "layout", makes_stream = "makes";

Design design_with_makes(const plan::Plan& plan, const catalog::Catalog& catalog, Seed seed) {
  Design design = make_design(plan, catalog);
  if (plan.outfit == plan::Outfit::full)
    design.makes = Makes(plan, catalog, seed.child(makes_stream));
  return design;
}

}  // namespace

Result<Layout> make_layout(const plan::Plan& plan, const catalog::Catalog& catalog, Seed seed) {
  MARKETGEN_CHECK(check_floor(plan.shell));
  const Design design = design_with_makes(plan, catalog, seed);
  MARKETGEN_CHECK(check_modules(design));
  MARKETGEN_TRY(std::vector<Fixture> fixtures, furnish(design, seed.child(fixtures_stream)));
  return with_fixtures(design, std::move(fixtures));
}

Result<Layout> make_layout_keeping(const plan::Plan& plan,
                                   const catalog::Catalog& catalog,
                                   Seed seed,
                                   const Layout& before,
                                   const std::set<std::string>& furnish) {
  MARKETGEN_CHECK(check_floor(plan.shell));
  const Design design = design_with_makes(plan, catalog, seed);
  MARKETGEN_CHECK(check_modules(design));
  MARKETGEN_TRY(std::vector<Fixture> fixtures,
                furnish_round(design, seed.child(fixtures_stream), before, furnish));
  return with_fixtures(design, std::move(fixtures));
}

}  // namespace marketgen::layout
