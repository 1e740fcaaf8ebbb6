#include "intake/store_program.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "intake/candidate.h"
#include "intake/floor_size.h"
#include "intake/store_numbers.h"
#include "intake/store_size.h"
#include "intake/zone_sizes.h"
#include "layout/floor.h"

namespace marketgen::intake {

Stance stance_of(const catalog::ZoneTypeRow& type, const catalog::FixtureKind* kind) {
  if (kind == nullptr) return Stance::wall;
  if (kind->role != catalog::FixtureRole::shelving) return Stance::front;
  const bool counter = kind->generator == "serve_over";  // staff stand between it and a wall
  if (kind->against_wall || counter) return Stance::wall;
  return kind->double_sided || type.anchor == "center" ? Stance::central : Stance::hall;
}

namespace {

using Kind = plan::RequirementKind;

constexpr std::string_view usual_profile = "supermarket-eu";
constexpr std::string_view profile_without_tills = "checkout-free";  // when none was named
constexpr double zones_in_any_store = 5;
constexpr double further_zone_m2 = 36;  // of store for each zone more; smaller ones hold no run
constexpr std::size_t max_zones = 22;   // of max_bsp_leaves
constexpr double lanes_from_m2 = 70;    // smaller shops take money over a counter
constexpr double staffed_counter_from_m2 = 500;  // smaller shops sell meat and cheese packed
constexpr double checkout_zones_share = 0.09;    // tills take their own floor first

bool is_till(std::string_view type) {
  return type == "checkout" || type == "self_checkout";
}

// How many zones of each type the wishes name, in the order in which they name them.
struct NamedZones {
  std::vector<std::string> order;
  std::map<std::string, int> count;

  void add(const std::string& type, int number = 1) {
    if (type.empty()) return;
    const auto [entry, fresh] = count.try_emplace(type, number);
    if (fresh) order.push_back(type);
    entry->second = std::max(entry->second, number);
  }
};

bool names_zone_in_relation(const plan::Requirement& wish) {
  return wish.kind == Kind::relation && wish.relation != plan::RelationKind::far &&
         wish.relation != plan::RelationKind::not_adjacent;
}

NamedZones named_zones(const Understanding& found, const catalog::Catalog& catalog) {
  NamedZones named;
  const auto add_if_zone = [&](const std::string& name) {
    if (catalog.zone_type(name) != nullptr) named.add(name);
  };
  for (const plan::Requirement& wish : found.requirements) {
    if (wish.kind == Kind::zone_present) named.add(wish.subject);
    if (wish.kind == Kind::zone_count) named.add(wish.subject, static_cast<int>(wish.value));
    if (wish.kind == Kind::area || wish.kind == Kind::levels) add_if_zone(wish.subject);
    if (wish.kind == Kind::product_present) named.add(wish.object);
    const bool of_fixtures = wish.kind == Kind::fixture_count || wish.kind == Kind::run_count;
    const bool refused = found.find(Kind::zone_absent, wish.object) != nullptr;
    if (of_fixtures && !asks_for_none(wish) && !refused) add_if_zone(wish.object);
    if (!names_zone_in_relation(wish)) continue;
    for (const std::string* name : {&wish.subject, &wish.object, &wish.second_object}) {
      add_if_zone(*name);
    }
  }
  for (const WantedRows& rows : found.rows)
    named.add(rows.zone);
  return named;
}

// What any room has floor for: the first of the profile's zones with ordinary shelves.
NamedZones plain_zones(const StoreProgram& program, const catalog::Catalog& catalog) {
  NamedZones zones;
  for (const std::string& type : program.profile->zones) {
    const catalog::ZoneTypeRow* row = catalog.zone_type(type);
    if (row == nullptr || row->fixture != "gondola") continue;
    zones.add(type);
    break;
  }
  return zones;
}

// Zones of a drawing, but for those that the words refuse.
void add_drawn(NamedZones& chosen, const Understanding& found, const DrawnZones& drawn) {
  for (const std::string& type : drawn.types) {
    const auto count = std::ranges::count(drawn.types, type);
    if (found.find(Kind::zone_absent, type) == nullptr) chosen.add(type, static_cast<int>(count));
  }
}

// Zone types in order of importance: named ones first, then the profile's, as many as the floor can
// hold.
NamedZones chosen_zones(const Understanding& found,
                        const catalog::Catalog& catalog,
                        const StoreProgram& program) {
  NamedZones chosen = program.plain ? plain_zones(program, catalog) : named_zones(found, catalog);
  if (program.drawn && !program.plain) add_drawn(chosen, found, *program.drawn);
  const bool only_machines = found.find(Kind::zone_absent, "checkout") != nullptr &&
                             chosen.count.contains("self_checkout");
  const bool none = wants_no_tills(found);
  const bool usual =
      std::ranges::find(program.profile->zones, "checkout") != program.profile->zones.end();
  if (!only_machines && !none && usual) chosen.add("checkout");
  // Where orders are handed over, and money if it must be.
  if (none || !usual) chosen.add("customer_service");
  const auto wanted =
      static_cast<std::size_t>(zones_in_any_store + program.area_m2() / further_zone_m2);
  const std::size_t most = std::min(wanted, max_zones);
  for (const std::string& type : program.profile->zones) {
    if (program.drawn) break;  // who draws zones draws all of them
    const bool till = is_till(type) && wants_no_tills(found);
    const bool refused = till || found.find(Kind::zone_absent, type) != nullptr;
    if (chosen.order.size() < most && !refused && !program.plain) chosen.add(type);
  }
  return chosen;
}

double emphasis_on(const Understanding& found, const std::string& type) {
  double factor = 1;
  for (const Emphasis& emphasis : found.emphases) {
    if (emphasis.zone == type) factor *= emphasis.factor;
  }
  return std::clamp(factor, 0.3, 4.0);
}

// Small shops take money over a counter, and so do those whose floor has no room for lanes.
bool pays_at_counter(const Understanding& found,
                     const catalog::ZoneTypeRow& type,
                     const StoreProgram& program) {
  const bool only_machines = found.find(Kind::zone_absent, "checkout") != nullptr;
  if (type.type == "self_checkout") return only_machines && program.till_counter;
  const plan::Requirement* lanes = found.find(Kind::fixture_count, "checkout_lane");
  const bool one_till = lanes == nullptr || lanes->value <= 1;
  return type.type == "checkout" &&
         (program.till_counter || (one_till && program.area_m2() < lanes_from_m2));
}

// In the place of one that was refused: the first that keeps the same goods. Null when there is
// none.
const catalog::FixtureKind* replacement_of(const Understanding& found,
                                           const catalog::Catalog& catalog,
                                           const catalog::FixtureKind& refused,
                                           std::string_view zone_type) {
  const auto other =
      std::ranges::find_if(catalog.fixture_kinds, [&](const catalog::FixtureKind& kind) {
        return kind.temperature == refused.temperature && kind.role == refused.role &&
               kind.generator != "endcap" && !kind.keywords.empty() &&
               !is_refused(found, kind, zone_type);
      });
  return other == catalog.fixture_kinds.end() ? nullptr : &*other;
}

// Pallets of water stand beside the shelves of drinks; wine racks stand in the place of shelves.
bool can_be_main(const catalog::FixtureKind& kind, const catalog::FixtureKind& usual) {
  return kind.temperature == usual.temperature &&
         (!is_walked_round(kind) || is_walked_round(usual));
}

// A named fixture kind replaces the zone's usual one when it can hold the same goods.
const catalog::FixtureKind* kind_of(const Understanding& found,
                                    const catalog::Catalog& catalog,
                                    const catalog::ZoneTypeRow& type,
                                    const StoreProgram& program) {
  if (pays_at_counter(found, type, program)) return catalog.fixture_kind("till-counter");
  const catalog::FixtureKind* usual =
      type.fixture.empty() ? nullptr : catalog.fixture_kind(type.fixture);
  const std::vector<KindWish> wishes = kind_wishes(found, catalog, type.type);
  const bool usual_is_named =
      std::ranges::any_of(wishes, [&](const KindWish& wish) { return wish.kind == usual; });
  if (usual_is_named) return usual;
  for (const KindWish& wish : wishes) {
    if (usual == nullptr || can_be_main(*wish.kind, *usual)) return wish.kind;
  }
  const bool shelving = usual != nullptr && usual->role == catalog::FixtureRole::shelving;
  if (shelving && is_refused(found, *usual, type.type))
    return replacement_of(found, catalog, *usual, type.type);
  // Convenience stores keep drinks behind glass doors; other shops in open coolers.
  const bool convenience = program.profile->id.starts_with("convenience");
  if (type.type == "chilled" && convenience) return catalog.fixture_kind("glass_door_cooler");
  const bool counter = usual != nullptr && usual->generator == "serve_over";
  if (counter && program.area_m2() < staffed_counter_from_m2)
    return catalog.fixture_kind("multideck");
  return usual;
}

// Of tills and desks.
std::optional<int> count_of(const Understanding& found, const catalog::FixtureKind& kind) {
  const plan::Requirement* wish = found.find(Kind::fixture_count, kind.kind);
  return wish != nullptr && wish->value > 0 ? std::optional<int>(static_cast<int>(wish->value))
                                            : std::nullopt;
}

// What the words want of the zone's own kind, and what is to stand beside it.
void add_kind_wishes(ProgramZone& zone,
                     const Understanding& found,
                     const catalog::Catalog& catalog) {
  if (zone.kind == nullptr) return;
  if (zone.kind->role != catalog::FixtureRole::shelving) {
    zone.count = count_of(found, *zone.kind);
    return;
  }
  for (KindWish& wish : kind_wishes(found, catalog, zone.type->type)) {
    if (wish.kind == zone.kind) {
      zone.main = wish;
      zone.count = wish.count;
    } else if (wish.kind->role != catalog::FixtureRole::checkout) {
      if (!wish.count && !wish.runs) wish.count = std::max(some_beside, wish.least);
      zone.beside.push_back(wish);
    }
  }
  const catalog::FixtureKind* wall = kind_on_walls(*zone.kind, catalog);
  const bool refused =
      wall != nullptr && wall != zone.kind && is_refused(found, *wall, zone.type->type);
  if (refused) zone.beside.push_back({wall, 0, 0, std::nullopt, 0});
}

ProgramZone make_zone(const Understanding& found,
                      const catalog::Catalog& catalog,
                      const catalog::ZoneTypeRow& type,
                      const StoreProgram& program,
                      int index) {
  ProgramZone zone;
  zone.id = zone_id(type.type, index);
  zone.type = &type;
  zone.kind = kind_of(found, catalog, type, program);
  zone.stance = stance_of(type, zone.kind);
  zone.cold = type.temperature != catalog::Storage::ambient;
  zone.stressed = emphasis_on(found, type.type) > 1;
  if (index == 0) add_kind_wishes(zone, found, catalog);
  if (const plan::Requirement* area = found.find(Kind::area, type.type)) {
    constexpr double to_be_sure = 0.04;  // what layouts shift may cost a zone
    zone.wanted_how = area->comparison;
    const bool least = area->comparison == plan::Comparison::at_least;
    zone.wanted_m2 = area->value * (least ? 1 + to_be_sure : 1);
  }
  for (const WantedRows& rows : found.rows) {
    if (rows.zone == type.type) zone.rows = rows.rows;
  }
  return zone;
}

// Shares are those of an ordinary supermarket; a profile that names a zone early gives it more.
double importance_of(const catalog::ProfileRow& profile, const std::string& type) {
  constexpr double first = 1.6, last = 0.7;
  const auto count = static_cast<double>(profile.zones.size());
  const auto at = std::ranges::find(profile.zones, type) - profile.zones.begin();
  return first - (first - last) * static_cast<double>(at) / std::max(1.0, count);
}

// The floor that words give a zone, in numbers or by what they count there.
std::optional<double> said_floor_m2(const ProgramZone& zone, const catalog::ProfileRow& profile) {
  if (zone.wanted_m2 && zone.wanted_how != plan::Comparison::at_most) return zone.wanted_m2;
  if (zone.main.count || zone.main.runs) return counted_floor_m2(zone, profile);
  return std::nullopt;
}

// Floor in proportion to the zone types' shares and to what the words stress.
void share_floor(StoreProgram& program,
                 const Understanding& found,
                 const std::map<std::string, int>& count) {
  const auto share_of = [&](const ProgramZone& zone) {
    const std::string& type = zone.type->type;
    if (is_till(type)) return 0.0;
    return zone.type->share * emphasis_on(found, type) * importance_of(*program.profile, type) /
           count.at(type);
  };
  // What words measure comes first; the others share what it leaves, if that is not too little.
  constexpr double min_left = 0.6;
  const double selling_m2 = program.area_m2() * (1 - checkout_zones_share);
  double left_m2 = selling_m2, shares = 0;
  for (ProgramZone& zone : program.zones) {
    const std::optional<double> said = said_floor_m2(zone, *program.profile);
    zone.target_m2 = said.value_or(0);
    left_m2 -= zone.target_m2;
    if (!said) shares += share_of(zone);
  }
  left_m2 = std::max(left_m2, min_left * selling_m2);
  for (ProgramZone& zone : program.zones) {
    if (said_floor_m2(zone, *program.profile)) continue;
    const double fair_m2 = shares > 0 ? left_m2 * share_of(zone) / shares : 0;
    zone.target_m2 = std::max(fair_m2, counted_floor_m2(zone, *program.profile));
    if (zone.wanted_m2) zone.target_m2 = std::min(zone.target_m2, *zone.wanted_m2);  // at most
  }
}

// A floor of no said size is as large as what is counted on it needs.
void grow_floor(StoreProgram& program, const Understanding& found) {
  constexpr double selling_share = 0.62;  // of the floor: the rest is aisles before walls and tills
  constexpr int before_and_behind_runs_mm =
      12000;                           // tills, the back wall's cabinets and two aisles
  constexpr double crowded = 1.1;      // a little more is found on the usual floor
  constexpr double front_share = 0.7;  // of the front for the tills: people come in, too
  double counted_m2 = 0, shares = 0, counted_shares = 0;
  int tills_mm = 0;
  for (const ProgramZone& zone : program.zones) {
    if (zone.stance == Stance::front) {
      const bool said = zone.kind != nullptr && count_of(found, *zone.kind).has_value();
      tills_mm += said ? till_width_mm(zone, usual_front_mm) : 0;
      continue;
    }
    const double m2 = counted_floor_m2(zone, *program.profile);
    shares += zone.type->share;
    counted_shares += m2 > 0 ? zone.type->share : 0;
    counted_m2 += m2;
  }
  const double others = shares > 0 ? 1 - counted_shares / shares : 0;
  const double area = program.area_m2() * others + counted_m2 / selling_share;
  if (area > crowded * program.area_m2()) {
    const double most = 1e-6 * max_store_side_mm * max_store_side_mm;
    const std::array<int, 2> size = size_with_area(*program.profile, std::min(area, most));
    program.width_mm = std::max(program.width_mm, size[0]);
    program.depth_mm = std::max(program.depth_mm, size[1]);
  }
  for (const ProgramZone& zone :
       program.zones) {  // as deep as its longest run, with tills before it
    const int run = counted_run_mm(zone);
    if (run > 0 && zone.stance != Stance::front)
      program.depth_mm = std::max(program.depth_mm, rounded_mm(run + before_and_behind_runs_mm));
  }
  const double front_mm = std::min(tills_mm / front_share, max_store_side_mm);
  program.width_mm = std::max(program.width_mm, rounded_mm(front_mm));
}

// Lanes by the profile's habit; never so many that the front has no room for an entrance.
void count_lanes(StoreProgram& program) {
  for (ProgramZone& zone : program.zones) {
    if (zone.type->type != "checkout" || zone.count) continue;
    const double wanted = program.profile->checkouts_per_100_m2 * program.area_m2() / 100;
    constexpr int lane_mm = 2100, half_door_mm = 2000;  // with its passage; with its free floor
    // Half of the front; less where people come in through the middle of it.
    const bool middle = program.entrance_at == 0.5;
    const int fit = (program.width_mm / 2 - (middle ? half_door_mm : 0)) / lane_mm;
    zone.count = std::clamp(static_cast<int>(std::lround(wanted)), 1, std::max(1, fit));
  }
}

int most_of(const Concessions& concessions, const std::string& what, int wanted) {
  const auto most = concessions.max_count.find(what);
  return most == concessions.max_count.end() ? wanted : std::min(wanted, most->second);
}

// What was found to have no room is not asked for again.
void keep_to(const Concessions& concessions, ProgramZone& zone) {
  const std::string& type = zone.type->type;
  const bool goods = zone.kind != nullptr && zone.kind->role == catalog::FixtureRole::shelving;
  if (goods && zone.count == 0) zone.count.reset();  // as many as find room
  if (zone.main.runs) {
    zone.main.runs = most_of(concessions, type + "/runs", *zone.main.runs);
    if (zone.count) zone.main.runs = std::min(*zone.main.runs, *zone.count);
    if (zone.main.runs == 0) zone.main.runs.reset();
  }
  for (KindWish& wish : zone.beside) {
    const std::string name = type + "/" + wish.kind->kind;
    if (wish.runs) wish.runs = most_of(concessions, name + "/runs", *wish.runs);
    if (wish.count) wish.count = most_of(concessions, name, *wish.count);
    if (wish.count && wish.runs) wish.runs = std::min(*wish.runs, *wish.count);
  }
  std::erase_if(zone.beside, [](const KindWish& wish) { return wish.runs == 0; });
}

// Drafts have the entrance's wall in the south; turned, its directions are reversed for two walls.
std::optional<double> entrance_asked_at(const Understanding& found) {
  constexpr double near_end = 0.15;
  const plan::Wall wall = entrance_wall_of(found);
  const bool reversed = wall == plan::Wall::north || wall == plan::Wall::west;
  for (const plan::Requirement& wish : found.requirements) {
    if (wish.kind != Kind::opening || wish.subject != "entrance" || wish.second_object.empty())
      continue;
    if (!wish.object.empty() && wish.object != name_of(wall)) continue;
    if (wish.second_object == "center") return 0.5;
    const bool low = wish.second_object == "west" || wish.second_object == "south";
    return low != reversed ? near_end : 1 - near_end;
  }
  return std::nullopt;
}

std::optional<int> whole(const plan::Requirement* wish) {
  if (wish == nullptr) return std::nullopt;
  return static_cast<int>(std::lround(wish->value));
}

}  // namespace

const catalog::ProfileRow& profile_of(const Brief& brief,
                                      const Understanding& found,
                                      const catalog::Catalog& catalog) {
  const plan::Requirement* wish = found.find(Kind::profile);
  const catalog::ProfileRow* row = nullptr;
  if (brief.profile) row = catalog.profile(*brief.profile);
  if (row == nullptr && wish != nullptr) row = catalog.profile(wish->object);
  if (row == nullptr && wants_no_tills(found)) row = catalog.profile(profile_without_tills);
  if (row == nullptr && found.photographed.profile)
    row = catalog.profile(found.photographed.profile->value);
  if (row == nullptr) row = catalog.profile(usual_profile);
  return row != nullptr ? *row : catalog.profiles.front();
}

bool enlarge(StoreProgram& program) {
  constexpr double step = 1.2;  // of the floor, our own figure
  const auto longer = [](int side_mm) {
    return std::min(static_cast<int>(max_store_side_mm), rounded_mm(side_mm * std::sqrt(step)));
  };
  const int width = longer(program.width_mm), depth = longer(program.depth_mm);
  if (width == program.width_mm && depth == program.depth_mm) return false;
  program.width_mm = width;
  program.depth_mm = depth;
  for (ProgramZone& zone : program.zones) {
    const bool exact = zone.wanted_m2 || zone.main.count || zone.main.runs;
    if (!exact) zone.target_m2 *= step;
  }
  return true;
}

std::vector<std::string> named_zone_types(const Understanding& found,
                                          const catalog::Catalog& catalog) {
  return named_zones(found, catalog).order;
}

std::string zone_id(const std::string& type, int index) {
  return index == 0 ? type : type + "-" + std::to_string(index + 1);
}

Result<StoreProgram> make_program(const Brief& brief,
                                  const Understanding& found,
                                  const catalog::Catalog& catalog,
                                  const Concessions& concessions,
                                  std::vector<std::string>& trace) {
  StoreProgram program;
  program.till_counter = concessions.till_counter;
  program.plain = concessions.plain;
  program.columns_at_walls = concessions.plans_before > 0;
  program.profile = &profile_of(brief, found, catalog);
  MARKETGEN_TRY(const auto size, floor_size_of(brief, found, *program.profile));
  program.width_mm = size[0];
  program.depth_mm = size[1];
  program.shell = brief.shell;
  program.drawn = brief.zones;
  if (brief.shell) program.outside = layout::make_floor(*brief.shell).outside;
  program.aisles = whole(found.find(Kind::aisle_count));
  program.aisle_mm = whole(found.find(Kind::aisle_width));
  if (program.aisle_mm) program.aisle_how = found.find(Kind::aisle_width)->comparison;
  program.across = found.photographed.across && found.photographed.across->value;
  if (found.photographed.aisle_mm) program.aisle_mm = found.photographed.aisle_mm->value;
  if (program.aisle_mm)  // narrower ones are against the rules of any shop
    program.aisle_mm = std::max(*program.aisle_mm, program.profile->minimum_aisle_mm);
  const NamedZones chosen = chosen_zones(found, catalog, program);
  for (const std::string& type : chosen.order) {
    const catalog::ZoneTypeRow* row = catalog.zone_type(type);
    if (row == nullptr) continue;
    for (int i = 0; i < chosen.count.at(type); ++i) {
      const std::size_t room = is_till(type) ? max_zones : max_zones - 1;  // one is for the tills
      if (program.zones.size() >= room) break;
      program.zones.push_back(make_zone(found, catalog, *row, program, i));
    }
  }
  share_floor(program, found, chosen.count);
  share_numbers_of_store(program, found, catalog);
  program.entrance_at = entrance_asked_at(found);
  count_lanes(program);
  program.open = !floor_size_is_said(brief, found);
  if (program.open) grow_floor(program, found);
  for (int i = 0; program.open && i < concessions.growth; ++i)
    enlarge(program);
  share_floor(program, found, chosen.count);
  program.equipment = equipment_of(found, catalog);
  for (ProgramZone& zone : program.zones) {
    const auto most = concessions.max_count.find(zone.type->type);
    if (zone.count && most != concessions.max_count.end())
      zone.count = std::min(*zone.count, most->second);
    keep_to(concessions, zone);
  }
  for (plan::EquipmentSpec& spec : program.equipment)
    spec.count = most_of(concessions, spec.kind, spec.count);
  trace.push_back("profile " + program.profile->id + ", " + metres(program.width_mm) + " x " +
                  metres(program.depth_mm) + " m, " + std::to_string(program.zones.size()) +
                  " zones");
  return program;
}

}  // namespace marketgen::intake
