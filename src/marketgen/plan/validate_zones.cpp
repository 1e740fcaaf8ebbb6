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

Result<void> check_in_range(const PlanCheck& check,
                            std::size_t i,
                            std::string_view field,
                            std::optional<int> value,
                            IntRange range) {
  if (!value || (*value >= range[0] && *value <= range[1])) return {};
  const std::string& kind = check.plan.zones[i].fixture.kind;
  return value_fault(check,
                     i,
                     field,
                     "a " + kind + " is made from " + with_thousands(range[0]) + " to " +
                         with_thousands(range[1]) + ", not " + with_thousands(*value));
}

// The highest board, with its rail, is below the top of the fixture.
Result<void> check_levels_fit(const PlanCheck& check,
                              std::size_t i,
                              const catalog::FixtureKind& kind) {
  const FixtureSpec& fixture = check.plan.zones[i].fixture;
  if (!fixture.spacing_mm) return {};
  const int levels = fixture.levels.value_or(kind.levels);
  const int height = fixture.height_mm.value_or(kind.height_mm);
  const int needed = kind.base_mm + (levels - 1) * *fixture.spacing_mm + level_board_mm;
  if (levels < 2 || needed <= height) return {};
  return value_fault(check,
                     i,
                     "fixture/spacing_mm",
                     std::to_string(levels) + " levels " + with_thousands(*fixture.spacing_mm) +
                         " mm apart need " + with_thousands(needed) + " mm, and the fixture is " +
                         with_thousands(height) + " mm high");
}

Result<void> check_fixture(const PlanCheck& check, std::size_t i) {
  const FixtureSpec& fixture = check.plan.zones[i].fixture;
  const catalog::FixtureKind* kind = check.catalog.fixture_kind(fixture.kind);
  if (kind == nullptr) return {};  // a zone without fixtures
  MARKETGEN_CHECK(
      check_in_range(check, i, "fixture/depth_mm", fixture.depth_mm, kind->depth_range_mm));
  MARKETGEN_CHECK(
      check_in_range(check, i, "fixture/height_mm", fixture.height_mm, kind->height_range_mm));
  MARKETGEN_CHECK(check_in_range(check, i, "fixture/levels", fixture.levels, kind->level_range));
  const int ceiling = check.plan.shell.ceiling_mm;
  if (fixture.height_mm.value_or(kind->height_mm) > ceiling) {
    return value_fault(
        check,
        i,
        "fixture/height_mm",
        "the fixture is higher than the ceiling (" + with_thousands(ceiling) + " mm)");
  }
  return check_levels_fit(check, i, *kind);
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
    MARKETGEN_CHECK(check_fixture(check, i));
    MARKETGEN_CHECK(check_stock(check, i));
  }
  return {};
}

}  // namespace marketgen::plan
