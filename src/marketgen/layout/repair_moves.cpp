#include "layout/repair_moves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "layout/design.h"
#include "plan/bsp.h"
#include "plan/patch.h"
#include "plan/plan_edit.h"

namespace marketgen::layout {
namespace {

constexpr int gap_step_mm = 300, widest_gap_mm = 4000;
constexpr double min_ratio = 0.08, max_ratio = 0.92;      // market-plan/1
constexpr std::array<double, 2> ratio_steps{0.15, 0.35};  // of the zone's present share
constexpr std::size_t levels_up = 3;                      // ancestors whose cut may move
constexpr std::size_t levels_balanced = 6;                // those whose halves may be weighed anew
constexpr std::size_t max_swaps = 5;
constexpr std::array<double, 4> door_steps{0.06, -0.06, 0.14, -0.14};  // of the wall
constexpr int shortest_run_mm = 4000;
constexpr std::size_t min_zones = 3;
constexpr double till_floor_mm = 6500;  // side of the floor a pair of lanes needs

// The plan with that patch: repairs change plans as edits do.
void add_candidate(std::vector<RepairCandidate>& out,
                   const RepairTask& task,
                   const plan::Patch& patch,
                   std::string change) {
  Result<plan::Patched> patched = plan::patched(task.plan, patch, task.catalog, "repair");
  if (!patched.ok()) return;
  out.push_back({std::move(patched->plan), std::move(change), std::move(patched->paths)});
}

// The zone that the fault lies in: ids of fixtures, runs and aisles begin with it.
std::optional<std::size_t> zone_of(const RepairTask& task) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < task.plan.zones.size(); ++i) {
    const std::string& id = task.plan.zones[i].id;
    const std::string& where = task.violation.where;
    const bool within =
        where == id ||
        (where.size() > id.size() && where.starts_with(id) && where[id.size()] == '/') ||
        (where == task.plan.zones[i].type);
    if (within && (!best || id.size() > task.plan.zones[*best].id.size())) best = i;
  }
  return best;
}

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

// A person, in words, by a flag or with a picture: the value at `path`, or what lies below it.
bool somebody_said(const plan::Plan& plan, const std::string& path) {
  return std::ranges::any_of(plan.provenance, [&](const plan::Provenance& p) {
    return (p.path == path || p.path.starts_with(path + "/")) && p.source >= plan::Source::photo &&
           p.source != plan::Source::repair;
  });
}

std::vector<RepairCandidate> propose_widen_gap(const RepairTask& task) {
  std::vector<RepairCandidate> out;
  const int lacking = static_cast<int>(std::max(0.0, task.violation.limit - task.violation.value));
  for (const Step& step : ancestors_of_fault(task)) {
    const plan::Node& node = task.plan.nodes[step.node];
    const int gap = node.gap_mm.value_or(plan::default_gap_mm);
    const int wider =
        std::min(widest_gap_mm, gap + std::clamp(lacking, gap_step_mm, 4 * gap_step_mm));
    if (wider <= gap) continue;
    plan::Patch patch;
    patch.set_gap = {node.id, wider};
    add_candidate(out,
                  task,
                  patch,
                  fmt::format("widened the aisle at {} from {} to {} mm", node.id, gap, wider));
  }
  return out;
}

std::vector<RepairCandidate> propose_set_ratio(const RepairTask& task) {
  std::vector<RepairCandidate> out;
  const auto zone = zone_of(task);
  for (const double by : ratio_steps) {
    for (const Step& step : ancestors_of_fault(task)) {
      const plan::Node& node = task.plan.nodes[step.node];
      const double old = node.ratio.value_or(plan::default_split_ratio);
      const double share = (step.first ? old : 1 - old) * (1 + by);
      // Four decimals are a few millimetres of the longest wall, and stay readable.
      const double ratio =
          std::round(1e4 * std::clamp(step.first ? share : 1 - share, min_ratio, max_ratio)) * 1e-4;
      if (ratio == old) continue;
      plan::Patch patch;
      patch.set_ratio = {node.id, ratio};
      add_candidate(out,
                    task,
                    patch,
                    fmt::format("gave zone {} more floor: ratio of {} from {:.3f} to {:.3f}",
                                task.plan.zones[*zone].id,
                                node.id,
                                old,
                                ratio));
    }
  }
  return out;
}

// The floor that the zones under a node want: what the plan says, or what is usual.
double wanted_m2(const RepairTask& task, const plan::Node& node) {
  if (!node.zone) {
    double sum = 0;
    for (const std::string& child : node.children)
      sum += wanted_m2(task, *plan::find_node(task.plan, child));
    return sum;
  }
  const plan::Zone& zone = *plan::find_zone(task.plan, *node.zone);
  const catalog::ZoneTypeRow* type = task.catalog.zone_type(zone.type);
  const double usual = (type != nullptr ? type->share : catalog::ZoneTypeRow{}.share) *
                       plan::shell_rect(task.plan.shell).area_m2();
  return zone.area_m2.target.value_or(std::max(usual, zone.area_m2.min.value_or(0)));
}

// A cut that is far off is not mended in small steps.
std::vector<RepairCandidate> propose_balance(const RepairTask& task) {
  std::vector<RepairCandidate> out;
  for (const Step& step : ancestors_of_fault(task, levels_balanced)) {
    const plan::Node& node = task.plan.nodes[step.node];
    const double first = wanted_m2(task, *plan::find_node(task.plan, node.children[0]));
    const double second = wanted_m2(task, *plan::find_node(task.plan, node.children[1]));
    const double old = node.ratio.value_or(plan::default_split_ratio);
    const double ratio =
        std::round(1e4 * std::clamp(first / (first + second), min_ratio, max_ratio)) * 1e-4;
    if (!(first + second > 0) || ratio == old) continue;
    plan::Patch patch;
    patch.set_ratio = {node.id, ratio};
    add_candidate(
        out,
        task,
        patch,
        fmt::format(
            "divided {} as its zones need: ratio from {:.3f} to {:.3f}", node.id, old, ratio));
  }
  return out;
}

// Zones stand where somebody has drawn them.
bool is_drawn(const plan::Plan& plan) {
  return std::ranges::any_of(plan.provenance, [](const plan::Provenance& p) {
    return p.path == "/nodes" && p.source == plan::Source::drawing;
  });
}

std::vector<RepairCandidate> propose_swap_leaves(const RepairTask& task) {
  std::vector<RepairCandidate> out;
  const auto zone = zone_of(task);
  if (!zone || is_drawn(task.plan)) return out;
  const std::vector<RectMm> rects = plan::zone_rectangles(task.plan);
  // Zones of like size change places with the least harm.
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < task.plan.zones.size(); ++i) {
    if (i != *zone && task.plan.zones[i].type != task.plan.zones[*zone].type) others.push_back(i);
  }
  const auto unlike = [&](std::size_t i) {
    const double a = rects[i].area_m2(), b = rects[*zone].area_m2();
    return std::max(a, b) / std::max(0.1, std::min(a, b));
  };
  std::ranges::stable_sort(others, {}, unlike);
  if (others.size() > max_swaps) others.resize(max_swaps);
  for (const std::size_t other : others) {
    plan::Patch patch;
    patch.swap_leaves = {task.plan.zones[*zone].id, task.plan.zones[other].id};
    add_candidate(out,
                  task,
                  patch,
                  fmt::format("let zones {} and {} change places",
                              task.plan.zones[*zone].id,
                              task.plan.zones[other].id));
  }
  return out;
}

std::vector<RepairCandidate> propose_drop_endcaps(const RepairTask& task) {
  const auto zone = zone_of(task);
  if (!zone || task.plan.zones[*zone].fixture.endcaps == plan::Endcaps::none) return {};
  std::vector<RepairCandidate> out;
  plan::Patch patch;
  patch.set_fixture.emplace().zone = task.plan.zones[*zone].id;
  patch.set_fixture->endcaps = plan::Endcaps::none;
  add_candidate(out, task, patch, "left out the endcaps of zone " + task.plan.zones[*zone].id);
  return out;
}

std::vector<RepairCandidate> propose_narrow_aisles(const RepairTask& task) {
  const auto zone = zone_of(task);
  if (!zone) return {};
  const int least = make_design(task.plan, task.catalog).min_aisle_mm();
  if (task.plan.zones[*zone].fixture.aisle_mm.value_or(widest_gap_mm) <= least) return {};
  std::vector<RepairCandidate> out;
  plan::Patch patch;
  patch.set_fixture.emplace().zone = task.plan.zones[*zone].id;
  patch.set_fixture->aisle_mm = least;
  add_candidate(out,
                task,
                patch,
                fmt::format("let zone {} have aisles of {} mm", task.plan.zones[*zone].id, least));
  return out;
}

// As wide as the rule wants them, where nobody said how wide they shall be.
std::vector<RepairCandidate> propose_widen_aisles(const RepairTask& task) {
  const auto zone = zone_of(task);
  if (!zone || !task.plan.zones[*zone].fixture.aisle_mm) return {};
  const int now = *task.plan.zones[*zone].fixture.aisle_mm;
  const int wide = static_cast<int>(std::ceil(task.violation.limit));
  const std::string path = fmt::format("/zones/{}/fixture/aisle_mm", *zone);
  if (now >= wide || somebody_said(task.plan, path)) return {};
  std::vector<RepairCandidate> out;
  plan::Patch patch;
  patch.set_fixture.emplace().zone = task.plan.zones[*zone].id;
  patch.set_fixture->aisle_mm = wide;
  add_candidate(
      out,
      task,
      patch,
      fmt::format(
          "widened the aisles of zone {} from {} to {} mm", task.plan.zones[*zone].id, now, wide));
  return out;
}

std::vector<RepairCandidate> propose_shorten_runs(const RepairTask& task) {
  const auto zone = zone_of(task);
  if (!zone) return {};
  const int longest =
      std::min(task.plan.zones[*zone].fixture.run_max_mm, static_cast<int>(task.violation.value));
  const int shorter = std::max(shortest_run_mm, longest / 2);
  if (shorter >= task.plan.zones[*zone].fixture.run_max_mm) return {};
  std::vector<RepairCandidate> out;
  plan::Patch patch;
  patch.set_fixture.emplace().zone = task.plan.zones[*zone].id;
  patch.set_fixture->run_max_mm = shorter;
  add_candidate(
      out,
      task,
      patch,
      fmt::format(
          "put cross aisles into zone {}: runs of {} mm", task.plan.zones[*zone].id, shorter));
  return out;
}

std::vector<RepairCandidate> propose_move_opening(const RepairTask& task) {
  std::vector<RepairCandidate> out;
  for (const plan::Opening& door : task.plan.shell.openings) {
    const bool named =
        task.violation.where == door.id || task.violation.message.ends_with(" " + door.id);
    const bool exit =
        task.violation.code == "CHECKOUT_NOT_AT_EXIT" && door.kind == plan::OpeningKind::exit;
    if (!named && !exit) continue;
    for (const double step : door_steps) {
      const double center = std::round(1e4 * (door.center + step)) * 1e-4;
      if (center <= 0 || center >= 1) continue;
      plan::Patch patch;
      patch.move_opening.emplace().opening = door.id;
      patch.move_opening->center = center;
      add_candidate(
          out,
          task,
          patch,
          fmt::format(
              "moved door {} along its wall from {:.2f} to {:.2f}", door.id, door.center, center));
    }
  }
  return out;
}

// Cuts a part for tills off the leaf at the exit.
std::vector<RepairCandidate> propose_add_checkout(const RepairTask& task) {
  std::vector<RepairCandidate> out;
  const Floor floor = make_floor(task.plan.shell);
  const Doorway* exit = exit_of(floor, task.plan.shell);
  if (exit == nullptr) return out;
  const std::vector<RectMm> rects = plan::zone_rectangles(task.plan);
  std::size_t zone = 0;
  for (std::size_t i = 0; i < rects.size(); ++i) {
    if (rects[i].contains(exit->approach.center())) zone = i;
  }
  for (const plan::Axis axis : {plan::Axis::x, plan::Axis::y}) {
    const int length = axis == plan::Axis::x ? rects[zone].width() : rects[zone].depth();
    const int at = (axis == plan::Axis::x ? exit->threshold[0] - rects[zone].x0
                                          : exit->threshold[1] - rects[zone].y0);
    const bool first = at < length / 2;
    plan::Patch patch;
    plan::AddZone& tills = patch.add_zone.emplace();
    tills.zone.id = plan::unused_id(task.plan, "checkout");
    tills.zone.type = "checkout";
    tills.zone.fixture.kind = "checkout_lane";
    tills.beside = task.plan.zones[zone].id;
    tills.side = axis == plan::Axis::x ? (first ? plan::Wall::west : plan::Wall::east)
                                       : (first ? plan::Wall::south : plan::Wall::north);
    tills.share = std::clamp(till_floor_mm / std::max(1, length), min_ratio, max_ratio);
    add_candidate(out, task, patch, "put a checkout zone at the exit");
  }
  return out;
}

bool somebody_asked_for(const plan::Plan& plan, std::size_t zone) {
  const std::string& id = plan.zones[zone].id;
  const bool related = std::ranges::any_of(plan.relations, [&](const plan::Relation& r) {
    return r.a == id || r.b == id || r.c == id || r.a == plan.zones[zone].type ||
           r.b == plan.zones[zone].type;
  });
  const bool said = somebody_said(plan, "/zones/" + std::to_string(zone));
  const bool changed = std::ranges::any_of(
      plan.overrides, [&](const plan::Override& o) { return o.fixture.starts_with(id + "/"); });
  return related || said || changed;
}

bool holds_tills(const plan::Zone& zone, const catalog::Catalog& catalog) {
  const catalog::FixtureKind* kind = catalog.fixture_kind(zone.fixture.kind);
  return kind != nullptr && kind->role == catalog::FixtureRole::checkout;
}

// Never the place to pay.
std::vector<RepairCandidate> propose_drop_zone(const RepairTask& task) {
  const auto zone = zone_of(task);
  if (!zone || task.plan.zones.size() <= min_zones || somebody_asked_for(task.plan, *zone))
    return {};
  if (holds_tills(task.plan.zones[*zone], task.catalog)) return {};
  const std::string id = task.plan.zones[*zone].id;
  std::vector<RepairCandidate> out;
  plan::Patch patch;
  patch.drop_zone = {id};
  add_candidate(out, task, patch, "left out zone " + id + ", for which there is no room");
  return out;
}

}  // namespace

std::string_view words_of(RepairMove move) {
  switch (move) {
#define REPAIR_MOVE(name, what) \
  case RepairMove::name:        \
    return what;
#include "layout/repair_moves.inc"
#undef REPAIR_MOVE
  }
  return {};
}

std::vector<RepairCandidate> propose(RepairMove move, const RepairTask& task) {
  switch (move) {
#define REPAIR_MOVE(name, what) \
  case RepairMove::name:        \
    return propose_##name(task);
#include "layout/repair_moves.inc"
#undef REPAIR_MOVE
  }
  return {};
}

}  // namespace marketgen::layout
