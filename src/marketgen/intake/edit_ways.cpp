#include "intake/edit_ways.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "plan/bsp.h"
#include "plan/floor_places.h"
#include "plan/plan_edit.h"

namespace marketgen::intake {
namespace {

constexpr std::size_t max_ways = 16;
constexpr int levels_up = 4;   // cuts above a zone that may move
constexpr int thin_mm = 2500;  // a zone narrower than that holds a wall run at most
constexpr double min_ratio = 0.08, max_ratio = 0.92;  // market-plan/1
constexpr double min_new_m2 = 6;                      // of a zone that is added
constexpr double largest_donor_share = 0.5;
constexpr double area_tolerance = 0.1;  // of the area that was asked for

// A way with what it costs the rest of the store.
struct WeighedWay {
  Way way;
  double cost = 0;
};

// Floor that other zones lose or that becomes too thin, m2. The zone `meant` may change.
double disturbance(const plan::Plan& before, const plan::Plan& after, std::string_view meant) {
  const std::vector<RectMm> old = plan::zone_rectangles(before);
  const std::vector<RectMm> now = plan::zone_rectangles(after);
  double cost = 0;
  for (std::size_t i = 0; i < after.zones.size(); ++i) {
    const bool thin = std::min(now[i].width(), now[i].depth()) < thin_mm;
    const auto was = plan::zone_index(before, after.zones[i].id);
    const bool was_thin = was && std::min(old[*was].width(), old[*was].depth()) < thin_mm;
    if (thin && !was_thin) cost += now[i].area_m2() + 10;
    if (!was) continue;
    const RectMm common{std::max(old[*was].x0, now[i].x0),
                        std::max(old[*was].y0, now[i].y0),
                        std::min(old[*was].x1, now[i].x1),
                        std::min(old[*was].y1, now[i].y1)};
    const double lost = std::abs(old[*was].area_m2() - now[i].area_m2());
    if (after.zones[i].id == meant)
      cost += lost;
    else if (old[*was] != now[i])
      cost += 5 + lost + (old[*was].area_m2() - common.area_m2());
  }
  return cost;
}

std::optional<plan::Plan> outcome(const StandingStore& store, const Way& way) {
  plan::Plan plan = store.plan;
  for (const plan::Patch& patch : way) {
    Result<plan::Patched> next = plan::patched(plan, patch, store.catalog, "way");
    if (!next.ok()) return std::nullopt;
    plan = std::move(next->plan);
  }
  if (!plan::validate_plan(plan, "way", store.catalog).ok()) return std::nullopt;
  return plan;
}

std::vector<Way> best_of(std::vector<WeighedWay> candidates) {
  std::ranges::stable_sort(candidates, {}, &WeighedWay::cost);
  if (candidates.size() > max_ways) candidates.resize(max_ways);
  std::vector<Way> ways;
  for (WeighedWay& candidate : candidates)
    ways.push_back(std::move(candidate.way));
  return ways;
}

bool relation_holds(const plan::Plan& plan, const plan::RelationTerms& terms) {
  plan::NamedFloor floor{plan::shell_rect(plan.shell), plan.shell.openings, {}};
  const std::vector<RectMm> rects = plan::zone_rectangles(plan);
  for (std::size_t i = 0; i < rects.size(); ++i)
    floor.zones.push_back({plan.zones[i].id, plan.zones[i].type, rects[i]});
  const auto measure = plan::measure_relation(floor, terms);
  return measure && measure->holds();
}

// Every place that one patch can give the zone.
std::vector<Way> places_for(const plan::Plan& plan, const std::string& zone) {
  std::vector<Way> ways;
  for (const plan::Zone& other : plan.zones) {
    if (other.id == zone) continue;
    plan::Patch patch;
    patch.swap_leaves = {zone, other.id};
    ways.push_back({patch});
  }
  for (const plan::Node& node : plan.nodes) {
    if (node.zone == zone) continue;
    for (const plan::Wall side :
         {plan::Wall::north, plan::Wall::south, plan::Wall::east, plan::Wall::west}) {
      plan::Patch patch;
      patch.move_leaf.emplace().zone = zone;
      patch.move_leaf->beside = node.zone.value_or(node.id);
      patch.move_leaf->side = side;
      ways.push_back({patch});
    }
  }
  return ways;
}

// Cuts above the zone, each moved so that the zone gets its area.
std::vector<WeighedWay> cuts_for_area(const StandingStore& store,
                                      const std::string& zone,
                                      double area_m2,
                                      const Way& first) {
  std::vector<WeighedWay> candidates;
  const plan::Plan& plan = store.plan;
  const auto leaf = plan::leaf_of(plan, zone);
  const auto index = plan::zone_index(plan, zone);
  if (!leaf || !index) return candidates;
  const double now_m2 = std::max(plan::zone_rectangles(plan)[*index].area_m2(), 0.01);
  std::size_t at = *leaf;
  for (int up = 0; up < levels_up; ++up) {
    const auto parent = plan::parent_of(plan, at);
    if (!parent) break;
    const plan::Node& cut = plan.nodes[*parent];
    const bool is_first = cut.children.front() == plan.nodes[at].id;
    const double old = cut.ratio.value_or(plan::default_split_ratio);
    const double share = (is_first ? old : 1 - old) * area_m2 / now_m2;
    const double ratio = std::clamp(is_first ? share : 1 - share, min_ratio, max_ratio);
    plan::Patch patch;
    patch.set_ratio = {cut.id, std::round(1e4 * ratio) * 1e-4};
    WeighedWay candidate{first, 0};
    candidate.way.push_back(patch);
    at = *parent;
    const auto plan_then = outcome(store, candidate.way);
    if (!plan_then) continue;
    const double then_m2 =
        plan::zone_rectangles(*plan_then)[*plan::zone_index(*plan_then, zone)].area_m2();
    const double missed = std::abs(then_m2 - area_m2);
    if (missed >= std::abs(now_m2 - area_m2)) continue;
    candidate.cost = disturbance(plan, *plan_then, zone) +
                     (missed > area_tolerance * area_m2 ? 10 * missed + 100 : 0);
    candidates.push_back(std::move(candidate));
  }
  return candidates;
}

plan::Zone new_zone(const StandingStore& store,
                    const catalog::ZoneTypeRow& type,
                    std::optional<int> count) {
  plan::Zone zone = plan::usual_zone(type, store.catalog);
  zone.id = plan::unused_id(store.plan, type.type);
  zone.fixture.count = count;
  if (const catalog::ProfileRow* profile = store.catalog.profile(store.plan.profile))
    zone.stock.fill = profile->stock_fill;
  return zone;
}

bool has_tills(const StandingStore& store, const plan::Zone& zone) {
  const catalog::FixtureKind* kind = store.catalog.fixture_kind(zone.fixture.kind);
  return kind != nullptr && kind->role == catalog::FixtureRole::checkout;
}

}  // namespace

std::string name_of_zones(const plan::Plan& plan) {
  std::vector<std::string_view> names;
  for (const plan::Zone& zone : plan.zones)
    names.push_back(zone.id);
  return fmt::format("{}", fmt::join(names, ", "));
}

Result<std::vector<std::string>> zones_called(const StandingStore& store, std::string_view type) {
  const std::vector<RectMm> rects = plan::zone_rectangles(store.plan);
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < rects.size(); ++i) {
    if (store.plan.zones[i].type == type) found.push_back(i);
  }
  std::ranges::stable_sort(
      found, std::greater<>(), [&](std::size_t i) { return rects[i].area_mm2(); });
  std::vector<std::string> ids;
  for (const std::size_t i : found)
    ids.push_back(store.plan.zones[i].id);
  if (!ids.empty()) return ids;
  return Error{
      "plan.unknown_reference",
      "--say",
      fmt::format("the store has no zone \"{}\"; it has {}; name one of these, or add it first",
                  type,
                  name_of_zones(store.plan))};
}

Result<std::vector<Way>> ways_to_move(const StandingStore& store,
                                      const plan::RelationTerms& terms) {
  MARKETGEN_TRY(const std::vector<std::string> zones, zones_called(store, terms.a));
  if (relation_holds(store.plan, terms)) return std::vector<Way>{Way{}};
  std::vector<WeighedWay> candidates;
  for (const std::string& zone : zones) {
    for (const Way& way : places_for(store.plan, zone)) {
      const auto plan_then = outcome(store, way);
      if (!plan_then || !relation_holds(*plan_then, terms)) continue;
      candidates.push_back({way, disturbance(store.plan, *plan_then, zone)});
    }
  }
  if (!candidates.empty()) return best_of(std::move(candidates));
  return Error{"plan.bad_value",
               "--say",
               fmt::format("no other place in this store puts {} {} {}; say where else, or write "
                           "patches for --patch",
                           terms.a,
                           name_of(terms.kind),
                           terms.b)};
}

Result<std::vector<Way>> ways_to_resize(const StandingStore& store,
                                        std::string_view type,
                                        double area_m2) {
  MARKETGEN_TRY(const std::vector<std::string> zones, zones_called(store, type));
  std::vector<WeighedWay> candidates = cuts_for_area(store, zones.front(), area_m2, {});
  if (!candidates.empty()) return best_of(std::move(candidates));
  return Error{
      "plan.bad_value",
      "--say",
      fmt::format("no cut of the floor gives zone {} about {:.1f} m2: its neighbours would "
                  "be too narrow; ask for less of a change, or take one of them out first",
                  zones.front(),
                  area_m2)};
}

std::vector<Way> with_more_room(const StandingStore& store,
                                const std::string& zone,
                                const Way& first) {
  std::vector<Way> ways{first};
  const auto index = plan::zone_index(store.plan, zone);
  if (!index) return ways;
  const double area_m2 = plan::zone_rectangles(store.plan)[*index].area_m2();
  for (const double factor : {1.25, 1.5, 2.0}) {
    for (Way& way : best_of(cuts_for_area(store, zone, factor * area_m2, first)))
      ways.push_back(std::move(way));
  }
  if (ways.size() > max_ways) ways.resize(max_ways);
  return ways;
}

Result<std::vector<Way>> ways_to_add(const StandingStore& store,
                                     std::string_view type,
                                     std::optional<int> count) {
  const catalog::ZoneTypeRow* row = store.catalog.zone_type(type);
  if (row == nullptr)
    return Error{"plan.unknown_reference", "--say", fmt::format("there are no {} zones", type)};
  const plan::Zone zone = new_zone(store, *row, count);
  const catalog::ProfileRow* profile = store.catalog.profile(store.plan.profile);
  const int gap_mm = (profile != nullptr ? *profile : catalog::ProfileRow{}).secondary_aisle_mm;
  const double floor_m2 = plan::shell_rect(store.plan.shell).area_m2();
  const double wanted_m2 = std::max(min_new_m2, row->share * floor_m2);
  const std::vector<RectMm> rects = plan::zone_rectangles(store.plan);
  std::vector<WeighedWay> candidates;
  for (std::size_t i = 0; i < rects.size(); ++i) {
    const plan::Zone& donor = store.plan.zones[i];
    const bool same_trade = has_tills(store, donor) == has_tills(store, zone);
    const double share =
        std::clamp(wanted_m2 / std::max(rects[i].area_m2(), 0.01), min_ratio, largest_donor_share);
    for (const plan::Wall side :
         {plan::Wall::north, plan::Wall::south, plan::Wall::east, plan::Wall::west}) {
      plan::Patch patch;
      patch.add_zone = plan::AddZone{zone, donor.id, side, std::round(1e4 * share) * 1e-4, gap_mm};
      const auto plan_then = outcome(store, {patch});
      if (!plan_then) continue;
      const double got_m2 = plan::zone_rectangles(*plan_then).back().area_m2();
      const double missed = std::max(0.0, wanted_m2 - got_m2);
      candidates.push_back({{patch},
                            disturbance(store.plan, *plan_then, zone.id) + 3 * missed + 50 * share +
                                (same_trade ? 0 : 100)});
    }
  }
  if (!candidates.empty()) return best_of(std::move(candidates));
  return Error{"plan.bad_value",
               "--say",
               fmt::format("no zone of this store has floor left for {}; drop one first", type)};
}

}  // namespace marketgen::intake
