#include <algorithm>
#include <map>
#include <set>

#include "base/text.h"
#include "plan/bsp.h"
#include "plan/validation.h"

namespace marketgen::plan {
namespace {

Error tree_fault(const PlanCheck& check,
                 std::size_t node,
                 std::string_view field,
                 std::string message) {
  return {"plan.bad_tree", check.at(element_pointer("nodes", node, field)), std::move(message)};
}

Error unknown_part(const PlanCheck& check,
                   const std::string& pointer,
                   std::string_view what,
                   const std::string& name,
                   const std::vector<std::string_view>& known) {
  return catalog::unknown_name("plan.unknown_reference", check.at(pointer), what, name, known);
}

Result<void> check_leaf(const PlanCheck& check, std::size_t i) {
  const Node& node = check.plan.nodes[i];
  if (!node.zone) {
    return tree_fault(check,
                      i,
                      "",
                      "the node has neither a split nor a zone; an inner node needs "
                      "split and two children, a leaf needs zone");
  }
  if (!node.children.empty()) {
    return tree_fault(check, i, "split", "a node with children needs split: \"x\" or \"y\"");
  }
  if (node.ratio || node.gap_mm) {
    return tree_fault(check,
                      i,
                      node.ratio ? "ratio" : "gap_mm",
                      "a leaf is not cut; take the field out, or give the node split and children");
  }
  return {};
}

Result<void> check_inner(const PlanCheck& check, std::size_t i) {
  const Node& node = check.plan.nodes[i];
  if (node.zone) {
    return tree_fault(check, i, "zone", "a node is cut or holds a zone, not both");
  }
  if (node.children.size() != 2) {
    return tree_fault(
        check,
        i,
        "children",
        "an inner node has exactly two children, not " + std::to_string(node.children.size()));
  }
  return {};
}

Result<void> check_node_shapes(const PlanCheck& check) {
  for (std::size_t i = 0; i < check.plan.nodes.size(); ++i) {
    const Node& node = check.plan.nodes[i];
    const bool leaf = !node.split;
    if (leaf && !node.zone && !node.children.empty()) {
      return tree_fault(check, i, "split", "a node with children needs split: \"x\" or \"y\"");
    }
    MARKETGEN_CHECK(leaf ? check_leaf(check, i) : check_inner(check, i));
  }
  return {};
}

// Every child exists and has one parent.
Result<void> check_children(const PlanCheck& check) {
  std::vector<std::string_view> ids;
  for (const Node& node : check.plan.nodes)
    ids.push_back(node.id);
  std::map<std::string_view, std::string_view> parents;
  for (std::size_t i = 0; i < check.plan.nodes.size(); ++i) {
    const Node& node = check.plan.nodes[i];
    for (std::size_t k = 0; k < node.children.size(); ++k) {
      const std::string& child = node.children[k];
      const std::string pointer = element_pointer("nodes", i, "children/" + std::to_string(k));
      if (std::ranges::find(ids, child) == ids.end()) {
        return unknown_part(check, pointer, "node", child, ids);
      }
      const auto [parent, fresh] = parents.try_emplace(child, node.id);
      if (!fresh) {
        return Error{"plan.overlapping_nodes",
                     check.at(pointer),
                     "the node \"" + child + "\" is already a child of \"" +
                         std::string(parent->second) + "\"; a node has one place in the tree"};
      }
    }
  }
  return {};
}

// With one parent at most for each node, what the root does not reach is a cycle or another tree.
Result<void> check_one_tree(const PlanCheck& check) {
  const std::vector<Node>& nodes = check.plan.nodes;
  if (nodes.empty()) {
    return Error{"plan.bad_tree", check.at("/nodes"), "the plan has no nodes; a shop needs a root"};
  }
  std::set<std::string_view> children;
  for (const Node& node : nodes)
    children.insert(node.children.begin(), node.children.end());
  std::vector<std::size_t> roots;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!children.contains(nodes[i].id)) roots.push_back(i);
  }
  if (roots.size() > 1) {
    return tree_fault(check,
                      roots[1],
                      "",
                      "\"" + nodes[roots[0]].id + "\" and \"" + nodes[roots[1]].id +
                          "\" are both nobody's child; there is one root");
  }
  if (roots.empty()) {
    return Error{"plan.cyclic_tree",
                 check.at("/nodes"),
                 "every node is a child of another; the root must be nobody's child"};
  }
  const std::size_t reached = node_rectangles(check.plan).size();
  if (reached == nodes.size()) return {};
  return Error{"plan.cyclic_tree",
               check.at("/nodes"),
               std::to_string(nodes.size() - reached) + " of " + std::to_string(nodes.size()) +
                   " nodes cannot be reached from the root \"" + nodes[roots[0]].id +
                   "\"; they are children of one another"};
}

Result<void> check_size(const PlanCheck& check) {
  int leaves = 0;
  for (const NodeRect& placed : node_rectangles(check.plan)) {
    if (placed.depth > max_bsp_depth) {
      return Error{"plan.too_deep",
                   check.at(element_pointer("nodes", placed.node)),
                   "the node lies under " + std::to_string(placed.depth) + " cuts; at most " +
                       std::to_string(max_bsp_depth) + " are allowed"};
    }
    leaves += check.plan.nodes[placed.node].split ? 0 : 1;
  }
  if (leaves <= max_bsp_leaves) return {};
  return Error{"plan.too_deep",
               check.at("/nodes"),
               "the tree has " + std::to_string(leaves) + " leaves; at most " +
                   std::to_string(max_bsp_leaves) + " are allowed"};
}

// Each zone stands in exactly one leaf.
Result<void> check_zones_placed(const PlanCheck& check) {
  std::vector<std::string_view> ids;
  for (const Zone& zone : check.plan.zones)
    ids.push_back(zone.id);
  std::map<std::string_view, std::string_view> leaves;
  for (std::size_t i = 0; i < check.plan.nodes.size(); ++i) {
    const Node& node = check.plan.nodes[i];
    if (!node.zone) continue;
    const std::string pointer = element_pointer("nodes", i, "zone");
    if (std::ranges::find(ids, *node.zone) == ids.end()) {
      return unknown_part(check, pointer, "zone", *node.zone, ids);
    }
    const auto [leaf, fresh] = leaves.try_emplace(*node.zone, node.id);
    if (!fresh) {
      return Error{"plan.overlapping_nodes",
                   check.at(pointer),
                   "the zone \"" + *node.zone + "\" already stands in \"" +
                       std::string(leaf->second) + "\"; a zone has one place in the tree"};
    }
  }
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (leaves.contains(ids[i])) continue;
    return Error{"plan.bad_tree",
                 check.at(element_pointer("zones", i)),
                 "the zone \"" + std::string(ids[i]) +
                     "\" stands in no leaf; give it a node or take it out"};
  }
  return {};
}

}  // namespace

Result<void> check_tree(const PlanCheck& check) {
  using Part = Result<void> (*)(const PlanCheck&);
  constexpr Part parts[] = {
      check_node_shapes, check_children, check_one_tree, check_size, check_zones_placed};
  for (const Part part : parts)
    MARKETGEN_CHECK(part(check));
  return {};
}

Result<void> check_room(const PlanCheck& check) {
  for (const NodeRect& placed : node_rectangles(check.plan)) {
    const Node& node = check.plan.nodes[placed.node];
    if (!node.split) continue;
    for (const RectMm& part : split_rect(placed.rect, node)) {
      const int side = *node.split == Axis::y ? part.depth() : part.width();
      if (side >= min_node_side_mm) continue;
      return Error{"plan.bad_value",
                   check.at(element_pointer("nodes", placed.node, "ratio")),
                   "a child would be " + with_thousands(side) + " mm " +
                       (*node.split == Axis::y ? "deep" : "wide") + "; at least " +
                       with_thousands(min_node_side_mm) +
                       " mm are needed: change ratio or gap_mm, or take a cut out"};
    }
  }
  return {};
}

}  // namespace marketgen::plan
