// Rules about zones: that they hold something, and who may be whose neighbour.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "layout/accessories.h"
#include "layout/makes.h"
#include "layout/module_spec.h"
#include "layout/neighbours.h"
#include "layout/relations.h"
#include "layout/rule_facts.h"
#include "layout/zone_build.h"

namespace marketgen::layout {
namespace {

constexpr int cold_group_mm = 4000;  // cold zones nearer than this share their piping
constexpr int max_cold_groups = 2;
constexpr double produce_share = 0.5;  // of the shop's diagonal

PointMm middle(const LayoutZone& zone) {
  return bounds_of(zone.polygon_mm).center();
}

bool zone_is_cold(const RuleFacts& facts, const LayoutZone& zone) {
  const plan::Zone* planned = plan::find_zone(facts.design.plan, zone.id);
  if (planned != nullptr) return is_cold(*planned, facts.catalog());
  const catalog::ZoneTypeRow* type = facts.catalog().zone_type(zone.type);
  return type != nullptr && type->temperature != catalog::Storage::ambient;
}

std::vector<std::size_t> shelving_of(const RuleFacts& facts, const std::string& zone) {
  std::vector<std::size_t> fixtures;
  for (std::size_t i = 0; i < facts.footprints.size(); ++i) {
    if (facts.is_shelving(i) && facts.layout.fixtures[i].zone == zone) fixtures.push_back(i);
  }
  return fixtures;
}

// The nearest two fixtures of two zones; nothing when one of them has none.
struct NearestPair {
  std::size_t a = 0, b = 0;
  int gap = 0;
};
std::optional<NearestPair> nearest_fixtures(const RuleFacts& facts,
                                            const std::string& a,
                                            const std::string& b) {
  std::optional<NearestPair> best;
  const std::vector<std::size_t> of_b = shelving_of(facts, b);
  for (const std::size_t i : shelving_of(facts, a)) {
    for (const std::size_t k : of_b) {
      const int gap = gap_mm(facts.footprints[i], facts.footprints[k]);
      if (!best || gap < best->gap) best = NearestPair{i, k, gap};
    }
  }
  return best;
}

// Zones that must be kept apart but whose fixtures stand right beside each other.
template <class Apart>
Findings too_close(const RuleFacts& facts, Apart must_be_apart, const std::string& why) {
  Findings found;
  for (const LayoutZone& a : facts.layout.zones) {
    for (const LayoutZone& b : facts.layout.zones) {
      if (a.id == b.id || !must_be_apart(a, b)) continue;
      const auto pair = nearest_fixtures(facts, a.id, b.id);
      if (!pair || pair->gap >= apart_mm) continue;
      found.push_back({a.id,
                       static_cast<double>(std::max(0, pair->gap)),
                       apart_mm,
                       "zone " + a.id + " stands right beside " + b.id + ": " + why,
                       facts.footprints[pair->a].center()});
    }
  }
  return found;
}

int cold_groups(const std::vector<RectMm>& cold) {
  std::vector<std::size_t> group(cold.size());
  for (std::size_t i = 0; i < cold.size(); ++i)
    group[i] = i;
  for (std::size_t i = 0; i < cold.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (gap_mm(cold[i], cold[k]) > cold_group_mm || group[i] == group[k]) continue;
      const std::size_t from = group[i], to = group[k];
      std::ranges::replace(group, from, to);
    }
  }
  return static_cast<int>(std::set(group.begin(), group.end()).size());
}

Findings relations_of(const RuleFacts& facts, plan::Strength strength) {
  const plan::NamedFloor floor = named_floor(facts.layout);
  Findings found;
  for (const plan::Relation& relation : facts.design.plan.relations) {
    if (relation.strength != strength) continue;
    const plan::RelationTerms terms = plan::terms_of(relation);
    const auto measure = plan::measure_relation(floor, terms);
    if (!measure || measure->slack_m() >= layout_margin_m) continue;
    found.push_back({relation.a,
                     measure->measured_m,
                     measure->limit_m,
                     plan::words_of(floor, terms, measure),
                     measure->at_mm});
  }
  return found;
}

// What is counted, and the name by which a shortage of it is reported.
struct Counted {
  std::string where;
  const catalog::FixtureKind* kind;
};

Finding shortage(const Counted& counted, int standing, int wanted, const std::string& what) {
  return {counted.where,
          static_cast<double>(standing),
          static_cast<double>(wanted),
          counted.where + " has room for " + std::to_string(standing) + " of the " +
              std::to_string(wanted) + " " + what + " asked for",
          std::nullopt};
}

// Fewer of a zone's fixtures, or fewer lines of them, than the plan asks for.
void add_shortage(Findings& found,
                  const RuleFacts& facts,
                  const LayoutZone& zone,
                  const plan::FixtureSpec& spec,
                  const Counted& counted) {
  int standing = 0;
  std::set<std::string> runs;
  for (const Fixture& fixture : facts.layout.fixtures) {
    if (fixture.zone != zone.id || !counts_as(facts.layout, fixture, counted.kind->kind)) continue;
    ++standing;
    runs.insert(fixture.run);
  }
  const int lines = lines_wanted(spec, *counted.kind).value_or(0);
  const auto standing_lines = static_cast<int>(runs.size());
  std::optional<Finding> lacking;
  if (standing < spec.count.value_or(0))
    lacking = shortage(counted, standing, *spec.count, counted.kind->kind);
  else if (standing_lines < lines)
    lacking = shortage({counted.where + "/runs", counted.kind}, standing_lines, lines, "runs");
  if (!lacking) return;
  lacking->at_mm = middle(zone);
  found.push_back(std::move(*lacking));
}

void add_missing_equipment(Findings& found, const RuleFacts& facts) {
  if (!facts.design.plan.equipment) return;
  std::map<std::string, int> wanted;
  for (const plan::EquipmentSpec& spec : *facts.design.plan.equipment)
    wanted[spec.kind] += spec.count;
  for (const auto& [kind, count] : wanted) {
    const auto standing =
        static_cast<int>(std::ranges::count(facts.layout.fixtures, kind, &Fixture::kind));
    if (standing >= count) continue;
    found.push_back({kind,
                     static_cast<double>(standing),
                     static_cast<double>(count),
                     "the doors have room for " + std::to_string(standing) + " of the " +
                         std::to_string(count) + " " + kind + " asked for",
                     std::nullopt});
  }
}

}  // namespace

Findings zone_too_small(const RuleFacts& facts) {
  Findings found;
  for (const LayoutZone& zone : facts.layout.zones) {
    const plan::Zone* planned = plan::find_zone(facts.design.plan, zone.id);
    if (planned == nullptr || !planned->area_m2.min || zone.area_m2 >= *planned->area_m2.min)
      continue;
    found.push_back({zone.id,
                     zone.area_m2,
                     *planned->area_m2.min,
                     "zone " + zone.id + " has less floor than it needs",
                     middle(zone)});
  }
  return found;
}

Findings zone_empty(const RuleFacts& facts) {
  Findings found;
  for (const LayoutZone& zone : facts.layout.zones) {
    const plan::Zone* planned = plan::find_zone(facts.design.plan, zone.id);
    if (planned == nullptr || kinds_of(*planned, facts.catalog()).main == nullptr) continue;
    const bool furnished = std::ranges::any_of(facts.layout.fixtures, [&](const Fixture& fixture) {
      return fixture.zone == zone.id && !is_accessory(fixture);
    });
    if (furnished) continue;
    found.push_back({zone.id,
                     0,
                     1,
                     "zone " + zone.id + " holds no fixture: its floor is too small or shut in",
                     middle(zone)});
  }
  return found;
}

Findings count_short(const RuleFacts& facts) {
  Findings found;
  for (const LayoutZone& zone : facts.layout.zones) {
    const plan::Zone* planned = plan::find_zone(facts.design.plan, zone.id);
    if (planned == nullptr) continue;
    const catalog::FixtureKind* main = kinds_of(*planned, facts.catalog()).main;
    if (main != nullptr) add_shortage(found, facts, zone, planned->fixture, {zone.id, main});
    if (!planned->also) continue;
    for (const plan::FixtureSpec& also : *planned->also) {
      const catalog::FixtureKind* kind = facts.catalog().fixture_kind(also.kind);
      if (kind != nullptr)
        add_shortage(found, facts, zone, also, {zone.id + "/" + also.kind, kind});
    }
  }
  add_missing_equipment(found, facts);
  return found;
}

Findings cold_scattered(const RuleFacts& facts) {
  std::vector<RectMm> cold;
  for (const LayoutZone& zone : facts.layout.zones) {
    if (zone_is_cold(facts, zone)) cold.push_back(bounds_of(zone.polygon_mm));
  }
  const int groups = cold_groups(cold);
  if (groups <= max_cold_groups) return {};
  return {{"refrigeration",
           static_cast<double>(groups),
           max_cold_groups,
           "refrigerated zones stand in " + std::to_string(groups) + " places",
           cold.front().center()}};
}

Findings raw_next_to_ready(const RuleFacts& facts) {
  return too_close(
      facts,
      [](const LayoutZone& a, const LayoutZone& b) { return is_raw_beside_ready(a.type, b.type); },
      "raw meat is kept apart from food that is eaten as it is");
}

Findings chemical_next_to_food(const RuleFacts& facts) {
  return too_close(
      facts,
      [&](const LayoutZone& a, const LayoutZone& b) {
        return is_chemical_beside_food(a.type, b.type, facts.catalog());
      },
      "chemicals are kept apart from food");
}

Findings produce_far(const RuleFacts& facts) {
  const Doorway* door = entrance_of(facts.design.floor, facts.shell());
  if (door == nullptr) return {};
  const double limit = produce_share * plan::diagonal_m(facts.design.floor.bounds);
  Findings found;
  for (const LayoutZone& zone : facts.layout.zones) {
    if (zone.type != "produce") continue;
    const double away = 1e-3 * distance_mm(bounds_of(zone.polygon_mm), point_rect(door->threshold));
    if (away <= limit) continue;
    found.push_back(
        {zone.id, away, limit, "zone " + zone.id + " is far from the entrance", middle(zone)});
  }
  return found;
}

Findings relation_broken(const RuleFacts& facts) {
  return relations_of(facts, plan::Strength::must);
}

Findings relation_missed(const RuleFacts& facts) {
  return relations_of(facts, plan::Strength::prefer);
}

Findings relation_not_judged(const RuleFacts& facts) {
  const plan::NamedFloor floor = named_floor(facts.layout);
  Findings found;
  for (const plan::Relation& relation : facts.design.plan.relations) {
    const plan::RelationTerms terms = plan::terms_of(relation);
    const auto measure = plan::measure_relation(floor, terms);
    if (measure) continue;
    found.push_back({relation.a, 0, 0, plan::words_of(floor, terms, measure), std::nullopt});
  }
  return found;
}

}  // namespace marketgen::layout
