#include <algorithm>
#include <array>

#include "base/text.h"
#include "plan/validation.h"

namespace marketgen::plan {
namespace {

constexpr std::array<std::string_view, 8> anchors = {
    "any", "north", "south", "east", "west", "center", "entrance", "checkout"};
constexpr int level_board_mm = 30;  // thickness of a shelf board with its price rail

Error value_fault(const PlanCheck& check,
                  std::size_t zone,
                  std::string_view field,
                  std::string message) {
  return {"plan.bad_value", check.at(element_pointer("zones", zone, field)), std::move(message)};
}

Result<void> check_anchor(const PlanCheck& check, std::size_t i) {
  const std::string& anchor = check.plan.zones[i].anchor;
  if (std::ranges::find(anchors, anchor) != anchors.end()) return {};
  return catalog::unknown_name("plan.unknown_reference",
                               check.at(element_pointer("zones", i, "anchor")),
                               "anchor",
                               anchor,
                               {anchors.begin(), anchors.end()});
}

Result<void> check_area(const PlanCheck& check, std::size_t i) {
  const AreaRange& area = check.plan.zones[i].area_m2;
  const double least = area.min.value_or(0);
  const double target = area.target.value_or(std::max(least, 0.0));
  const double most = area.max.value_or(std::max(target, least));
  if (least > most) return value_fault(check, i, "area_m2/min", "min is more than max");
  if (target < least) return value_fault(check, i, "area_m2/target", "target is less than min");
  if (target > most) return value_fault(check, i, "area_m2/target", "target is more than max");
  return {};
}

// One of a zone's fixture groups, and where it stands in the plan.
struct FixtureAt {
  const PlanCheck& check;
  const FixtureSpec& spec;
  std::string pointer;  // "/zones/2/fixture", "/zones/2/also/0"

  Error fault(std::string_view field, std::string message) const {
    return {"plan.bad_value", check.at(pointer + "/" + std::string(field)), std::move(message)};
  }
};

Result<void> check_in_range(const FixtureAt& fixture,
                            std::string_view field,
                            std::optional<int> value,
                            IntRange range) {
  if (!value || (*value >= range[0] && *value <= range[1])) return {};
  return fixture.fault(field,
                       "a " + fixture.spec.kind + " is made from " + with_thousands(range[0]) +
                           " to " + with_thousands(range[1]) + ", not " + with_thousands(*value));
}

// The highest board, with its rail, is below the top of the fixture.
Result<void> check_levels_fit(const FixtureAt& fixture, const catalog::FixtureKind& kind) {
  const FixtureSpec& spec = fixture.spec;
  if (!spec.spacing_mm) return {};
  const int levels = spec.levels.value_or(kind.levels);
  const int height = spec.height_mm.value_or(kind.height_mm);
  const int needed = kind.base_mm + (levels - 1) * *spec.spacing_mm + level_board_mm;
  if (levels < 2 || needed <= height) return {};
  return fixture.fault("spacing_mm",
                       std::to_string(levels) + " levels " + with_thousands(*spec.spacing_mm) +
                           " mm apart need " + with_thousands(needed) + " mm, and the fixture is " +
                           with_thousands(height) + " mm high");
}

Result<void> check_fixture(const FixtureAt& fixture) {
  const FixtureSpec& spec = fixture.spec;
  const catalog::FixtureKind* kind = fixture.check.catalog.fixture_kind(spec.kind);
  if (kind == nullptr) return {};  // a zone without fixtures
  MARKETGEN_CHECK(check_in_range(fixture, "depth_mm", spec.depth_mm, kind->depth_range_mm));
  MARKETGEN_CHECK(check_in_range(fixture, "height_mm", spec.height_mm, kind->height_range_mm));
  MARKETGEN_CHECK(check_in_range(fixture, "levels", spec.levels, kind->level_range));
  const int ceiling = fixture.check.plan.shell.ceiling_mm;
  if (spec.height_mm.value_or(kind->height_mm) > ceiling) {
    return fixture.fault(
        "height_mm", "the fixture is higher than the ceiling (" + with_thousands(ceiling) + " mm)");
  }
  if (spec.runs && spec.count.value_or(*spec.runs) < *spec.runs) {
    return fixture.fault("runs",
                         std::to_string(*spec.runs) +
                             " runs need as many fixtures at least; the "
                             "count is " +
                             std::to_string(*spec.count));
  }
  return check_levels_fit(fixture, *kind);
}

// What stands beside a zone's main fixtures: each of a kind of its own, so that there is one count
// of it, and so many of it.
Result<void> check_beside(const FixtureAt& fixture, const Zone& zone, std::size_t index) {
  const FixtureSpec& spec = fixture.spec;
  const auto& all = *zone.also;
  const bool repeated =
      spec.kind == zone.fixture.kind ||
      std::any_of(all.begin(),
                  all.begin() + static_cast<std::ptrdiff_t>(index),
                  [&](const FixtureSpec& other) { return other.kind == spec.kind; });
  if (repeated) {
    return fixture.fault(
        "kind",
        "zone " + zone.id + " has fixtures of kind \"" + spec.kind + "\" already; add the counts");
  }
  const catalog::FixtureKind* kind = fixture.check.catalog.fixture_kind(spec.kind);
  const bool lines_walls = kind != nullptr && kind->generator == "wall_unit";
  if (!spec.count && !spec.runs && !lines_walls) {
    return fixture.fault("count",
                         "say count or runs; only a zone's main fixtures and what lines its walls "
                         "fill what room there is");
  }
  if (kind == nullptr || kind->mount != catalog::FixtureMount::floor ||
      kind->role == catalog::FixtureRole::checkout) {
    return fixture.fault("kind",
                         "\"" + spec.kind +
                             "\" does not stand beside other fixtures; shelving and equipment on "
                             "the floor do, and tills are a zone of their own");
  }
  return {};
}

Result<void> check_fixtures(const PlanCheck& check, std::size_t i) {
  const Zone& zone = check.plan.zones[i];
  MARKETGEN_CHECK(check_fixture({check, zone.fixture, element_pointer("zones", i, "fixture")}));
  for (std::size_t k = 0; zone.also && k < zone.also->size(); ++k) {
    const FixtureAt fixture{
        check, (*zone.also)[k], element_pointer("zones", i, "also/" + std::to_string(k))};
    MARKETGEN_CHECK(check_beside(fixture, zone, k));
    MARKETGEN_CHECK(check_fixture(fixture));
  }
  return {};
}

Result<void> check_stock(const PlanCheck& check, std::size_t i) {
  const IntRange facings = check.plan.zones[i].stock.facings;
  if (facings[0] <= facings[1]) return {};
  return value_fault(
      check, i, "stock/facings", "the fewest facings are more than the most; write [fewest, most]");
}

}  // namespace

Result<void> check_zone_values(const PlanCheck& check) {
  for (std::size_t i = 0; i < check.plan.zones.size(); ++i) {
    MARKETGEN_CHECK(check_anchor(check, i));
    MARKETGEN_CHECK(check_area(check, i));
    MARKETGEN_CHECK(check_fixtures(check, i));
    MARKETGEN_CHECK(check_stock(check, i));
  }
  return {};
}

}  // namespace marketgen::plan
