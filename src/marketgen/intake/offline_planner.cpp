#include "intake/offline_planner.h"

#include <algorithm>
#include <cmath>

#include "intake/conflicts.h"
#include "intake/draft_search.h"
#include "intake/drawn_floor.h"
#include "intake/drawn_runs.h"
#include "intake/drawn_shell.h"
#include "intake/limits.h"
#include "intake/photo_wishes.h"
#include "intake/plan_writer.h"
#include "intake/relation_geometry.h"
#include "intake/store_program.h"
#include "intake/store_size.h"
#include "intake/understanding.h"
#include "io/file.h"
#include "plan/bsp.h"

namespace marketgen::intake {
namespace {

constexpr double crowded_m = 0.4;  // zones that lack more than this do not fit
constexpr std::size_t min_zones = 2;
constexpr std::string_view no_room = "the floor has no room for another zone";
constexpr std::string_view not_found =
    "no floor for so many zones was found in the time that planning may take";
constexpr int patient_searches = 5;  // that lose one zone each; then more at once
// What the searches of one plan may cost (work_of_a_start): eight of a usual shop's.
constexpr std::int64_t max_work = 600'000;

// The first wish that names a zone of this type; null when nobody asked for one.
const plan::Requirement* wish_for(const Understanding& found, const ProgramZone& zone) {
  const auto wish = std::ranges::find_if(found.requirements, [&](const plan::Requirement& one) {
    return one.kind != plan::RequirementKind::zone_absent &&
           (one.subject == zone.type->type || one.object == zone.type->type);
  });
  return wish == found.requirements.end() ? nullptr : &*wish;
}

bool is_named(const Understanding& found, const ProgramZone& zone) {
  return wish_for(found, zone) != nullptr;
}

bool has_zone(const StoreProgram& program, std::string_view type) {
  return std::ranges::any_of(program.zones,
                             [&](const ProgramZone& zone) { return zone.type->type == type; });
}

// A shop keeps its lanes, its machines where it has no lanes, and its desk where it has neither.
bool is_kept(const StoreProgram& program, const ProgramZone& zone) {
  for (const std::string_view type : {"checkout", "self_checkout", "customer_service"}) {
    if (has_zone(program, type)) return zone.type->type == type;
  }
  return false;
}

bool sells_goods(const ProgramZone& zone) {
  return zone.kind != nullptr && zone.kind->role == catalog::FixtureRole::shelving;
}

// The zone that is given up first: the least important one that nobody asked for, else the last one
// asked for. A shop without a back room is one, without goods is none.
std::size_t max_dispensable(const StoreProgram& program, const Understanding& found) {
  constexpr std::ptrdiff_t min_selling = 3;
  const bool few = std::ranges::count_if(program.zones, sells_goods) <= min_selling;
  for (std::size_t i = program.zones.size(); i-- > 0;) {
    const ProgramZone& zone = program.zones[i];
    if (!is_kept(program, zone) && !is_named(found, zone) && !(few && sells_goods(zone))) return i;
  }
  for (const bool goods : {false, true}) {
    for (std::size_t i = program.zones.size(); i-- > 0;) {
      const ProgramZone& zone = program.zones[i];
      if (!is_kept(program, zone) && sells_goods(zone) == goods) return i;
    }
  }
  return program.zones.size() - 1;
}

// Takes that zone out; a zone that was asked for becomes a conflict.
void give_up_zone(std::size_t lost,
                  StoreProgram& program,
                  Understanding& found,
                  std::string_view why,
                  std::vector<std::string>& trace) {
  const ProgramZone zone = program.zones[lost];
  program.zones.erase(program.zones.begin() + static_cast<std::ptrdiff_t>(lost));
  trace.push_back("no room for " + zone.id);
  const plan::Requirement* wish = wish_for(found, zone);
  if (wish == nullptr) return;
  found.conflicts.push_back(
      {"zone " + zone.type->type, "the size of the store", wish->text, std::string(why)});
}

void give_up_zone(StoreProgram& program,
                  Understanding& found,
                  std::string_view why,
                  std::vector<std::string>& trace) {
  give_up_zone(max_dispensable(program, found), program, found, why, trace);
}

// Wishes for zones that a plain store has no floor for.
void give_up_all_but_plain(const StoreProgram& program, Understanding& found) {
  for (const plan::Requirement& wish : found.requirements) {
    const bool there = std::ranges::any_of(
        program.zones, [&](const ProgramZone& zone) { return zone.type->type == wish.subject; });
    if (wish.kind != plan::RequirementKind::zone_present || there) continue;
    found.conflicts.push_back({"zone " + wish.subject,
                               "the size of the store",
                               wish.text,
                               "the floor has room for a till and ordinary shelves only"});
  }
}

bool fits(const Candidate& candidate, std::size_t zones) {
  if (candidate.drafted.crowding > crowded_m) return false;
  if (tree_depth(candidate.root) > plan::max_bsp_depth) return false;
  for (std::size_t i = 0; i < zones; ++i) {
    const RectMm& rect = candidate.rects[i];
    if (std::min(rect.width(), rect.depth()) < plan::min_node_side_mm) return false;
  }
  return true;
}

// A store too small for bands: its zones side by side, the tills next to the door.
Candidate side_by_side(const StoreProgram& program,
                       const Understanding& found,
                       const catalog::Catalog& catalog) {
  FloorDraft draft;
  for (int i = 0; i < static_cast<int>(program.zones.size()); ++i)
    draft.tills.push_back(i);
  Candidate candidate = make_candidate(draft, program, found, catalog);
  const bool wide = program.width_mm >= program.depth_mm;
  const int length = wide ? program.width_mm : program.depth_mm;
  const auto count = static_cast<int>(program.zones.size());
  const int gap = std::min(1000, length / (3 * count));
  candidate.root = cut_slice(wide ? plan::Axis::x : plan::Axis::y);
  const int size = (length - (count - 1) * gap) / count;
  for (int i = 0; i < count; ++i)
    candidate.root.add(zone_slice(i), size, gap);
  candidate.root.sizes_mm.back() = length - (count - 1) * (size + gap);
  candidate.root = simplified(std::move(candidate.root));
  candidate.rects = zone_rects(candidate.root, candidate.floor, program.zones.size());
  return candidate;
}

// The starts of the next search: no more than half of the work that is left, so that searches with
// fewer zones still have some.
int affordable_starts(const StoreProgram& program,
                      const Understanding& found,
                      std::int64_t work_left) {
  const std::int64_t starts = work_left / 2 / work_of_a_start(program, found);
  return static_cast<int>(std::clamp<std::int64_t>(starts, 1, max_starts));
}

// What words measure and count takes less than the room that it needs, in the end what there is.
// False when that changes nothing.
bool loosen_measures(StoreProgram& program, std::vector<std::string>& trace) {
  constexpr double step = 0.25, area_step = 0.9;
  const auto is_measured = [](const ProgramZone& zone) {
    return zone.wanted_m2 && zone.wanted_how != plan::Comparison::at_most;
  };
  const bool said = std::ranges::any_of(program.zones, [&](const ProgramZone& zone) {
    return zone.stance != Stance::front &&
           (zone.main.count || zone.main.runs || !zone.beside.empty() || is_measured(zone));
  });
  if (program.counted_share <= 0 || !said) return false;
  if (program.counted_share == 1)
    trace.emplace_back("no room for all fixtures and floors that are counted");
  program.counted_share -= step;
  for (ProgramZone& zone : program.zones)
    if (is_measured(zone)) *zone.wanted_m2 *= area_step;
  return true;
}

// Before a zone is lost that was asked for. False when nothing is left to try.
bool make_room(StoreProgram& program, const Understanding& found, std::vector<std::string>& trace) {
  if (!is_named(found, program.zones[max_dispensable(program, found)])) return false;
  if (!program.open || !enlarge(program)) return loosen_measures(program, trace);
  trace.push_back("a larger floor: " + metres(program.width_mm) + " x " + metres(program.depth_mm) +
                  " m");
  return true;
}

// The zone with the narrowest floor.
std::size_t narrowest(const Candidate& candidate, std::size_t zones) {
  const auto side = [](const RectMm& rect) { return std::min(rect.width(), rect.depth()); };
  const auto end = candidate.rects.begin() + static_cast<std::ptrdiff_t>(zones);
  return static_cast<std::size_t>(std::ranges::min_element(candidate.rects.begin(), end, {}, side) -
                                  candidate.rects.begin());
}

// The drawing's floor, without the zones that would be too narrow for anything.
Candidate find_drawn_floor(StoreProgram& program,
                           Understanding& found,
                           std::vector<std::string>& trace) {
  for (;;) {
    DrawnFloor drawn = drawn_floor(program, found);
    if (fits(drawn.candidate, program.zones.size()) || program.zones.size() <= min_zones) {
      trace.push_back("zones as drawn, IoU " + std::to_string(std::lround(100 * drawn.fit_iou)) +
                      " %");
      return std::move(drawn.candidate);
    }
    const std::size_t lost = narrowest(drawn.candidate, program.zones.size());
    const std::string type = program.zones[lost].type->type;
    found.conflicts.push_back({"zone " + type,
                               "the drawing's other zones",
                               "the drawing's " + type,
                               "its floor is too narrow for anything"});
    give_up_zone(lost, program, found, no_room, trace);
  }
}

Candidate find_floor(StoreProgram& program,
                     Understanding& found,
                     const catalog::Catalog& catalog,
                     Seed seed,
                     std::int64_t work_left,
                     std::vector<std::string>& trace) {
  if (program.drawn && !program.plain) return find_drawn_floor(program, found, trace);
  for (int searches = 1;; ++searches) {
    const int starts = affordable_starts(program, found, work_left);
    work_left -= starts * work_of_a_start(program, found);
    FoundDraft best = search_draft(program, found, catalog, seed.child("floor"), starts);
    trace.push_back("judged " + std::to_string(best.evaluations) + " floors");
    const bool found_one =
        std::isfinite(best.penalty);  // on a sliver no draft can be judged at all
    if (found_one && fits(best.candidate, program.zones.size())) {
      trace.push_back("best one, penalty " +
                      std::to_string(static_cast<int>(std::lround(best.penalty))));
      return std::move(best.candidate);
    }
    if (program.zones.size() <= min_zones) return side_by_side(program, found, catalog);
    if (make_room(program, found, trace)) continue;
    // Hopeless floors lose several zones at once, so that the search runs a few times only.
    const int hopeless = std::max(0, searches - patient_searches);
    const int spent = work_left > 0 ? 0 : static_cast<int>(program.zones.size()) / 2;
    const int lost = 1 + static_cast<int>(best.candidate.drafted.crowding / 4) + hopeless + spent;
    for (int i = 0; i < lost && program.zones.size() > min_zones; ++i) {
      give_up_zone(program, found, spent > 0 ? not_found : no_room, trace);
      const bool named = is_named(found, program.zones[max_dispensable(program, found)]);
      if (named && program.open && spent == 0) break;  // a larger floor first
    }
  }
}

// A shop without a till is none.
void keep_tills(Understanding& found, const StoreProgram& program) {
  const bool has_lanes = has_zone(program, "checkout");
  const auto refused = std::ranges::find_if(found.requirements, [](const plan::Requirement& wish) {
    return wish.kind == plan::RequirementKind::zone_absent && wish.subject == "checkout";
  });
  if (!has_lanes || refused == found.requirements.end()) return;
  found.conflicts.push_back({"zone checkout",
                             "a checkout",
                             refused->text,
                             "a shop needs a place to pay; ask for self-checkouts instead"});
  found.requirements.erase(refused);
}

void trace_relations(const Planned& planned,
                     const Candidate& candidate,
                     const StoreProgram& program,
                     std::vector<std::string>& trace) {
  const plan::NamedFloor floor = named_floor(candidate, program);
  for (const plan::Requirement& wish : planned.requirements) {
    if (wish.kind != plan::RequirementKind::relation) continue;
    const plan::RelationTerms terms = plan::terms_of(wish);
    const auto measure = plan::measure_relation(floor, terms);
    const bool met = measure && measure->slack_m() >= planner_margin_m(*measure);
    trace.push_back((met ? "met: " : "not met: ") + plan::words_of(floor, terms, measure));
  }
}

}  // namespace

Result<OfflinePlanner> OfflinePlanner::load() {
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  MARKETGEN_TRY(Language language, Language::load(data));
  return OfflinePlanner(std::move(language));
}

Result<std::unique_ptr<Planner>> offline_planner() {
  MARKETGEN_TRY(OfflinePlanner planner, OfflinePlanner::load());
  return std::unique_ptr<Planner>(std::make_unique<OfflinePlanner>(std::move(planner)));
}

std::shared_ptr<const Language> OfflinePlanner::language_with(
    const catalog::Catalog& catalog) const {
  const auto made = [&] {
    return std::make_shared<const Language>(language_.with_words_of(catalog));
  };
  if (catalog.content_hash.empty()) return made();  // nobody knows when its rows change
  const std::scoped_lock lock(kept_->mutex);
  if (kept_->content_hash != catalog.content_hash) {
    kept_->language = made();
    kept_->content_hash = catalog.content_hash;
  }
  return kept_->language;
}

Result<Planned> OfflinePlanner::plan(const Brief& brief,
                                     const catalog::Catalog& catalog,
                                     Seed seed,
                                     const Concessions& concessions) const {
  Understanding found = understand(brief.prompt, *language_with(catalog), catalog);
  apply_flags(brief, found);
  apply_photos(brief, catalog, found);
  house_fixtures(found, catalog);
  const BeyondLimits beyond = keep_within_limits(found);
  Planned planned;
  Brief settled = brief;
  if (brief.shell) settled.shell = settled_shell(brief, found);
  MARKETGEN_TRY(StoreProgram program,
                make_program(settled, found, catalog, concessions, planned.trace));
  keep_tills(found, program);
  if (program.drawn) settle_zones(program, found);
  if (concessions.plain) give_up_all_but_plain(program, found);
  for (std::size_t i = program.zones.size(); i-- > 0;) {
    const bool lost = concessions.without.contains(program.zones[i].id);
    if (lost && !is_kept(program, program.zones[i]) && program.zones.size() > min_zones)
      give_up_zone(i, program, found, no_room, planned.trace);
  }
  while (program.zones.size() > std::max(min_zones, concessions.max_zones))
    give_up_zone(program, found, no_room, planned.trace);
  const Seed floors = concessions.draw == 0
                          ? seed.child("plan")
                          : seed.child("plan", static_cast<std::uint64_t>(concessions.draw));
  const Candidate candidate = find_floor(program,
                                         found,
                                         catalog,
                                         floors,
                                         max_work >> std::min(concessions.plans_before, 4),
                                         planned.trace);
  if (program.drawn) settle_runs(program, candidate, concessions, found);
  planned.plan = write_plan({brief, found, program, candidate, catalog});
  while (program.drawn && lower_runs(program, planned.plan, catalog, found))
    planned.plan = write_plan({brief, found, program, candidate, catalog});
  if (program.drawn) settle_relations(candidate, program, found, planned.plan);
  if (concessions.relations_may_fail) {
    for (plan::Relation& relation : planned.plan.relations)
      relation.strength = plan::Strength::prefer;
  }
  planned.floor_is_open = program.open;
  planned.requirements = as_asked(std::move(found.requirements), beyond);
  planned.unparsed = std::move(found.unparsed);
  planned.conflicts = std::move(found.conflicts);
  const bool silent = brief.prompt.find_first_not_of(" \t\r\n\v\f") == std::string::npos;
  const bool pictured = brief.shell || found.photographed.any();
  planned.understood = found.understood || (silent && pictured);  // pictures say it all
  trace_relations(planned, candidate, program, planned.trace);
  return planned;
}

}  // namespace marketgen::intake
