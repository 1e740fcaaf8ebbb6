#include "layout/makes.h"

#include <algorithm>
#include <array>
#include <optional>

#include "layout/layout.h"
#include "layout/lists.h"

namespace marketgen::layout {
namespace {

bool is_sold_to(const MakeRow& row, const plan::Plan& plan) {
  return row.profiles.empty() || lists(row.profiles, plan.profile);
}

// Somebody said this of the zone's fixtures: not the planner's own choice, nor a repair.
bool is_said(const plan::Plan& plan, std::size_t zone, std::string_view field) {
  const std::string path = "/zones/" + std::to_string(zone) + "/fixture" + std::string(field);
  return std::ranges::any_of(plan.provenance, [&](const plan::Provenance& said) {
    return said.source != plan::Source::repair && said.source != plan::Source::unset &&
           said.path == path;
  });
}

bool holds(const IntRange& range, const std::optional<int>& value) {
  return !value || (*value >= range[0] && *value <= range[1]);
}

}  // namespace

const std::vector<MakeRow>& make_rows() {
#define LIST(...) \
  { __VA_ARGS__ }
#define MAKE(of, kind, profiles, zones, source) {of, kind, profiles, zones, source},
  static const std::vector<MakeRow> rows{
#include "layout/makes.inc"
  };
#undef MAKE
#undef LIST
  return rows;
}

Makes::Makes(const plan::Plan& plan, const catalog::Catalog& catalog, Seed seed) {
  std::map<std::pair<std::string, std::string>, std::vector<const catalog::FixtureKind*>> offered;
  for (const MakeRow& row : make_rows()) {
    const catalog::FixtureKind* kind = catalog.fixture_kind(row.kind);
    if (kind == nullptr || !is_sold_to(row, plan)) continue;
    if (row.zones.empty()) offered[{std::string(row.of), ""}].push_back(kind);
    for (const std::string_view zone : row.zones)
      offered[{std::string(row.of), std::string(zone)}].push_back(kind);
  }
  for (const auto& [role, kinds] : offered) {
    const int last = static_cast<int>(kinds.size()) - 1;
    const int drawn = seed.child(role.first).child(role.second).stream().integer(0, last);
    drawn_[role] = kinds[static_cast<std::size_t>(drawn)];
  }
}

const catalog::FixtureKind& Makes::of(const catalog::FixtureKind& kind,
                                      std::string_view zone_type) const {
  auto found = drawn_.find({kind.kind, std::string(zone_type)});
  if (found == drawn_.end()) found = drawn_.find({kind.kind, ""});
  return found == drawn_.end() ? kind : *found->second;
}

bool may_have(const plan::Plan& plan,
              std::size_t zone,
              const catalog::FixtureKind& kind,
              const catalog::FixtureKind& make) {
  const plan::FixtureSpec& wish = plan.zones[zone].fixture;
  const bool named = is_said(plan, zone, "") || is_said(plan, zone, "/kind");
  if (named && make.generator != kind.generator) return false;
  const auto bears = [&](std::string_view field, const std::optional<int>& value, IntRange range) {
    return !is_said(plan, zone, field) || holds(range, value);
  };
  if (wish.double_sided.value_or(false) && kind.double_sided && !make.double_sided) return false;
  const bool counted = wish.count || wish.runs;
  const bool larger = make.module_widths_mm.front() > kind.module_widths_mm.front() ||
                      make.depth_mm > kind.depth_mm || make.double_sided != kind.double_sided;
  if (counted && larger && kind.role == catalog::FixtureRole::shelving) return false;
  return !wish.module_mm && bears("/depth_mm", wish.depth_mm, make.depth_range_mm) &&
         bears("/height_mm", wish.height_mm, make.height_range_mm) &&
         bears("/levels", wish.levels, make.level_range);
}

bool counts_as(const Layout& layout, const Fixture& fixture, std::string_view kind) {
  if (fixture.kind == kind) return true;
  return layout.outfit == plan::Outfit::full &&
         std::ranges::any_of(make_rows(), [&](const MakeRow& row) {
           return row.of == kind && row.kind == fixture.kind;
         });
}

}  // namespace marketgen::layout
