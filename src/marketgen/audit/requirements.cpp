#include "audit/requirements.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "audit/metrics.h"
#include "audit/straight_runs.h"
#include "audit/traffic.h"
#include "layout/floor.h"
#include "layout/relations.h"
#include "scene/assortment.h"

namespace marketgen::audit {
namespace {

struct Verdict {
  bool met;
  std::string why;
};

// What every check may look at.
struct Facts {
  const scene::Scene& scene;
  const catalog::Catalog& catalog;
  std::vector<std::uint64_t> items_on_fixture;
};

Facts facts_of(const scene::Scene& scene, const catalog::Catalog& catalog) {
  Facts facts{scene, catalog, std::vector<std::uint64_t>(scene.fixtures.size(), 0)};
  for (const scene::Facing& f : scene.facings)
    facts.items_on_fixture[scene.shelves[f.shelf].fixture] += f.product_count;
  return facts;
}

bool compares(const plan::Requirement& r, double measured, double tolerance = 1e-9) {
  switch (r.comparison) {
    case plan::Comparison::at_least:
      return measured >= r.value - tolerance;
    case plan::Comparison::at_most:
      return measured <= r.value + tolerance;
    default:
      return std::abs(measured - r.value) <= tolerance;
  }
}

std::string_view sign(plan::Comparison comparison) {
  switch (comparison) {
    case plan::Comparison::at_least:
      return "at least ";
    case plan::Comparison::at_most:
      return "at most ";
    default:
      return "";
  }
}

Verdict number_verdict(const plan::Requirement& r,
                       double measured,
                       std::string_view what,
                       std::string_view unit,
                       double tolerance = 1e-9) {
  return {compares(r, measured, tolerance),
          fmt::format("{} {:g}{}; asked for {}{:g}{}",
                      what,
                      measured,
                      unit,
                      sign(r.comparison),
                      r.value,
                      unit)};
}

bool is_of(const layout::LayoutZone& zone, const std::string& name) {
  return zone.type == name || zone.id == name;
}

std::vector<const layout::LayoutZone*> zones_of(const Facts& facts, const std::string& name) {
  std::vector<const layout::LayoutZone*> zones;
  for (const layout::LayoutZone& zone : facts.scene.layout.zones) {
    if (is_of(zone, name)) zones.push_back(&zone);
  }
  return zones;
}

bool in_zone(const Facts& facts, const layout::Fixture& fixture, const std::string& name) {
  if (name.empty()) return true;
  const layout::LayoutZone* zone = layout::find_zone(facts.scene.layout, fixture.zone);
  return zone != nullptr && is_of(*zone, name);
}

// Within a few steps of such a door.
bool stands_by(const Facts& facts, const layout::Fixture& fixture, plan::OpeningKind kind) {
  constexpr double steps_mm = 6000;
  const RectMm rect = layout::footprint_of(fixture);
  const layout::Floor floor = layout::make_floor(facts.scene.layout.shell);
  return std::any_of(floor.doorways.begin(), floor.doorways.end(), [&](const auto& door) {
    return facts.scene.layout.shell.openings[door.opening].kind == kind &&
           distance_mm(rect, point_rect(door.threshold)) <= steps_mm + door.span.length() / 2.0;
  });
}

// A zone is there when it covers floor and what its type needs stands in it: shelving with goods on
// it, or tills and equipment. What stands at the entrance happens to lie in some zone.
bool zone_is_there(const Facts& facts, const layout::LayoutZone& zone) {
  const catalog::ZoneTypeRow* type = facts.catalog.zone_type(zone.type);
  if (type == nullptr || type->fixture.empty()) return zone.area_m2 > 0;
  const catalog::FixtureKind* usual = facts.catalog.fixture_kind(type->fixture);
  const catalog::FixtureRole role = usual != nullptr ? usual->role : catalog::FixtureRole::shelving;
  const auto& fixtures = facts.scene.layout.fixtures;
  for (std::size_t i = 0; i < fixtures.size(); ++i) {
    const bool at_entrance = fixtures[i].run.find("/entrance/") != std::string::npos;
    if (fixtures[i].zone != zone.id || at_entrance) continue;
    const catalog::FixtureKind* kind = facts.catalog.fixture_kind(fixtures[i].kind);
    const bool of_use = role == catalog::FixtureRole::shelving
                            ? facts.items_on_fixture[i] > 0
                            : kind != nullptr && kind->role == role;
    if (of_use) return true;
  }
  return false;
}

// Nothing, or the zone type among the names that the store has no goods or equipment of.
std::string missing_zone(const Facts& facts, std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) {
    if (facts.catalog.zone_type(name) == nullptr) continue;
    const auto there = [&](const layout::LayoutZone& zone) {
      const bool till = name == "checkout" && zone.type == "self_checkout";
      return (is_of(zone, std::string(name)) || till) && zone_is_there(facts, zone);
    };
    const auto& zones = facts.scene.layout.zones;
    if (std::none_of(zones.begin(), zones.end(), there)) return std::string(name);
  }
  return {};
}

// ---- One function per kind of requirement. ----

Verdict check_size(const Facts& facts, const plan::Requirement& r) {
  const plan::Shell& shell = facts.scene.layout.shell;
  const auto as_asked = [](double said, int built) {  // 0: that side was not said
    constexpr double tolerance_mm = 10;
    return said == 0 || std::abs(built - said) <= tolerance_mm;
  };
  const bool met = as_asked(r.value, shell.width_mm) && as_asked(r.second_value, shell.depth_mm);
  return {met,
          fmt::format("the room is {:g} x {:g} m", shell.width_mm * 1e-3, shell.depth_mm * 1e-3)};
}

Verdict check_area(const Facts& facts, const plan::Requirement& r) {
  if (r.subject.empty())
    return number_verdict(r,
                          area_m2(plan::floor_of(facts.scene.layout.shell)),
                          "the room has",
                          " m2",
                          0.05 * r.value);
  double area = 0;
  for (const layout::LayoutZone* zone : zones_of(facts, r.subject))
    area += zone_is_there(facts, *zone) ? zone->area_m2 : 0;
  constexpr double share = 0.15;  // zones snap to whole modules and aisles
  return number_verdict(r, std::round(area * 10) / 10, r.subject + " has", " m2", share * r.value);
}

std::size_t zones_there(const Facts& facts, const std::string& name) {
  const auto zones = zones_of(facts, name);
  return static_cast<std::size_t>(
      std::count_if(zones.begin(), zones.end(), [&](const layout::LayoutZone* z) {
        return zone_is_there(facts, *z);
      }));
}

Verdict check_zone_present(const Facts& facts, const plan::Requirement& r) {
  const std::size_t number = zones_there(facts, r.subject);
  return {number > 0,
          fmt::format(
              "{} {} zone{} with goods or equipment", number, r.subject, number == 1 ? "" : "s")};
}

Verdict check_zone_absent(const Facts& facts, const plan::Requirement& r) {
  const std::size_t number = zones_of(facts, r.subject).size();
  return {number == 0, fmt::format("{} {} zones", number, r.subject)};
}

// Of the kind, in the zone type or by the door that the wish names (second_object).
bool is_counted(const Facts& facts, const plan::Requirement& r, const layout::Fixture& fixture) {
  const std::string kind = r.subject == "checkout" ? "checkout_lane" : r.subject;
  const bool counter = kind == "checkout_lane" && fixture.kind == "till-counter";  // small shops
  if (fixture.kind != kind && !counter) return false;
  const auto door = value_named<plan::OpeningKind>(r.second_object);
  return door ? stands_by(facts, fixture, *door) : in_zone(facts, fixture, r.second_object);
}

Verdict check_fixture_count(const Facts& facts, const plan::Requirement& r) {
  const auto& fixtures = facts.scene.layout.fixtures;
  const auto number = std::count_if(fixtures.begin(), fixtures.end(), [&](const auto& fixture) {
    return is_counted(facts, r, fixture);
  });
  return number_verdict(r, static_cast<double>(number), r.subject + ":", "");
}

// Straight lines of modules that stand together: those of one run, a double-sided one or two back
// to back counting once where sides are asked for.
Verdict check_run_count(const Facts& facts, const plan::Requirement& r) {
  std::vector<layout::Fixture> counted;
  for (const layout::Fixture& fixture : facts.scene.layout.fixtures) {
    if (is_counted(facts, r, fixture)) counted.push_back(fixture);
  }
  const std::vector<StraightRun> runs = straight_runs(counted);
  int single = 0, paired = 0, twofold = 0;
  for (const StraightRun& run : runs) {
    if (run.sides == 2)
      ++twofold;
    else
      ++(run.back_to_back ? paired : single);
  }
  if (r.second_value == 0) return number_verdict(r, static_cast<double>(runs.size()), "runs:", "");
  const int both = twofold + paired / 2;
  const bool two = r.second_value == 2;
  Verdict verdict =
      number_verdict(r, two ? both : single, two ? "double-sided runs:" : "single-sided runs:", "");
  const int others = two ? single : both;
  if (others == 0) return verdict;
  return {false, verdict.why + fmt::format("; {} others", others)};
}

Verdict check_aisle_count(const Facts& facts, const plan::Requirement& r) {
  return number_verdict(r, shopping_aisles(facts.scene), "aisles between shelves:", "");
}

// Ambient shelving with several levels: what people mean by "shelves".
bool is_shelving(const Facts& facts, const layout::Fixture& fixture) {
  const catalog::FixtureKind* kind = facts.catalog.fixture_kind(fixture.kind);
  constexpr int several = 4;
  return kind != nullptr && kind->role == catalog::FixtureRole::shelving &&
         kind->temperature == catalog::Storage::ambient && kind->level_range[1] >= several;
}

// Whether what is asked of `zone` ("": of all but some) is asked of what stands there.
bool holds_for(const Facts& facts,
               const plan::Requirement& r,
               const std::string& zone,
               const layout::Fixture& fixture) {
  return in_zone(facts, fixture, zone) &&
         std::ranges::none_of(
             r.except, [&](const std::string& name) { return in_zone(facts, fixture, name); });
}

// The shelves of a zone, or all gondolas.
bool levels_count(const Facts& facts, const plan::Requirement& r, std::size_t i) {
  const layout::Fixture& fixture = facts.scene.layout.fixtures[i];
  const bool meant = r.subject.empty() ? is_shelving(facts, fixture) && fixture.kind == "gondola"
                                       : facts.scene.fixtures[i].shelf_count > 0;
  return meant && fixture.endcap_of.empty() && holds_for(facts, r, r.subject, fixture);
}

// Heights of the boards of one side over the floor, lowest first.
std::vector<double> boards_mm(const Facts& facts, std::size_t i) {
  const scene::SceneFixture& row = facts.scene.fixtures[i];
  std::vector<double> heights;
  for (std::uint32_t s = row.first_shelf; s < row.first_shelf + row.shelf_count; ++s) {
    if (facts.scene.shelves[s].side == 0)
      heights.push_back(1e3 * static_cast<double>(facts.scene.shelves[s].position_m[2]));
  }
  std::ranges::sort(heights);
  return heights;
}

Verdict check_levels(const Facts& facts, const plan::Requirement& r) {
  std::set<std::size_t> seen;
  for (std::size_t i = 0; i < facts.scene.fixtures.size(); ++i) {
    if (levels_count(facts, r, i)) seen.insert(boards_mm(facts, i).size());
  }
  const bool met = !seen.empty() && std::ranges::all_of(seen, [&](std::size_t n) {
    return compares(r, static_cast<double>(n));
  });
  return {met,
          fmt::format("shelves have {} levels; asked for {}{:g}",
                      fmt::join(seen, " or "),
                      sign(r.comparison),
                      r.value)};
}

Verdict check_shelf_pitch(const Facts& facts, const plan::Requirement& r) {
  constexpr double tolerance_mm = 5;  // boards hang in slots
  std::set<long> seen;                // whole millimetres
  bool met = true;
  for (std::size_t i = 0; i < facts.scene.fixtures.size(); ++i) {
    if (!levels_count(facts, r, i)) continue;
    const std::vector<double> heights = boards_mm(facts, i);
    for (std::size_t k = 1; k < heights.size(); ++k) {
      const double pitch = heights[k] - heights[k - 1];
      met = met && compares(r, pitch, tolerance_mm);
      seen.insert(std::lround(pitch));
    }
  }
  if (seen.empty()) return {false, "there are no such shelves with several levels"};
  return {met,
          fmt::format("boards are {} to {} mm apart; asked for {}{:g} mm",
                      *seen.begin(),
                      *seen.rbegin(),
                      sign(r.comparison),
                      r.value)};
}

Verdict check_relation_holds(const Facts& facts, const plan::Requirement& r) {
  const bool apart = r.relation == plan::RelationKind::far ||
                     r.relation == plan::RelationKind::not_adjacent;  // of what is there
  const std::string missing = missing_zone(facts, {r.subject, r.object, r.second_object});
  if (!apart && !missing.empty())
    return {false, "there is no " + missing + " zone with goods or equipment"};
  const plan::NamedFloor floor = layout::named_floor(facts.scene.layout);
  const plan::RelationTerms terms = plan::terms_of(r);
  const auto measure = plan::measure_relation(floor, terms);
  return {measure && measure->holds(), plan::words_of(floor, terms, measure)};
}

Verdict check_style(const Facts& facts, const plan::Requirement& r) {
  const catalog::StyleRow* style = facts.catalog.style(r.object);
  const plan::Look& look = facts.scene.layout.look;
  if (style == nullptr) return {false, "there is no such style"};
  const int same = (look.floor == style->floor) + (look.wall == style->wall) +
                   (look.ceiling == style->ceiling) + (look.fixture == style->fixture) +
                   (look.accent == style->accent);
  constexpr int enough = 3;  // a wish for one material may override part of a style
  return {same >= enough, fmt::format("{} of 5 parts of the look are those of {}", same, r.object)};
}

Verdict check_profile(const Facts& facts, const plan::Requirement& r) {
  return {facts.scene.layout.profile == r.object, "the profile is " + facts.scene.layout.profile};
}

std::string look_part(const plan::Look& look, const std::string& part) {
  if (part == "floor") return look.floor;
  if (part == "wall") return look.wall;
  if (part == "ceiling") return look.ceiling;
  if (part == "accent") return look.accent;
  return look.fixture;
}

Verdict check_material(const Facts& facts, const plan::Requirement& r) {
  const std::string found = look_part(facts.scene.layout.look, r.subject);
  return {found == r.object, fmt::format("{} is {}", r.subject, found)};
}

Verdict check_color(const Facts& facts, const plan::Requirement& r) {
  if (r.subject == "accent") return check_material(facts, r);
  int with = 0, all = 0;
  for (const layout::Fixture& f : facts.scene.layout.fixtures) {
    if (!is_shelving(facts, f)) continue;
    ++all;
    with += f.color == r.object ? 1 : 0;
  }
  return {all > 0 && with == all, fmt::format("{} of {} shelves are {}", with, all, r.object)};
}

// Wanted products stand on a shelf; those that are not wanted are not even on offer.
Verdict check_product(const Facts& facts, const plan::Requirement& r, bool wanted) {
  const auto& rows = facts.scene.catalog;
  std::vector<bool> named(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    named[i] = scene::named_by(rows[i], {r.subject});
  const auto offered = std::count(named.begin(), named.end(), true);
  const auto standing = std::count_if(facts.scene.products.begin(),
                                      facts.scene.products.end(),
                                      [&](const scene::SceneProduct& p) { return named[p.sku]; });
  const std::string why = fmt::format(
      "{} products on offer are named \"{}\", {} items of them", offered, r.subject, standing);
  return {wanted ? standing > 0 : offered == 0 && standing == 0, why};
}

// In the wall that was named, and on the side of it: the west or south half, the other, or the
// middle.
bool is_in_place(const plan::Opening& opening, const plan::Requirement& r) {
  if (const auto wall = value_named<plan::Wall>(r.object); wall && opening.wall != *wall)
    return false;
  constexpr double middle = 0.5, max_off_middle = 0.2;
  const std::string& end = r.second_object;
  if (end == "center") return std::abs(opening.center - middle) <= max_off_middle;
  if (end == "west" || end == "south") return opening.center <= middle;
  if (end == "east" || end == "north") return opening.center >= middle;
  return true;
}

Verdict check_opening(const Facts& facts, const plan::Requirement& r) {
  const auto& openings = facts.scene.layout.shell.openings;
  const auto number = std::count_if(openings.begin(), openings.end(), [&](const plan::Opening& o) {
    return name_of(o.kind) == r.subject && is_in_place(o, r);
  });
  const std::string what =
      r.subject + (r.object.empty() && r.second_object.empty() ? ":" : " openings there:");
  if (r.value > 0 || r.comparison == plan::Comparison::at_most)
    return number_verdict(r, static_cast<double>(number), what, "");
  return {number > 0, fmt::format("{} {}", what, number)};
}

Verdict check_endcaps(const Facts& facts, const plan::Requirement& r) {
  const auto& fixtures = facts.scene.layout.fixtures;
  const auto number =
      std::count_if(fixtures.begin(), fixtures.end(), [&](const layout::Fixture& f) {
        return !f.endcap_of.empty() && in_zone(facts, f, r.subject);
      });
  const bool unwanted = r.comparison == plan::Comparison::at_most && r.value == 0;
  return {unwanted ? number == 0 : number > 0, fmt::format("{} endcaps", number)};
}

Verdict check_height(const Facts& facts, const plan::Requirement& r) {
  if (r.subject == "ceiling")
    return number_verdict(r, facts.scene.layout.shell.ceiling_mm, "the ceiling is at", " mm", 10);
  double lowest = 0, highest = 0;
  for (const layout::Fixture& f : facts.scene.layout.fixtures) {
    const bool counted = r.subject.empty() || r.subject == "shelf" ||
                                 facts.catalog.fixture_kind(r.subject) == nullptr
                             ? f.kind == "gondola"
                             : f.kind == r.subject;
    if (!counted || !holds_for(facts, r, r.object, f)) continue;
    lowest = lowest == 0 ? f.height_mm : std::min<double>(lowest, f.height_mm);
    highest = std::max<double>(highest, f.height_mm);
  }
  if (highest == 0) return {false, "there are no such fixtures"};
  const bool low_is_worse =
      r.comparison == plan::Comparison::at_least ||
      (r.comparison == plan::Comparison::equal && r.value - lowest > highest - r.value);
  return number_verdict(r, low_is_worse ? lowest : highest, "shelves are high", " mm", 10);
}

Verdict check_aisle_width(const Facts& facts, const plan::Requirement& r) {
  int narrowest = 0;
  for (const layout::Aisle& aisle : facts.scene.layout.aisles) {
    if (aisle.kind != layout::AisleKind::secondary) continue;
    if (narrowest == 0 || aisle.width_mm < narrowest) narrowest = aisle.width_mm;
  }
  plan::Requirement at_least = r;
  if (r.comparison == plan::Comparison::equal) at_least.comparison = plan::Comparison::at_least;
  constexpr double too_wide = 1.5;  // of what was asked for: another kind of aisle
  if (r.comparison == plan::Comparison::equal && narrowest > too_wide * r.value)
    return {false,
            fmt::format(
                "narrowest aisle between shelves {} mm; asked for {:g} mm", narrowest, r.value)};
  return number_verdict(at_least, narrowest, "narrowest aisle between shelves", " mm", 10);
}

// On the fixtures that the wish is about.
StockCount stock_meant(const Facts& facts, const plan::Requirement& r) {
  std::vector<bool> meant;
  for (const layout::Fixture& fixture : facts.scene.layout.fixtures)
    meant.push_back(holds_for(facts, r, r.object, fixture));
  return stock_on(facts.scene, meant);
}

double share_of(double part, double whole) {
  return whole > 0 ? part / whole : 0;
}

// Disorder shows as items in the wrong place: some when it was asked for, no more than the share
// that was allowed.
Verdict check_order(const plan::Requirement& r, const StockCount& count) {
  const bool wanted = r.comparison == plan::Comparison::at_least ||
                      (r.comparison == plan::Comparison::equal && r.value > 0);
  const double most = r.value * static_cast<double>(count.items);
  return {wanted ? count.misplaced > 0 : static_cast<double>(count.misplaced) <= most,
          fmt::format("{} items stand in the wrong place", count.misplaced)};
}

Verdict check_gaps(const plan::Requirement& r, const StockCount& count) {
  const double share =
      share_of(static_cast<double>(count.empty_blocks), static_cast<double>(count.blocks));
  const double tolerance = 0.01 + r.value / 4;  // which blocks are sold out is drawn by chance
  return {compares(r, share, tolerance),
          fmt::format("{:.0f} % of the facing blocks are sold out", 100 * share)};
}

Verdict check_stock(const Facts& facts, const plan::Requirement& r) {
  const StockCount count = stock_meant(facts, r);
  if (count.blocks == 0) return {false, "no goods stand there"};
  if (r.subject == "misplaced" || r.subject == "jitter") return check_order(r, count);
  if (r.subject == "out_of_stock") return check_gaps(r, count);
  const double fill = share_of(count.stocked_m, count.front_m);
  constexpr double tolerance = 0.12;  // packs do not divide a shelf evenly
  return {compares(r, fill, tolerance),
          fmt::format("{:.0f} % of the shelf front is stocked", 100 * fill)};
}

Verdict check_light(const Facts& facts, const plan::Requirement& r) {
  const plan::Look& look = facts.scene.layout.look;
  const double measured =
      r.subject == "lux" || r.subject == "light_lux" ? look.light_lux : look.light_kelvin;
  return {std::abs(measured - r.value) <= 0.15 * r.value,
          fmt::format("light: {} K, {} lx", look.light_kelvin, look.light_lux)};
}

Verdict verdict_of(const Facts& facts, const plan::Requirement& r) {
  switch (r.kind) {
    case plan::RequirementKind::size:
      return check_size(facts, r);
    case plan::RequirementKind::area:
      return check_area(facts, r);
    case plan::RequirementKind::zone_present:
      return check_zone_present(facts, r);
    case plan::RequirementKind::zone_absent:
      return check_zone_absent(facts, r);
    case plan::RequirementKind::zone_count:
      return number_verdict(
          r, static_cast<double>(zones_there(facts, r.subject)), r.subject + " zones:", "");
    case plan::RequirementKind::fixture_count:
      return check_fixture_count(facts, r);
    case plan::RequirementKind::run_count:
      return check_run_count(facts, r);
    case plan::RequirementKind::aisle_count:
      return check_aisle_count(facts, r);
    case plan::RequirementKind::levels:
      return check_levels(facts, r);
    case plan::RequirementKind::relation:
      return check_relation_holds(facts, r);
    case plan::RequirementKind::style:
      return check_style(facts, r);
    case plan::RequirementKind::profile:
      return check_profile(facts, r);
    case plan::RequirementKind::material:
      return check_material(facts, r);
    case plan::RequirementKind::color:
      return check_color(facts, r);
    case plan::RequirementKind::product_present:
      return check_product(facts, r, true);
    case plan::RequirementKind::product_absent:
      return check_product(facts, r, false);
    case plan::RequirementKind::opening:
      return check_opening(facts, r);
    case plan::RequirementKind::endcaps:
      return check_endcaps(facts, r);
    case plan::RequirementKind::height:
      return check_height(facts, r);
    case plan::RequirementKind::aisle_width:
      return check_aisle_width(facts, r);
    case plan::RequirementKind::stock:
      return check_stock(facts, r);
    case plan::RequirementKind::light:
      return check_light(facts, r);
    case plan::RequirementKind::shelf_pitch:
      return check_shelf_pitch(facts, r);
  }
  return {false, "unknown kind of requirement"};
}

}  // namespace

std::vector<RequirementResult> check_requirements(
    const scene::Scene& scene,
    const catalog::Catalog& catalog,
    const std::vector<plan::Requirement>& requirements) {
  const Facts facts = facts_of(scene, catalog);
  std::vector<RequirementResult> results;
  for (const plan::Requirement& r : requirements) {
    Verdict verdict = verdict_of(facts, r);
    results.push_back({r.text, r.span, verdict.met, std::move(verdict.why)});
  }
  return results;
}

}  // namespace marketgen::audit
