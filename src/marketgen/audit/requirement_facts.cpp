#include "audit/requirement_facts.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace marketgen::audit {

Facts facts_of(const scene::Scene& scene, const catalog::Catalog& catalog) {
  Facts facts{scene, catalog, std::vector<std::uint64_t>(scene.fixtures.size(), 0)};
  for (const scene::Facing& f : scene.facings)
    facts.items_on_fixture[scene.shelves[f.shelf].fixture] += f.product_count;
  return facts;
}

bool compares(const plan::Requirement& r, double measured, double tolerance) {
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
                       double tolerance) {
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

bool holds_for(const Facts& facts,
               const plan::Requirement& r,
               const std::string& zone,
               const layout::Fixture& fixture) {
  return in_zone(facts, fixture, zone) &&
         std::ranges::none_of(
             r.except, [&](const std::string& name) { return in_zone(facts, fixture, name); });
}

bool is_shelving(const Facts& facts, const layout::Fixture& fixture) {
  const catalog::FixtureKind* kind = facts.catalog.fixture_kind(fixture.kind);
  constexpr int several = 4;
  return kind != nullptr && kind->role == catalog::FixtureRole::shelving &&
         kind->temperature == catalog::Storage::ambient && kind->level_range[1] >= several;
}

}  // namespace marketgen::audit
