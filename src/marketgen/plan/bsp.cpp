#include "plan/bsp.h"

#include <algorithm>

namespace marketgen::plan {
namespace {

std::size_t index_of(const Plan& plan, std::string_view id) {
  const auto found = std::ranges::find(plan.nodes, id, &Node::id);
  return static_cast<std::size_t>(found - plan.nodes.begin());
}

}  // namespace

RectMm shell_rect(const Shell& shell) {
  return {0, 0, shell.width_mm, shell.depth_mm};
}

std::array<RectMm, 2> split_rect(const RectMm& rect, const Node& node) {
  const bool across_y = *node.split == Axis::y;
  const int low = across_y ? rect.y0 : rect.x0;
  const int high = across_y ? rect.y1 : rect.x1;
  const int gap = node.gap_mm.value_or(default_gap_mm);
  const int room = std::max(0, high - low - gap);
  const double share = node.ratio.value_or(default_split_ratio) * room;
  const int cut = low + static_cast<int>(share + 0.5);
  const int resume = std::min(high, cut + gap);
  std::array<RectMm, 2> parts{rect, rect};
  (across_y ? parts[0].y1 : parts[0].x1) = cut;
  (across_y ? parts[1].y0 : parts[1].x0) = resume;
  return parts;
}

std::vector<NodeRect> node_rectangles(const Plan& plan) {
  std::vector<NodeRect> pending{{root_of(plan), shell_rect(plan.shell), 0}};
  std::vector<NodeRect> done;
  while (!pending.empty()) {
    const NodeRect next = pending.back();
    pending.pop_back();
    done.push_back(next);
    const Node& node = plan.nodes[next.node];
    if (!node.split) continue;
    const std::array<RectMm, 2> parts = split_rect(next.rect, node);
    for (const std::size_t child :
         {std::size_t{1}, std::size_t{0}}) {  // a stack: the first child comes off first
      pending.push_back({index_of(plan, node.children[child]), parts[child], next.depth + 1});
    }
  }
  return done;
}

std::vector<RectMm> zone_rectangles(const Plan& plan) {
  std::vector<RectMm> rectangles(plan.zones.size());
  for (const NodeRect& placed : node_rectangles(plan)) {
    const Node& node = plan.nodes[placed.node];
    if (!node.zone) continue;
    const auto zone = std::ranges::find(plan.zones, *node.zone, &Zone::id);
    rectangles[static_cast<std::size_t>(zone - plan.zones.begin())] = placed.rect;
  }
  return rectangles;
}

}  // namespace marketgen::plan
