// Operations on the tree: cuts, and where zones lie.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "plan/bsp.h"
#include "plan/patch_change.h"
#include "plan/plan_edit.h"
#include "plan/validation.h"

namespace marketgen::plan {
namespace {

constexpr double min_share = 0.08, max_own_share = 0.6;  // of a moved zone that says no share

Result<std::size_t> named_cut(const PlanChange& task, const std::string& id) {
  std::vector<std::string_view> cuts;
  for (std::size_t i = 0; i < task.plan.nodes.size(); ++i) {
    const Node& node = task.plan.nodes[i];
    if (!node.split) continue;
    if (node.id == id) return i;
    cuts.push_back(node.id);
  }
  if (find_node(task.plan, id) != nullptr) {
    return Error{
        "plan.bad_value",
        task.at("node"),
        "\"" + id + "\" is a leaf of the tree, which cuts nothing; name the node above it"};
  }
  return catalog::unknown_name("plan.unknown_reference", task.at("node"), "inner node", id, cuts);
}

// A zone's leaf, or a node.
Result<std::size_t> named_ground(const PlanChange& task, const std::string& id) {
  if (const auto leaf = leaf_of(task.plan, id)) return *leaf;
  if (const auto node = node_index(task.plan, id)) return *node;
  std::vector<std::string_view> known;
  for (const Zone& zone : task.plan.zones)
    known.push_back(zone.id);
  for (const Node& node : task.plan.nodes)
    known.push_back(node.id);
  return catalog::unknown_name(
      "plan.unknown_reference", task.at("beside"), "zone or node", id, known);
}

int usual_gap_mm(const PlanChange& task) {
  const catalog::ProfileRow* profile = task.catalog.profile(task.plan.profile);
  return (profile != nullptr ? *profile : catalog::ProfileRow{}).main_aisle_mm;
}

double rounded(double share) {
  return std::round(1e4 * share) * 1e-4;  // a few millimetres of the longest wall
}

// The ratio of a cut whose part on that side gets this share.
double ratio_of(Wall side, double share) {
  const bool first = side == Wall::west || side == Wall::south;
  return rounded(first ? share : 1 - share);
}

double area_of_node(const Plan& plan, std::size_t node) {
  for (const NodeRect& placed : node_rectangles(plan)) {
    if (placed.node == node) return placed.rect.area_m2();
  }
  return 0;
}

std::string node_pointer(const Plan& plan, std::string_view id, std::string_view field) {
  return element_pointer("nodes", node_index(plan, id).value_or(0), field);
}

// Relations, overrides and shelves that name a zone which is no longer there go with it.
void drop_references(Plan& plan, const Zone& gone) {
  const bool last_of_type = std::ranges::none_of(
      plan.zones, [&](const Zone& zone) { return zone.type == gone.type || zone.id == gone.type; });
  const auto names_it = [&](const std::string& name) {
    return name == gone.id || (last_of_type && name == gone.type);
  };
  std::erase_if(plan.relations, [&](const Relation& r) {
    return names_it(r.a) || names_it(r.b) || (r.c && names_it(*r.c));
  });
  std::erase_if(plan.overrides,
                [&](const Override& o) { return o.fixture.starts_with(gone.id + "/"); });
  if (!plan.planogram) return;
  std::erase_if(*plan.planogram,
                [&](const StockedShelf& s) { return s.fixture.starts_with(gone.id + "/"); });
  if (plan.planogram->empty()) plan.planogram.reset();
}

void leave_out(PlanChange& task, std::size_t leaf, std::size_t zone) {
  const Zone gone = task.plan.zones[zone];
  take_out_leaf(task.plan, leaf);
  erase_zone(task.plan, zone);
  drop_references(task.plan, gone);
  task.paths.emplace_back("/zones");
}

// A new zone on one side of `target`.
void put_new_zone(
    PlanChange& task, std::size_t target, Zone zone, Wall side, double share, int gap_mm) {
  Node cut, leaf;
  cut.id = unused_id(task.plan, zone.id + "-cut");
  cut.ratio = ratio_of(side, share);
  cut.gap_mm = gap_mm;
  leaf.id = unused_id(task.plan, zone.id + "-leaf");
  leaf.zone = zone.id;
  const std::string cut_id = cut.id;
  put_beside(task.plan, target, std::move(cut), std::move(leaf), side);
  task.plan.zones.push_back(std::move(zone));
  task.paths.push_back(element_pointer("zones", task.plan.zones.size() - 1));
  task.paths.push_back(node_pointer(task.plan, cut_id, "split"));
}

Result<void> require_another(const PlanChange& task,
                             std::string_view field,
                             const std::string& a,
                             const std::string& b) {
  if (a != b) return {};
  return Error{"plan.bad_value", task.at(field), "\"" + b + "\" is named twice; name two zones"};
}

}  // namespace

Result<void> change(PlanChange& task, const SetRatio& patch) {
  MARKETGEN_TRY(const std::size_t node, named_cut(task, patch.node));
  task.plan.nodes[node].ratio = patch.ratio;
  task.paths.push_back(element_pointer("nodes", node, "ratio"));
  return {};
}

Result<void> change(PlanChange& task, const SetAxis& patch) {
  MARKETGEN_TRY(const std::size_t node, named_cut(task, patch.node));
  task.plan.nodes[node].split = patch.split;
  task.paths.push_back(element_pointer("nodes", node, "split"));
  return {};
}

Result<void> change(PlanChange& task, const SetGap& patch) {
  MARKETGEN_TRY(const std::size_t node, named_cut(task, patch.node));
  task.plan.nodes[node].gap_mm = patch.gap_mm;
  task.paths.push_back(element_pointer("nodes", node, "gap_mm"));
  return {};
}

Result<void> change(PlanChange& task, const SwapLeaves& patch) {
  MARKETGEN_CHECK(require_another(task, "b", patch.a, patch.b));
  MARKETGEN_CHECK(named_zone(task, "a", patch.a));
  MARKETGEN_CHECK(named_zone(task, "b", patch.b));
  const auto a = leaf_of(task.plan, patch.a), b = leaf_of(task.plan, patch.b);
  if (!a || !b) return Error{"plan.bad_tree", task.where, "one of the zones has no leaf"};
  std::swap(task.plan.nodes[*a].zone, task.plan.nodes[*b].zone);
  task.paths.push_back(element_pointer("nodes", *a, "zone"));
  task.paths.push_back(element_pointer("nodes", *b, "zone"));
  return {};
}

Result<void> change(PlanChange& task, const MoveLeaf& patch) {
  MARKETGEN_CHECK(named_zone(task, "zone", patch.zone));
  MARKETGEN_TRY(const std::size_t ground, named_ground(task, patch.beside));
  const auto leaf = leaf_of(task.plan, patch.zone);
  const auto parent = leaf ? parent_of(task.plan, *leaf) : std::nullopt;
  if (!parent || ground == *leaf) {
    return Error{"plan.bad_value",
                 task.at("beside"),
                 "zone \"" + patch.zone + "\" cannot stand beside itself; name another zone"};
  }
  const double area_m2 = area_of_node(task.plan, *leaf);
  // The cut above goes with the zone: what was cut off with it stands there instead.
  const std::vector<std::string>& halves = task.plan.nodes[*parent].children;
  const std::string target = ground == *parent
                                 ? halves[halves.front() == task.plan.nodes[*leaf].id ? 1 : 0]
                                 : task.plan.nodes[ground].id;
  Node moved = task.plan.nodes[*leaf];
  Node cut = take_out_leaf(task.plan, *leaf);
  const std::size_t beside = *node_index(task.plan, target);
  const double room_m2 = std::max(area_of_node(task.plan, beside), 1e-6);
  const double own = std::clamp(area_m2 / room_m2, min_share, max_own_share);
  cut.ratio = ratio_of(patch.side, patch.share.value_or(own));
  if (patch.gap_mm) cut.gap_mm = patch.gap_mm;
  const std::string cut_id = cut.id;
  put_beside(task.plan, beside, std::move(cut), std::move(moved), patch.side);
  task.paths.push_back(node_pointer(task.plan, cut_id, "split"));
  task.paths.push_back(node_pointer(task.plan, cut_id, "ratio"));
  return {};
}

Result<void> change(PlanChange& task, const SplitLeaf& patch) {
  MARKETGEN_TRY(const std::size_t zone, named_zone(task, "zone", patch.zone));
  const auto leaf = leaf_of(task.plan, patch.zone);
  if (!leaf) return Error{"plan.bad_tree", task.at("zone"), "the zone has no leaf"};
  Zone part = task.plan.zones[zone];
  part.id = patch.part;
  put_new_zone(task,
               *leaf,
               std::move(part),
               patch.side,
               patch.share,
               patch.gap_mm.value_or(usual_gap_mm(task)));
  return {};
}

Result<void> change(PlanChange& task, const Merge& patch) {
  MARKETGEN_CHECK(require_another(task, "into", patch.zone, patch.into));
  MARKETGEN_TRY(const std::size_t zone, named_zone(task, "zone", patch.zone));
  MARKETGEN_CHECK(named_zone(task, "into", patch.into));
  const auto leaf = leaf_of(task.plan, patch.zone), into = leaf_of(task.plan, patch.into);
  const auto above = leaf ? parent_of(task.plan, *leaf) : std::nullopt;
  if (!above || !into || parent_of(task.plan, *into) != above) {
    return Error{"plan.bad_value",
                 task.at("into"),
                 "zones \"" + patch.zone + "\" and \"" + patch.into +
                     "\" are not the two halves of one cut; drop_zone leaves \"" + patch.zone +
                     "\" out wherever it lies"};
  }
  leave_out(task, *leaf, zone);
  return {};
}

Result<void> change(PlanChange& task, const AddZone& patch) {
  MARKETGEN_TRY(const std::size_t beside, named_ground(task, patch.beside));
  if (find_zone(task.plan, patch.zone.id) != nullptr) {
    return Error{"plan.duplicate_id",
                 task.at("zone/id"),
                 "there is a zone \"" + patch.zone.id + "\" already; \"" +
                     unused_id(task.plan, patch.zone.id) + "\" is free"};
  }
  put_new_zone(
      task, beside, patch.zone, patch.side, patch.share, patch.gap_mm.value_or(usual_gap_mm(task)));
  return {};
}

Result<void> change(PlanChange& task, const DropZone& patch) {
  MARKETGEN_TRY(const std::size_t zone, named_zone(task, "zone", patch.zone));
  const auto leaf = leaf_of(task.plan, patch.zone);
  if (!leaf || !parent_of(task.plan, *leaf)) {
    return Error{"plan.bad_value",
                 task.at("zone"),
                 "\"" + patch.zone + "\" is the only zone; a store has at least one"};
  }
  leave_out(task, *leaf, zone);
  return {};
}

}  // namespace marketgen::plan
