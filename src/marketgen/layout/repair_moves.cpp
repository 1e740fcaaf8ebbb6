#include "layout/repair_moves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "layout/design.h"
#include "plan/bsp.h"

namespace marketgen::layout {
namespace {

constexpr int gap_step_mm = 300, widest_gap_mm = 4000;
constexpr double min_ratio = 0.08, max_ratio = 0.92;      // market-plan/1
constexpr std::array<double, 2> ratio_steps{0.15, 0.35};  // of the zone's present share
constexpr int levels_up = 3;                              // ancestors whose cut may move
constexpr std::size_t max_swaps = 5;
constexpr std::array<double, 4> door_steps{0.06, -0.06, 0.14, -0.14};  // of the wall
constexpr int shortest_run_mm = 4000;
constexpr std::size_t min_zones = 3;
constexpr double till_floor_mm = 6500;  // side of the floor a pair of lanes needs

std::string node_path(std::size_t node, std::string_view field) {
  return fmt::format("/nodes/{}/{}", node, field);
}
std::string zone_path(std::size_t zone, std::string_view field) {
  return fmt::format("/zones/{}/{}", zone, field);
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

std::optional<std::size_t> leaf_of(const plan::Plan& plan, std::string_view zone) {
  const auto leaf =
      std::ranges::find_if(plan.nodes, [&](const plan::Node& node) { return node.zone == zone; });
  return leaf == plan.nodes.end()
             ? std::nullopt
             : std::optional(static_cast<std::size_t>(leaf - plan.nodes.begin()));
}

std::optional<std::size_t> parent_of(const plan::Plan& plan, std::size_t child) {
  const std::string& id = plan.nodes[child].id;
  for (std::size_t i = 0; i < plan.nodes.size(); ++i) {
    if (std::ranges::find(plan.nodes[i].children, id) != plan.nodes[i].children.end()) return i;
  }
  return std::nullopt;
}

// An ancestor, and which of its children leads to the leaf.
struct Step {
  std::size_t node;
  bool first;
};

std::vector<Step> ancestors(const plan::Plan& plan, std::size_t leaf) {
  std::vector<Step> steps;
  for (std::size_t at = leaf; steps.size() < levels_up;) {
    const auto parent = parent_of(plan, at);
    if (!parent) break;
    steps.push_back({*parent, plan.nodes[*parent].children.front() == plan.nodes[at].id});
    at = *parent;
  }
  return steps;
}

std::vector<Step> ancestors_of_fault(const RepairTask& task) {
  const auto zone = zone_of(task);
  const auto leaf = zone ? leaf_of(task.plan, task.plan.zones[*zone].id) : std::nullopt;
  return leaf ? ancestors(task.plan, *leaf) : std::vector<Step>{};
}

std::vector<RepairCandidate> propose_widen_gap(const RepairTask& task) {
  std::vector<RepairCandidate> out;
  const int lacking = static_cast<int>(std::max(0.0, task.violation.limit - task.violation.value));
  for (const Step& step : ancestors_of_fault(task)) {
    RepairCandidate c{task.plan, {}, {node_path(step.node, "gap_mm")}};
    plan::Node& node = c.plan.nodes[step.node];
    const int gap = node.gap_mm.value_or(plan::default_gap_mm);
    const int wider =
        std::min(widest_gap_mm, gap + std::clamp(lacking, gap_step_mm, 4 * gap_step_mm));
    if (wider <= gap) continue;
    node.gap_mm = wider;
    c.change = fmt::format("widened the aisle at {} from {} to {} mm", node.id, gap, wider);
    out.push_back(std::move(c));
  }
  return out;
}

std::vector<RepairCandidate> propose_set_ratio(const RepairTask& task) {
  std::vector<RepairCandidate> out;
  const auto zone = zone_of(task);
  for (const double by : ratio_steps) {
    for (const Step& step : ancestors_of_fault(task)) {
      RepairCandidate c{task.plan, {}, {node_path(step.node, "ratio")}};
      plan::Node& node = c.plan.nodes[step.node];
      const double old = node.ratio.value_or(plan::default_split_ratio);
      const double share = (step.first ? old : 1 - old) * (1 + by);
      // Four decimals are a few millimetres of the longest wall, and stay readable.
      const double ratio =
          std::round(1e4 * std::clamp(step.first ? share : 1 - share, min_ratio, max_ratio)) * 1e-4;
      if (ratio == old) continue;
      node.ratio = ratio;
      c.change = fmt::format("gave zone {} more floor: ratio of {} from {:.3f} to {:.3f}",
                             task.plan.zones[*zone].id,
                             node.id,
                             old,
                             ratio);
      out.push_back(std::move(c));
    }
  }
  return out;
}

std::vector<RepairCandidate> propose_swap_leaves(const RepairTask& task) {
  std::vector<RepairCandidate> out;
  const auto zone = zone_of(task);
  const auto leaf = zone ? leaf_of(task.plan, task.plan.zones[*zone].id) : std::nullopt;
  if (!leaf) return out;
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
    const auto there = leaf_of(task.plan, task.plan.zones[other].id);
    if (!there) continue;
    RepairCandidate c{task.plan, {}, {node_path(*leaf, "zone"), node_path(*there, "zone")}};
    std::swap(c.plan.nodes[*leaf].zone, c.plan.nodes[*there].zone);
    c.change = fmt::format(
        "let zones {} and {} change places", task.plan.zones[*zone].id, task.plan.zones[other].id);
    out.push_back(std::move(c));
  }
  return out;
}

std::vector<RepairCandidate> propose_drop_endcaps(const RepairTask& task) {
  const auto zone = zone_of(task);
  if (!zone || task.plan.zones[*zone].fixture.endcaps == plan::Endcaps::none) return {};
  RepairCandidate c{task.plan,
                    "left out the endcaps of zone " + task.plan.zones[*zone].id,
                    {zone_path(*zone, "fixture/endcaps")}};
  c.plan.zones[*zone].fixture.endcaps = plan::Endcaps::none;
  return {c};
}

std::vector<RepairCandidate> propose_narrow_aisles(const RepairTask& task) {
  const auto zone = zone_of(task);
  if (!zone) return {};
  const int least = make_design(task.plan, task.catalog).min_aisle_mm();
  if (task.plan.zones[*zone].fixture.aisle_mm.value_or(widest_gap_mm) <= least) return {};
  RepairCandidate c{
      task.plan,
      fmt::format("let zone {} have aisles of {} mm", task.plan.zones[*zone].id, least),
      {zone_path(*zone, "fixture/aisle_mm")}};
  c.plan.zones[*zone].fixture.aisle_mm = least;
  return {c};
}

std::vector<RepairCandidate> propose_shorten_runs(const RepairTask& task) {
  const auto zone = zone_of(task);
  if (!zone) return {};
  const int longest =
      std::min(task.plan.zones[*zone].fixture.run_max_mm, static_cast<int>(task.violation.value));
  const int shorter = std::max(shortest_run_mm, longest / 2);
  if (shorter >= task.plan.zones[*zone].fixture.run_max_mm) return {};
  RepairCandidate c{
      task.plan,
      fmt::format(
          "put cross aisles into zone {}: runs of {} mm", task.plan.zones[*zone].id, shorter),
      {zone_path(*zone, "fixture/run_max_mm")}};
  c.plan.zones[*zone].fixture.run_max_mm = shorter;
  return {c};
}

std::vector<RepairCandidate> propose_move_opening(const RepairTask& task) {
  std::vector<RepairCandidate> out;
  for (std::size_t i = 0; i < task.plan.shell.openings.size(); ++i) {
    const plan::Opening& door = task.plan.shell.openings[i];
    const bool named =
        task.violation.where == door.id || task.violation.message.ends_with(" " + door.id);
    const bool exit =
        task.violation.code == "CHECKOUT_NOT_AT_EXIT" && door.kind == plan::OpeningKind::exit;
    if (!named && !exit) continue;
    for (const double step : door_steps) {
      RepairCandidate c{task.plan, {}, {fmt::format("/shell/openings/{}/center", i)}};
      const double center = std::round(1e4 * (door.center + step)) * 1e-4;
      if (center <= 0 || center >= 1) continue;
      c.plan.shell.openings[i].center = center;
      c.change = fmt::format(
          "moved door {} along its wall from {:.2f} to {:.2f}", door.id, door.center, center);
      out.push_back(std::move(c));
    }
  }
  return out;
}

std::string unused_id(const plan::Plan& plan, const std::string& wanted) {
  std::string id = wanted;
  for (int i = 2; plan::find_zone(plan, id) != nullptr || plan::find_node(plan, id) != nullptr; ++i)
    id = wanted + "-" + std::to_string(i);
  return id;
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
  const auto leaf = leaf_of(task.plan, task.plan.zones[zone].id);
  if (!leaf) return out;
  for (const plan::Axis axis : {plan::Axis::x, plan::Axis::y}) {
    const int length = axis == plan::Axis::x ? rects[zone].width() : rects[zone].depth();
    const int at = (axis == plan::Axis::x ? exit->threshold[0] - rects[zone].x0
                                          : exit->threshold[1] - rects[zone].y0);
    const bool first = at < length / 2;
    const double share = std::clamp(till_floor_mm / std::max(1, length), min_ratio, max_ratio);
    RepairCandidate c{
        task.plan, "put a checkout zone at the exit", {node_path(*leaf, "split"), "/zones"}};
    plan::Zone tills;
    tills.id = unused_id(c.plan, "checkout");
    tills.type = "checkout";
    tills.fixture.kind = "checkout_lane";
    c.plan.zones.push_back(tills);
    plan::Node rest{unused_id(c.plan, c.plan.nodes[*leaf].id + "-rest"),
                    {},
                    {},
                    {},
                    {},
                    c.plan.nodes[*leaf].zone};
    plan::Node front{
        unused_id(c.plan, c.plan.nodes[*leaf].id + "-tills"), {}, {}, {}, {}, tills.id};
    plan::Node& cut = c.plan.nodes[*leaf];
    cut.zone.reset();
    cut.split = axis;
    cut.ratio = std::round(1e4 * (first ? share : 1 - share)) * 1e-4;
    cut.gap_mm = make_design(task.plan, task.catalog).profile.main_aisle_mm;
    cut.children = first ? std::vector{front.id, rest.id} : std::vector{rest.id, front.id};
    c.plan.nodes.push_back(front);
    c.plan.nodes.push_back(rest);
    out.push_back(std::move(c));
  }
  return out;
}

bool somebody_asked_for(const plan::Plan& plan, std::size_t zone) {
  const std::string& id = plan.zones[zone].id;
  const bool related = std::ranges::any_of(plan.relations, [&](const plan::Relation& r) {
    return r.a == id || r.b == id || r.c == id || r.a == plan.zones[zone].type ||
           r.b == plan.zones[zone].type;
  });
  const bool said = std::ranges::any_of(plan.provenance, [&](const plan::Provenance& p) {
    const std::string path = "/zones/" + std::to_string(zone);
    return (p.path == path || p.path.starts_with(path + "/")) && p.source >= plan::Source::photo &&
           p.source != plan::Source::repair;
  });
  const bool changed = std::ranges::any_of(
      plan.overrides, [&](const plan::Override& o) { return o.fixture.starts_with(id + "/"); });
  return related || said || changed;
}

// Pointers into /zones and /nodes that come after the removed rows are counted anew; those into the
// rows themselves go.
void renumber(std::vector<plan::Provenance>& provenance,
              std::string_view list,
              std::size_t removed) {
  const std::string prefix = "/" + std::string(list) + "/";
  std::erase_if(provenance, [&](const plan::Provenance& p) {
    const std::string row = prefix + std::to_string(removed);
    return p.path == row || p.path.starts_with(row + "/");
  });
  for (plan::Provenance& p : provenance) {
    if (!p.path.starts_with(prefix)) continue;
    const std::size_t end = p.path.find('/', prefix.size());
    const std::string number =
        p.path.substr(prefix.size(), end == std::string::npos ? end : end - prefix.size());
    if (number.empty() || number.find_first_not_of("0123456789") != std::string::npos) continue;
    const std::size_t index = std::stoul(number);
    if (index <= removed) continue;
    p.path =
        prefix + std::to_string(index - 1) + (end == std::string::npos ? "" : p.path.substr(end));
  }
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
  const auto leaf = leaf_of(task.plan, id);
  const auto parent = leaf ? parent_of(task.plan, *leaf) : std::nullopt;
  if (!parent) return {};
  RepairCandidate c{task.plan, "left out zone " + id + ", for which there is no room", {"/zones"}};
  const plan::Node cut = c.plan.nodes[*parent];
  const std::string& sibling = cut.children[cut.children.front() == c.plan.nodes[*leaf].id ? 1 : 0];
  for (plan::Node& node : c.plan.nodes)
    std::ranges::replace(node.children, cut.id, sibling);
  std::array<std::size_t, 2> gone{std::max(*leaf, *parent), std::min(*leaf, *parent)};
  for (const std::size_t node : gone) {
    c.plan.nodes.erase(c.plan.nodes.begin() + static_cast<std::ptrdiff_t>(node));
    renumber(c.plan.provenance, "nodes", node);
  }
  c.plan.zones.erase(c.plan.zones.begin() + static_cast<std::ptrdiff_t>(*zone));
  renumber(c.plan.provenance, "zones", *zone);
  return {c};
}

}  // namespace

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
