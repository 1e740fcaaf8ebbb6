#include <algorithm>
#include <cstdint>
#include <set>

#include "base/hash.h"
#include "base/interrupt.h"
#include "io/json.h"
#include "layout/layout.h"
#include "layout/layout_rules.h"
#include "layout/repair_moves.h"
#include "layout/zone_faults.h"

namespace marketgen::layout {
namespace {

// Layouts that may be tried: many while the shop is unlawful, few for the sake of habit, fewer
// where each takes long.
constexpr int max_trials_hard = 60;
constexpr int max_trials_soft = 18;
constexpr double large_shop_m2 = 600;
constexpr int max_trials_soft_large = 8;
constexpr int impossible = 1'000'000;  // hard faults of a plan that has no layout

struct Trial {
  plan::Plan plan;
  Layout layout;
  FaultCount score;
};

// Fewer faults; or no more of them and one empty zone less, so that of several that crowd one
// another out the last has room.
bool improves(const Trial& trial, const Trial& now, const Violation& fault) {
  if (trial.score < now.score) return true;
  const bool left_out =
      fault.code == "ZONE_EMPTY" && trial.plan.zones.size() < now.plan.zones.size();
  return left_out && trial.score == now.score;
}

const LayoutRule* rule_of(const Violation& violation) {
  const std::vector<LayoutRule>& rules = layout_rules();
  const auto rule = std::ranges::find(rules, violation.code, &LayoutRule::code);
  return rule == rules.end() ? nullptr : &*rule;
}

std::int64_t work_of_floor(const plan::Shell& shell) {
  constexpr double m2_per_module = 10;
  return static_cast<std::int64_t>(1e-6 * shell.width_mm * shell.depth_mm / m2_per_module);
}

class Repair {
 public:
  Repair(const catalog::Catalog& catalog, Seed seed, double store_m2, std::int64_t max_work)
      : catalog_(catalog),
        seed_(seed),
        max_work_(max_work),
        soft_left_(store_m2 > large_shop_m2 ? max_trials_soft_large : max_trials_soft) {}

  Result<Trial> lay_out(const plan::Plan& plan) {
    Result<Layout> layout = make_layout(plan, catalog_, seed_);
    work_ += work_of_floor(plan.shell);
    if (!layout.ok() && layout.error().code != "layout.impossible") return layout.error();
    if (!layout.ok()) return Trial{plan, {}, {impossible, 0}};
    work_ += std::ssize(layout->fixtures);
    const FaultCount score = count_faults(layout->violations);
    return Trial{plan, std::move(layout).value(), score};
  }

  // The first candidate that is better, hard faults first; nothing when none is or the trials are
  // used up.
  std::optional<std::pair<Trial, RepairCandidate>> better(const Trial& now) {
    std::vector<Violation> faults = now.layout.violations;
    if (now.score.hard >= impossible) faults = emptiness(now.plan);
    std::ranges::stable_sort(faults, {}, &Violation::severity);
    std::set<std::pair<std::string, std::string>> seen;
    for (const Violation& fault : faults) {
      const LayoutRule* rule = rule_of(fault);
      if (rule == nullptr || !seen.insert({fault.code, fault.where}).second) continue;
      for (const RepairMove move : rule->repairs) {
        for (RepairCandidate& candidate : propose(move, {now.plan, now.layout, fault, catalog_})) {
          int& left = fault.severity == Severity::hard ? hard_left_ : soft_left_;
          if (left <= 0 || work_ >= max_work_) break;
          if (!is_new(candidate.plan) ||
              !plan::validate_plan(candidate.plan, "repair", catalog_).ok())
            continue;
          if (!may_mend(candidate.plan, now, fault)) continue;
          --left;
          Result<Trial> trial = lay_out(candidate.plan);
          if (trial.ok() && improves(*trial, now, fault))
            return std::pair{std::move(trial).value(), std::move(candidate)};
        }
      }
    }
    return std::nullopt;
  }

  void remember(const plan::Plan& plan) { is_new(plan); }
  std::int64_t work() const { return work_; }

 private:
  // A fault of zones is mended by fewer of them, which takes no layout to know.
  bool may_mend(const plan::Plan& plan, const Trial& now, const Violation& fault) const {
    return !is_about_zones(fault.code) ||
           zone_faults(plan, catalog_) < zone_faults(now.plan, catalog_);
  }

  bool is_new(const plan::Plan& plan) {
    return tried_.insert(hash64(io::write_json_line(plan))).second;
  }

  // A plan without a single fixture: every zone is empty.
  static std::vector<Violation> emptiness(const plan::Plan& plan) {
    std::vector<Violation> faults;
    for (const plan::Zone& zone : plan.zones) {
      faults.push_back({"ZONE_EMPTY",
                        Severity::hard,
                        zone.id,
                        0,
                        1,
                        "zone " + zone.id + " holds no fixture",
                        {}});
    }
    return faults;
  }

  const catalog::Catalog& catalog_;
  Seed seed_;
  std::int64_t max_work_, work_ = 0;
  int hard_left_ = max_trials_hard;
  int soft_left_;
  std::set<std::uint64_t> tried_;
};

}  // namespace

Result<Repaired> repair_plan(const plan::Plan& plan,
                             const catalog::Catalog& catalog,
                             Seed seed,
                             std::int64_t max_work) {
  const double store_m2 = 1e-6 * plan.shell.width_mm * plan.shell.depth_mm;
  Repair repair(catalog, seed, store_m2, max_work);
  repair.remember(plan);
  MARKETGEN_TRY(Trial now, repair.lay_out(plan));
  Repaired repaired;
  while (now.score > FaultCount{}) {
    MARKETGEN_CHECK(check_interrupt());
    auto next = repair.better(now);
    if (!next) break;
    now = std::move(next->first);
    for (const std::string& path : next->second.paths) {
      now.plan.provenance.push_back({path, plan::Source::repair, std::nullopt, 1});
    }
    repaired.changes.push_back(std::move(next->second.change));
  }
  repaired.plan = std::move(now.plan);
  if (now.score.hard < impossible) repaired.layout = std::move(now.layout);
  repaired.work = repair.work();
  return repaired;
}

}  // namespace marketgen::layout
