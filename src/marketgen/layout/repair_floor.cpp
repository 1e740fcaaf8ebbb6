// Repair moves on the tree of cuts: aisles between parts of the floor, shares, places of zones.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "layout/design.h"
#include "layout/repair_candidates.h"
#include "layout/zone_faults.h"
#include "plan/bsp.h"
#include "plan/patch.h"
#include "plan/plan_edit.h"

namespace marketgen::layout {
namespace {

constexpr int gap_step_mm = 300, widest_gap_mm = 4000;
constexpr std::array<double, 2> ratio_steps{0.15, 0.35};  // of the zone's present share
constexpr double spare_area = 1.01;                       // over what a rule asks for
constexpr std::size_t levels_up = 3;                      // ancestors whose cut may move
constexpr std::size_t levels_balanced = 6;                // those whose halves may be weighed anew
constexpr std::size_t max_swaps = 5;

// An ancestor, and which of its children leads to the leaf.
struct Step {
  std::size_t node;
  bool first;
};

std::vector<Step> ancestors(const plan::Plan& plan, std::size_t leaf, std::size_t levels) {
  std::vector<Step> steps;
  for (std::size_t at = leaf; steps.size() < levels;) {
    const auto parent = plan::parent_of(plan, at);
    if (!parent) break;
    steps.push_back({*parent, plan.nodes[*parent].children.front() == plan.nodes[at].id});
    at = *parent;
  }
  return steps;
}

std::vector<Step> ancestors_of_fault(const RepairTask& task, std::size_t levels = levels_up) {
  const auto zone = zone_of(task);
  const auto leaf = zone ? plan::leaf_of(task.plan, task.plan.zones[*zone].id) : std::nullopt;
  return leaf ? ancestors(task.plan, *leaf, levels) : std::vector<Step>{};
}

// Four decimals are a few millimetres of the longest wall, and stay readable.
double readable_ratio(double ratio) {
  return std::round(1e4 * std::clamp(ratio, min_ratio, max_ratio)) * 1e-4;
}

void add_wider_gap(std::vector<RepairCandidate>& out,
                   const RepairTask& task,
                   const plan::Node& node,
                   int wider) {
  const int gap = node.gap_mm.value_or(plan::default_gap_mm);
  if (wider <= gap) return;
  plan::Patch patch;
  patch.set_gap = {node.id, wider};
  add_candidate(out,
                task,
                patch,
                fmt::format("widened the aisle at {} from {} to {} mm", node.id, gap, wider));
}

void add_larger_share(std::vector<RepairCandidate>& out,
                      const RepairTask& task,
                      const Step& step,
                      double times) {
  const plan::Node& node = task.plan.nodes[step.node];
  const double old = node.ratio.value_or(plan::default_split_ratio);
  const double share = (step.first ? old : 1 - old) * times;
  const double ratio = readable_ratio(step.first ? share : 1 - share);
  if (ratio == old) return;
  plan::Patch patch;
  patch.set_ratio = {node.id, ratio};
  add_candidate(out,
                task,
                patch,
                fmt::format("gave zone {} more floor: ratio of {} from {:.3f} to {:.3f}",
                            task.plan.zones[*zone_of(task)].id,
                            node.id,
                            old,
                            ratio));
}

// The floor that a zone wants: what the plan says, or what is usual.
double wanted_m2(const RepairTask& task, const plan::Zone& zone) {
  const catalog::ZoneTypeRow* type = task.catalog.zone_type(zone.type);
  const double usual = (type != nullptr ? type->share : catalog::ZoneTypeRow{}.share) *
                       plan::shell_rect(task.plan.shell).area_m2();
  return zone.area_m2.target.value_or(std::max(usual, zone.area_m2.min.value_or(0)));
}

double wanted_m2(const RepairTask& task, const plan::Node& node) {
  if (node.zone) return wanted_m2(task, *plan::find_zone(task.plan, *node.zone));
  double sum = 0;
  for (const std::string& child : node.children)
    sum += wanted_m2(task, *plan::find_node(task.plan, child));
  return sum;
}

// Divides the cut as its zones need; nothing where it is divided so, or they need nothing.
std::optional<plan::Patch> balancing(const RepairTask& task, const plan::Node& node) {
  const double first = wanted_m2(task, *plan::find_node(task.plan, node.children[0]));
  const double second = wanted_m2(task, *plan::find_node(task.plan, node.children[1]));
  if (!(first + second > 0)) return std::nullopt;
  const double ratio = readable_ratio(first / (first + second));
  if (ratio == node.ratio.value_or(plan::default_split_ratio)) return std::nullopt;
  plan::Patch patch;
  patch.set_ratio = {node.id, ratio};
  return patch;
}

void balance_below(std::vector<plan::Patch>& out, const RepairTask& task, const plan::Node& node) {
  if (node.zone) return;
  if (auto patch = balancing(task, node)) out.push_back(std::move(*patch));
  for (const std::string& child : node.children)
    balance_below(out, task, *plan::find_node(task.plan, child));
}

// Zones stand where somebody has drawn them.
bool is_drawn(const plan::Plan& plan) {
  return std::ranges::any_of(plan.provenance, [](const plan::Provenance& p) {
    return p.path == "/nodes" && p.source == plan::Source::drawing;
  });
}

// The zones that a fault is about: where it lies, what is not where its relation wants it, or what
// is refrigerated.
std::vector<std::size_t> zones_at_fault(const RepairTask& task) {
  const std::string& code = task.violation.code;
  std::vector<std::size_t> zones;
  if (const auto zone = zone_of(task)) zones.push_back(*zone);
  for (std::size_t i = 0; i < task.plan.zones.size(); ++i) {
    const plan::Zone& zone = task.plan.zones[i];
    const auto other = [&](const plan::Relation& relation) {
      return relation.a == task.violation.where &&
             (relation.b == zone.id || relation.b == zone.type);
    };
    const bool related =
        code.starts_with("RELATION_") && std::ranges::any_of(task.plan.relations, other);
    const bool scattered = code == "COLD_SCATTERED" && is_cold(zone, task.catalog);
    if ((related || scattered) && std::ranges::find(zones, i) == zones.end()) zones.push_back(i);
  }
  return zones;
}

// How far two zones are from the floor they want, once each has the other's: factors, multiplied.
double misfit(const RepairTask& task,
              const std::vector<RectMm>& rects,
              std::size_t a,
              std::size_t b) {
  const auto off = [&](std::size_t zone, std::size_t place) {
    const double wanted = std::max(0.1, wanted_m2(task, task.plan.zones[zone]));
    const double has = std::max(0.1, rects[place].area_m2());
    return std::max(wanted, has) / std::min(wanted, has);
  };
  return off(a, b) * off(b, a);
}

struct Swap {
  FaultCount faults;  // of the zones, afterwards
  double misfit = 1;
  RepairCandidate candidate;
};

std::vector<Swap> swaps_of(const RepairTask& task) {
  const std::vector<RectMm> rects = plan::zone_rectangles(task.plan);
  std::vector<Swap> swaps;
  for (const std::size_t zone : zones_at_fault(task)) {
    const plan::Zone& a = task.plan.zones[zone];
    for (std::size_t i = 0; i < task.plan.zones.size(); ++i) {
      const plan::Zone& b = task.plan.zones[i];
      if (i == zone || a.type == b.type) continue;
      plan::Patch patch;
      patch.swap_leaves = {a.id, b.id};
      auto made =
          candidate(task, {patch}, fmt::format("let zones {} and {} change places", a.id, b.id));
      if (!made) continue;
      const FaultCount faults = zone_faults(made->plan, task.catalog);
      swaps.push_back({faults, misfit(task, rects, zone, i), std::move(*made)});
    }
  }
  return swaps;
}

}  // namespace

std::vector<RepairCandidate> propose_widen_gap(const RepairTask& task) {
  std::vector<RepairCandidate> out;
  const int lacking = static_cast<int>(std::max(0.0, task.violation.limit - task.violation.value));
  const std::vector<Step> steps = ancestors_of_fault(task);
  for (const Step& step : steps) {
    const plan::Node& node = task.plan.nodes[step.node];
    const int by = std::clamp(lacking, gap_step_mm, 4 * gap_step_mm);
    add_wider_gap(
        out, task, node, std::min(widest_gap_mm, node.gap_mm.value_or(plan::default_gap_mm) + by));
  }
  // As wide as this kind of shop has them: steps do not get an aisle that is gone so far.
  const int usual = make_design(task.plan, task.catalog).profile.secondary_aisle_mm;
  for (const Step& step : steps)
    add_wider_gap(out, task, task.plan.nodes[step.node], usual);
  return out;
}

// How much is lacking is known of a zone's area; of other faults it is tried in steps.
std::vector<RepairCandidate> propose_set_ratio(const RepairTask& task) {
  std::vector<RepairCandidate> out;
  const Violation& fault = task.violation;
  if (fault.code == "ZONE_TOO_SMALL") {
    for (const Step& step : ancestors_of_fault(task, levels_balanced))
      add_larger_share(out, task, step, spare_area * fault.limit / std::max(0.1, fault.value));
    return out;
  }
  for (const double by : ratio_steps) {
    for (const Step& step : ancestors_of_fault(task))
      add_larger_share(out, task, step, 1 + by);
  }
  return out;
}

// A cut that is far off is not mended in small steps.
std::vector<RepairCandidate> propose_balance(const RepairTask& task) {
  std::vector<RepairCandidate> out;
  for (const Step& step : ancestors_of_fault(task, levels_balanced)) {
    const plan::Node& node = task.plan.nodes[step.node];
    const auto patch = balancing(task, node);
    if (!patch) continue;
    add_candidate(out,
                  task,
                  *patch,
                  fmt::format("divided {} as its zones need: ratio from {:.3f} to {:.3f}",
                              node.id,
                              node.ratio.value_or(plan::default_split_ratio),
                              patch->set_ratio->ratio));
  }
  return out;
}

// Where several cuts are far off, each alone mends nothing.
std::vector<RepairCandidate> propose_balance_part(const RepairTask& task) {
  std::vector<RepairCandidate> out;
  if (is_drawn(task.plan)) return out;
  for (const Step& step : ancestors_of_fault(task, levels_balanced)) {
    const plan::Node& node = task.plan.nodes[step.node];
    std::vector<plan::Patch> patches;
    balance_below(patches, task, node);
    if (patches.size() < 2) continue;  // propose_balance has those
    if (auto made = candidate(
            task, patches, fmt::format("divided all below {} as its zones need", node.id)))
      out.push_back(std::move(*made));
  }
  return out;
}

// First what leaves the fewest faults of zones, then what gives both the floor they want.
std::vector<RepairCandidate> propose_swap_leaves(const RepairTask& task) {
  if (is_drawn(task.plan)) return {};
  std::vector<Swap> swaps = swaps_of(task);
  std::ranges::stable_sort(swaps, [](const Swap& a, const Swap& b) {
    return a.faults != b.faults ? a.faults < b.faults : a.misfit < b.misfit;
  });
  if (swaps.size() > max_swaps) swaps.resize(max_swaps);
  std::vector<RepairCandidate> out;
  for (Swap& swap : swaps)
    out.push_back(std::move(swap.candidate));
  return out;
}

}  // namespace marketgen::layout
