#include "layout/accessories.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "layout/accessory_spots.h"
#include "layout/entrance.h"
#include "layout/floor_guard.h"
#include "layout/lists.h"
#include "layout/standing_site.h"

namespace marketgen::layout {
namespace {

// Of the profile's clearance before and after the tills, what stays free; CHECKOUT_TIGHT wants 0.6.
constexpr double accessory_line_share = 0.61;
constexpr std::string_view with_zone = "/with/";  // of an accessory's run
constexpr std::string_view by_door = "/entrance/";

// "trolley" of trolley_bay and trolley-240.
std::string_view first_word(std::string_view kind) {
  return kind.substr(0, kind.find_first_of("_-"));
}

// What the plan says of a kind or of its like holds: how many there are, or none.
bool plan_counts(const plan::Plan& plan, std::string_view kind) {
  const auto is_it = [&](const auto& spec) { return spec.kind == kind && spec.count; };
  const auto in_zone = [&](const plan::Zone& zone) {
    return is_it(zone.fixture) || (zone.also && std::ranges::any_of(*zone.also, is_it));
  };
  const bool at_doors =
      plan.equipment && std::ranges::any_of(*plan.equipment, [&](const plan::EquipmentSpec& spec) {
        return first_word(spec.kind) == first_word(kind);
      });
  return at_doors || std::ranges::any_of(plan.zones, in_zone);
}

// Somebody said how wide aisles are: nothing stands in them or where they end.
bool aisles_are_described(const plan::Plan& plan) {
  return std::ranges::any_of(plan.provenance, [](const plan::Provenance& said) {
    return said.source != plan::Source::repair && said.path.ends_with("/aisle_mm");
  });
}

// The number of one row's accessories in one zone.
int number_in(const AccessoryRow& row, double area) {
  if (row.zone_m2 <= 0) return 1;
  return static_cast<int>(area / row.zone_m2 + 0.5);
}

class Accessories {
 public:
  explicit Accessories(Build& build)
      : build_(build),
        guard_(build.design, build.site.fixtures()),
        empty_(build.design.floor, build.site.fixtures()),
        seed_(build.seed.child("accessories")) {}

  void place(const AccessoryRow& row) {
    const Design& design = build_.design;
    const bool suits = (row.profiles.empty() || lists(row.profiles, design.plan.profile)) &&
                       (!row.only_full || design.plan.outfit == plan::Outfit::full);
    if (!suits || area_m2(design.floor.outline) < row.store_m2) return;
    const catalog::FixtureKind* kind = drawn_kind(row);
    if (kind == nullptr || plan_counts(design.plan, kind->kind)) return;
    int left = row.most - standing(row);
    if (row.at_door()) {
      place_at_door(row, *kind, left);
      return;
    }
    for (std::size_t i = 0; i < build_.zones.size() && left > 0; ++i)
      left -= place_in_zone(row, *kind, i, left);
  }

 private:
  // The same in all of the store.
  const catalog::FixtureKind* drawn_kind(const AccessoryRow& row) const {
    const int last = static_cast<int>(row.kinds.size()) - 1;
    const int drawn = seed_.child(row.id).stream().integer(0, last);
    return build_.design.catalog.fixture_kind(row.kinds[static_cast<std::size_t>(drawn)]);
  }

  int standing(const AccessoryRow& row) const {
    const std::string of_row = std::string(with_zone) + std::string(row.id) + "-";
    return static_cast<int>(std::ranges::count_if(
        build_.site.fixtures(),
        [&](const Fixture& fixture) { return fixture.run.find(of_row) != std::string::npos; }));
  }

  void place_at_door(const AccessoryRow& row, const catalog::FixtureKind& kind, int left) {
    const Design& design = build_.design;
    const bool out = row.places.front() != AccessoryPlace::entrance;
    const Doorway* door = out ? exit_of(design.floor, design.plan.shell)
                              : entrance_of(design.floor, design.plan.shell);
    const ZoneBuild* owner =
        door == nullptr || door->approach.empty() ? nullptr : nearest_zone(build_, door->threshold);
    if (owner == nullptr || owner->stands) return;
    if (left > 0 && seed_of(row, *owner).child("has").stream().chance(row.chance))
      place_some(row, kind, *owner, door, left);
  }

  int place_in_zone(const AccessoryRow& row,
                    const catalog::FixtureKind& kind,
                    std::size_t index,
                    int most) {
    const ZoneBuild& zone = build_.zones[index];
    if (zone.stands || !lists(row.zones, zone.zone->type)) return 0;
    const plan::Plan& plan = build_.design.plan;
    const bool goods = kind.role == catalog::FixtureRole::shelving;
    if (goods && is_described(plan, index)) return 0;
    if (!seed_of(row, zone).child("has").stream().chance(row.chance)) return 0;
    double area = 0;
    for (const GroundBuild& ground : build_.grounds)
      area += ground.zone == index ? ground.ground.rect.area_m2() : 0;
    return place_some(row, kind, zone, nullptr, std::min(most, number_in(row, area)));
  }

  Seed seed_of(const AccessoryRow& row, const ZoneBuild& zone) const {
    return seed_.child(row.id).child(zone.zone->id);
  }

  // As many of `wanted` as find a spot; returns how many did.
  int place_some(const AccessoryRow& row,
                 const catalog::FixtureKind& kind,
                 const ZoneBuild& zone,
                 const Doorway* door,
                 int wanted) {
    const ModuleSpec spec = one_sided(module_spec(build_.design, *zone.zone, kind));
    int placed = 0;
    while (placed < wanted) {
      const Seed seed = seed_of(row, zone).child("spot", static_cast<std::uint64_t>(placed));
      const SpotSearch search{build_, zone, door, spec, empty_, seed};
      const int added = place_group(row, search, placed);
      if (added == 0) break;
      placed += added;
    }
    return placed;
  }

  // At the first spot that the floor bears.
  int place_group(const AccessoryRow& row, const SpotSearch& search, int number) {
    for (const AccessoryPlace place : row.places) {
      const bool in_aisles =
          place == AccessoryPlace::run_end || place == AccessoryPlace::open_floor;
      if (in_aisles && aisles_are_described(build_.design.plan)) continue;
      for (const SpotGroup& group : find_spots(search, place)) {
        std::vector<Fixture> units;
        for (const Spot& spot : group)
          units.push_back(unit_at(row, search, spot, number + static_cast<int>(units.size()) + 1));
        const bool carried = place == AccessoryPlace::over_run;
        const int clear_mm = place == AccessoryPlace::way_out ? 0 : clear_before_mm(search);
        if (!std::ranges::all_of(
                units, [&](const Fixture& unit) { return may_stand(unit, clear_mm, place); }))
          continue;
        for (Fixture& unit : units)
          add(std::move(unit), clear_mm, carried);
        return static_cast<int>(group.size());
      }
    }
    return 0;
  }

  static Fixture unit_at(const AccessoryRow& row,
                         const SpotSearch& search,
                         const Spot& spot,
                         int number) {
    Fixture unit = make_module(search.spec, *search.zone.zone);
    unit.run = search.zone.zone->id + std::string(with_zone) + std::string(row.id) + "-" +
               std::to_string(number);
    unit.id = unit.run + "/module-1";
    unit.x_mm = spot.rect.center()[0];
    unit.y_mm = spot.rect.center()[1];
    unit.yaw_deg = yaw_facing(spot.front);
    unit.width_mm = along(spot.rect, spot.front).length();
    unit.height_mm = spot.height_mm;
    if (spot.foot_mm > 0) unit.base_mm = spot.foot_mm;
    unit.run_start = unit.run_end = true;
    return unit;
  }

  // What the wall carries takes no floor.
  bool may_stand(const Fixture& unit, int clear_mm, AccessoryPlace place) const {
    if (place == AccessoryPlace::over_run) return true;
    const RectMm rect = footprint_of(unit);
    return build_.site.can_stand(rect) &&
           build_.site.is_clear(strip_beyond(rect, facing_of(unit.yaw_deg), clear_mm)) &&
           guard_.allows(unit);
  }

  void add(Fixture unit, int clear_mm, bool carried) {
    if (carried) {
      build_.site.hang(std::move(unit));
      return;
    }
    guard_.add(unit);
    empty_.add(footprint_of(unit));
    build_.site.add(std::move(unit), clear_mm);
  }

  Build& build_;
  FloorGuard guard_;
  EmptyFloor empty_;
  Seed seed_;
};

}  // namespace

const std::vector<AccessoryRow>& accessory_rows() {
  using enum AccessoryPlace;
#define LIST(...) \
  { __VA_ARGS__ }
#define ACCESSORY(id, kinds, places, zones, profiles, ...) \
  {#id, kinds, places, zones, profiles, __VA_ARGS__},
#define FULL_ACCESSORY(id, kinds, places, zones, profiles, ...) \
  {#id, kinds, places, zones, profiles, __VA_ARGS__, true},
  static const std::vector<AccessoryRow> rows{
#include "layout/accessories.inc"
  };
#undef FULL_ACCESSORY
#undef ACCESSORY
#undef LIST
  return rows;
}

bool is_described(const plan::Plan& plan, std::size_t zone) {
  const plan::FixtureSpec& spec = plan.zones[zone].fixture;
  if (spec.count || spec.runs || plan.zones[zone].also) return true;
  const std::string path = "/zones/" + std::to_string(zone) + "/fixture/";
  const bool looks_count = plan.outfit != plan::Outfit::full;
  return std::ranges::any_of(plan.provenance, [&](const plan::Provenance& said) {
    const bool of_looks = said.path.ends_with("/color") || said.path.ends_with("/material");
    return said.source != plan::Source::repair && said.path.starts_with(path) &&
           (looks_count || !of_looks);
  });
}

bool is_accessory(const Fixture& fixture) {
  return fixture.run.find(with_zone) != std::string::npos ||
         fixture.run.find(by_door) != std::string::npos;
}

std::vector<Fixture> with_accessories(const Build& furnished, std::vector<Fixture> fixtures) {
  Build build{
      furnished.design, Site(furnished.design), furnished.zones, furnished.grounds, furnished.seed};
  stand_again(build.site, build.design, fixtures, accessory_line_share);
  if (fixtures.empty()) return fixtures;
  Accessories accessories(build);
  for (const AccessoryRow& row : accessory_rows())
    accessories.place(row);
  return build.site.take_fixtures();
}

}  // namespace marketgen::layout
