#include "audit/requirements.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "audit/fixture_requirements.h"
#include "audit/metrics.h"
#include "audit/requirement_facts.h"
#include "audit/traffic.h"
#include "layout/accessories.h"
#include "layout/relations.h"
#include "scene/assortment.h"

namespace marketgen::audit {
namespace {

// A zone is there when it covers floor and what its type needs stands in it: shelving with goods on
// it, or tills and equipment. What stands at the entrance happens to lie in some zone.
bool zone_is_there(const Facts& facts, const layout::LayoutZone& zone) {
  const catalog::ZoneTypeRow* type = facts.catalog.zone_type(zone.type);
  if (type == nullptr || type->fixture.empty()) return zone.area_m2 > 0;
  const catalog::FixtureKind* usual = facts.catalog.fixture_kind(type->fixture);
  const catalog::FixtureRole role = usual != nullptr ? usual->role : catalog::FixtureRole::shelving;
  const auto& fixtures = facts.scene.layout.fixtures;
  for (std::size_t i = 0; i < fixtures.size(); ++i) {
    if (fixtures[i].zone != zone.id || layout::is_accessory(fixtures[i])) continue;
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

Verdict check_aisle_count(const Facts& facts, const plan::Requirement& r) {
  return number_verdict(r, shopping_aisles(facts.scene), "aisles between shelves:", "");
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

Verdict check_light(const Facts& facts, const plan::Requirement& r) {
  const plan::Look& look = facts.scene.layout.look;
  const double measured =
      r.subject == "lux" || r.subject == "light_lux" ? look.light_lux : look.light_kelvin;
  return {std::abs(measured - r.value) <= 0.15 * r.value,
          fmt::format("light: {} K, {} lx", look.light_kelvin, look.light_lux)};
}

Verdict check_time(const Facts& facts, const plan::Requirement& r) {
  const std::optional<std::string>& seen = facts.scene.layout.time;
  if (!seen) return {false, "the shelves are seen as staff filled them"};
  return {*seen == r.object, "the shelves are seen at " + *seen};
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
    case plan::RequirementKind::time:
      return check_time(facts, r);
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
