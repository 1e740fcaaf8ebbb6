#include <algorithm>
#include <set>

#include "plan/plan.h"

namespace marketgen::plan {

std::size_t root_of(const Plan& plan) {
  std::set<std::string_view> children;
  for (const Node& node : plan.nodes)
    children.insert(node.children.begin(), node.children.end());
  const auto root = std::ranges::find_if(
      plan.nodes, [&](const Node& node) { return !children.contains(node.id); });
  return static_cast<std::size_t>(root - plan.nodes.begin());
}

const Node* find_node(const Plan& plan, std::string_view id) {
  const auto found = std::ranges::find(plan.nodes, id, &Node::id);
  return found == plan.nodes.end() ? nullptr : &*found;
}

const Zone* find_zone(const Plan& plan, std::string_view id) {
  const auto found = std::ranges::find(plan.zones, id, &Zone::id);
  return found == plan.zones.end() ? nullptr : &*found;
}

PolygonMm floor_of(const Shell& shell) {
  return shell.outline_mm.value_or(polygon_of({0, 0, shell.width_mm, shell.depth_mm}));
}

RectMm footprint_of(const Column& column) {
  const int x0 = column.x_mm - column.size_mm / 2, y0 = column.y_mm - column.size_mm / 2;
  return {x0, y0, x0 + column.size_mm, y0 + column.size_mm};
}

}  // namespace marketgen::plan
