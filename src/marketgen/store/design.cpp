#include "store/design.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "base/interrupt.h"
#include "planners/make_planner.h"

namespace marketgen::store {
namespace {

constexpr std::string_view plan_stream = "plan", layout_stream = "layout";

constexpr int max_rounds = 10;
constexpr int max_other_floors = 2;   // before a zone is left out
constexpr int max_lax_rounds = 4;     // then the plainest floor there is
constexpr int max_growth = 2;         // of a floor of no said size
constexpr int plain_after_draws = 2;  // of the smallest program
constexpr std::size_t min_zones = 2;  // a till, and something to buy

int hard_faults(const layout::Layout& layout) {
  return static_cast<int>(
      std::ranges::count(layout.violations, layout::Severity::hard, &layout::Violation::severity));
}

bool holds_tills(const plan::Zone& zone) {
  return zone.type == "checkout" || zone.type == "self_checkout";
}

// What a fault is about: a zone by its type, and what of it stands behind the first '/' of `where`:
// a fixture kind, or "runs". Something else than a zone has no part.
struct Place {
  std::string name, part;
};
Place place_of(const layout::Violation& fault, const plan::Plan& plan) {
  const std::size_t cut = fault.where.find('/');
  const plan::Zone* zone = plan::find_zone(plan, fault.where.substr(0, cut));
  if (zone == nullptr) return {fault.where, ""};
  return {zone->type, cut == std::string::npos ? "" : fault.where.substr(cut)};
}

// The wish that the store no longer fulfils; null when nobody asked.
const plan::Requirement* wish_behind(const layout::Violation& fault,
                                     const intake::Planned& planned) {
  const Place place = place_of(fault, planned.plan);
  const bool relation = fault.code == "RELATION_BROKEN", runs = place.part.ends_with("/runs");
  const auto wish = std::ranges::find_if(planned.requirements, [&](const plan::Requirement& one) {
    if (relation) return one.kind == plan::RequirementKind::relation && one.subject == place.name;
    const bool of_kind =
        place.part.empty() || place.part == "/runs" || place.part.starts_with("/" + one.subject);
    const bool of_place = one.object == place.name || one.subject == place.name;
    return one.kind ==
               (runs ? plan::RequirementKind::run_count : plan::RequirementKind::fixture_count) &&
           of_place && of_kind;
  });
  return wish == planned.requirements.end() ? nullptr : &*wish;
}

// Decides what to give up next.
class Bargain {
 public:
  void concede(const Designed& now) {
    if (grows(now)) return;
    const intake::Concessions before = concessions_;
    bool crowded = false, no_till = false;
    for (const layout::Violation& fault : now.layout.violations) {
      if (fault.severity != layout::Severity::hard) continue;
      if (fault.code == "RELATION_BROKEN") {
        concessions_.relations_may_fail = true;
        note(fault, now.planned);
      } else if (fault.code == "COUNT_SHORT" &&
                 (fault.value >= 1 || !is_about_tills(fault, now.planned.plan))) {
        cap_count(fault, now.planned);
      } else {
        const bool tills = is_about_tills(fault, now.planned.plan);
        (tills ? no_till : crowded) = true;
        if (tills) note(fault, now.planned);
      }
    }
    if (no_till && concessions_.till_counter) crowded = true;
    if (no_till) concessions_.till_counter = true;
    if (crowded && other_floors_ < max_other_floors) {  // another one may have room for all of it
      ++other_floors_;
      ++concessions_.draw;
    } else if (crowded) {
      leave_out_zones(now.planned.plan.zones.size());
    }
    if (concessions_ == before) {  // another floor of the same, then one that is as plain as can be
      ++concessions_.draw;
      concessions_.plain = concessions_.draw > plain_after_draws + other_floors_;
      concessions_.till_counter = concessions_.till_counter || concessions_.plain;
    }
  }

  // Counts of goods and equipment, zones without any, and places alone stand in the way: these are
  // given up, and nothing else. False when something else does.
  bool give_up_wishes(const Designed& now) {
    const plan::Plan& plan = now.planned.plan;
    const auto is_wish = [&](const layout::Violation& fault) {
      if (fault.code == "RELATION_BROKEN") return true;
      const bool some = fault.code == "COUNT_SHORT" && fault.value >= 1;
      const bool none = fault.code == "COUNT_SHORT" || fault.code == "ZONE_EMPTY";
      return !fault.where.empty() && (some || (none && !is_about_tills(fault, plan)));
    };
    for (const layout::Violation& fault : now.layout.violations)
      if (fault.severity == layout::Severity::hard && !is_wish(fault)) return false;
    for (const layout::Violation& fault : now.layout.violations)
      if (fault.severity == layout::Severity::hard) give_up(fault, now.planned);
    return true;
  }

  // All zones that still have room, with as many fixtures as fit, wherever they stand.
  void concede_wishes(const Designed& now) {
    concessions_.relations_may_fail = true;
    for (const plan::Requirement& wish : now.planned.requirements) {
      const bool runs = wish.kind == plan::RequirementKind::run_count;
      if (!runs && wish.kind != plan::RequirementKind::fixture_count) continue;
      if (wish.object == "checkout" || wish.object == "self_checkout") continue;
      const std::string end = runs ? "/runs" : "";
      for (const std::string& what : {wish.object + end, wish.object + "/" + wish.subject + end})
        concessions_.max_count[what] = 0;
    }
  }

  // The plainest floor there is: nothing is left to try.
  void concede_all() {
    concessions_.relations_may_fail = true;
    concessions_.till_counter = concessions_.plain = true;
  }

  const intake::Concessions& concessions() const { return concessions_; }
  const std::vector<intake::Conflict>& given_up() const { return given_up_; }

 private:
  void give_up(const layout::Violation& fault, const intake::Planned& planned) {
    if (fault.code == "COUNT_SHORT") {
      short_of_[what_of(fault, planned.plan)] = 1;
      return cap_count(fault, planned);
    }
    if (fault.code == "ZONE_EMPTY")
      concessions_.without.insert(fault.where.substr(0, fault.where.find('/')));
    else
      concessions_.relations_may_fail = true;
    note(fault, planned);
  }

  // Where nobody said how large the floor is, what finds no room gets a larger one first.
  bool grows(const Designed& now) {
    const bool short_of_room =
        std::ranges::any_of(now.layout.violations, [](const layout::Violation& fault) {
          return fault.severity == layout::Severity::hard && fault.code != "RELATION_BROKEN";
        });
    if (!short_of_room || !now.planned.floor_is_open || concessions_.growth >= max_growth)
      return false;
    ++concessions_.growth;
    return true;
  }

  // Another floor has room for other numbers: each shortage of the same is met with less, and in
  // the end with none, or with as many as fit. So no shop becomes a plain one for a table too many.
  void cap_count(const layout::Violation& fault, const intake::Planned& planned) {
    const Place place = place_of(fault, planned.plan);
    const std::string what = what_of(fault, planned.plan);
    const auto value = static_cast<int>(fault.value);
    const int times = ++short_of_[what];
    const bool own = place.part.empty() || place.part == "/runs";
    int most = value;
    if (!is_about_tills(fault, planned.plan) && times > 1) most = own || times > 2 ? 0 : value / 2;
    concessions_.max_count[what] = most;
    note(fault, planned);
  }

  static std::string what_of(const layout::Violation& fault, const plan::Plan& plan) {
    const Place place = place_of(fault, plan);
    return place.name + place.part;
  }

  static bool is_about_tills(const layout::Violation& fault, const plan::Plan& plan) {
    const plan::Zone* zone = plan::find_zone(plan, fault.where.substr(0, fault.where.find('/')));
    return fault.code == "CHECKOUT_MISSING" || fault.code == "LANE_TOO_NARROW" ||
           (zone != nullptr && holds_tills(*zone));
  }

  // One zone first, then a quarter of them, then half.
  void leave_out_zones(std::size_t zones) {
    const std::size_t lost =
        crowded_rounds_ == 0 ? 1 : (crowded_rounds_ == 1 ? zones / 4 : zones / 2);
    ++crowded_rounds_;
    const std::size_t left = zones - std::min(zones, std::max<std::size_t>(lost, 1));
    concessions_.max_zones = std::max(min_zones, left);
  }

  void note(const layout::Violation& fault, const intake::Planned& planned) {
    const plan::Requirement* wish = wish_behind(fault, planned);
    if (wish == nullptr) return;
    intake::Conflict conflict{fault.code, "the rules of the shop", wish->text, fault.message};
    const auto same = [&](const intake::Conflict& known) {
      return known.dropped == conflict.dropped;
    };
    if (std::ranges::none_of(given_up_, same)) given_up_.push_back(std::move(conflict));
  }

  intake::Concessions concessions_;
  std::vector<intake::Conflict> given_up_;
  std::map<std::string, int> short_of_;  // how often there were too few of it
  int crowded_rounds_ = 0;
  int other_floors_ = 0;
};

Result<Designed> lay_out(intake::Planned planned,
                         const catalog::Catalog& catalog,
                         Seed seed,
                         std::int64_t max_work = layout::max_repair_work) {
  Designed designed;
  MARKETGEN_TRY(designed.repaired, layout::repair_plan(planned.plan, catalog, seed, max_work));
  MARKETGEN_TRY(designed.layout, layout_of(designed.repaired, catalog, seed));
  designed.planned = std::move(planned);
  return designed;
}

}  // namespace

Result<layout::Layout> layout_of(layout::Repaired& repaired,
                                 const catalog::Catalog& catalog,
                                 Seed seed) {
  if (repaired.layout) return *std::exchange(repaired.layout, std::nullopt);
  return layout_or_nothing(repaired.plan, catalog, seed);
}

Result<layout::Layout> layout_or_nothing(const plan::Plan& plan,
                                         const catalog::Catalog& catalog,
                                         Seed seed) {
  Result<layout::Layout> layout = layout::make_layout(plan, catalog, seed);
  if (layout.ok() || layout.error().code != "layout.impossible") return layout;
  layout::Layout nothing;
  nothing.violations.push_back(
      {"ZONE_EMPTY", layout::Severity::hard, "", 0, 1, layout.error().message, std::nullopt});
  return nothing;
}

bool keeps_hard_rules(const std::vector<layout::Violation>& rules) {
  return std::ranges::none_of(
      rules, [](const layout::Violation& v) { return v.severity == layout::Severity::hard; });
}

Result<Designed> concede(Designed first,
                         const PlanAgain& plan_again,
                         const catalog::Catalog& catalog,
                         Seed layout_seed) {
  // Whatever is planned again, what a language model did before stays on record.
  const std::optional<intake::PlannerRecord> record = first.planned.record;
  const std::vector<intake::PlannerFile> files = first.planned.files;
  Designed best = first, now = std::move(first);
  Bargain bargain;
  std::int64_t work_left = layout::max_repair_work / 2;  // for all rounds together
  int lax_rounds = 0;                                    // in which counts and places were given up
  for (int round = 0; round < max_rounds && hard_faults(best.layout) > 0; ++round) {
    MARKETGEN_CHECK(check_interrupt());
    bargain.concede(now);
    bool last = false;
    if (work_left <= 0 && (lax_rounds >= max_lax_rounds || !bargain.give_up_wishes(now))) {
      last = lax_rounds > 0;
      if (last)
        bargain.concede_all();
      else
        bargain.concede_wishes(now);
    }
    if (work_left <= 0) ++lax_rounds;
    intake::Concessions concessions = bargain.concessions();
    concessions.plans_before = round + 1;
    MARKETGEN_TRY(intake::Planned planned, plan_again(concessions));
    MARKETGEN_TRY(now, lay_out(std::move(planned), catalog, layout_seed, work_left));
    work_left -= now.repaired.work;
    if (last) round = max_rounds;
    if (hard_faults(now.layout) >= hard_faults(best.layout)) continue;
    best = now;
    const std::vector<intake::Conflict>& given_up = bargain.given_up();
    best.planned.conflicts.insert(best.planned.conflicts.end(), given_up.begin(), given_up.end());
  }
  if (best.layout.fixtures.empty())
    return Error{"layout.impossible", "prompt", best.layout.violations.front().message};
  best.planned.record = record;
  best.planned.files = files;
  return best;
}

Seed plan_seed(const std::optional<plan::Vary>& vary, Seed store) {
  return plan::axis_seed(vary, &plan::Vary::layout, store.child(plan_stream), plan_stream);
}

Seed layout_seed(const std::optional<plan::Vary>& vary, Seed store) {
  return plan::axis_seed(vary, &plan::Vary::layout, store.child(layout_stream), layout_stream);
}

Result<Designed> design_store(const intake::Brief& brief,
                              const catalog::Catalog& catalog,
                              Seed seed) {
  const Seed of_layout = layout_seed(brief.vary, seed);
  MARKETGEN_TRY(const std::unique_ptr<intake::Planner> planner,
                planners::make_planner(brief.planner, {}, of_layout));
  intake::Brief asked = brief;
  const PlanAgain plan = [&](const intake::Concessions& concessions) {
    return intake::plan_from_brief(
        asked, catalog, *planner, plan_seed(brief.vary, seed), concessions);
  };
  MARKETGEN_TRY(intake::Planned planned, plan({}));
  asked.seen = planned.seen;
  MARKETGEN_TRY(Designed first, lay_out(std::move(planned), catalog, of_layout));
  return concede(std::move(first), plan, catalog, of_layout);
}

}  // namespace marketgen::store
