#include "geometry/box_tree.h"

#include <algorithm>
#include <array>

#include "base/parallel.h"

namespace marketgen {
inline namespace geometry {
namespace {

constexpr std::size_t boxes_of_a_leaf = 8;
// Of so many boxes and more both halves are made side by side, in the tree's upper levels.
constexpr std::size_t boxes_side_by_side = 4096;
constexpr int levels_side_by_side = 5;

float along(const Bounds3& box, int axis) {
  const Vec3f twice = box.low + box.high;
  return axis == 0 ? twice.x : axis == 1 ? twice.y : twice.z;
}

// The axis along which the middles of the boxes lie farthest apart.
int longest_axis(const Bounds3& middles) {
  const Vec3f size = middles.size();
  if (size.x >= size.y && size.x >= size.z) return 0;
  return size.y >= size.z ? 1 : 2;
}

std::size_t half_of(std::size_t boxes) {
  return boxes / 2;
}

}  // namespace

BoxTree::BoxTree(std::span<const Bounds3> boxes) {
  std::vector<Entry> entries;
  entries.reserve(boxes.size());
  for (const Bounds3& box : boxes)
    entries.push_back({box, static_cast<std::uint32_t>(entries.size())});
  if (!entries.empty()) nodes_ = nodes_over(entries, 0, levels_side_by_side);
  rows_.reserve(entries.size());
  boxes_.reserve(entries.size());
  for (const Entry& entry : entries) {
    rows_.push_back(entry.row);
    boxes_.push_back(entry.box);
  }
}

// The node over all entries, which are then in halves at the middle box, whatever the boxes: those
// that all lie in one place halve as well. A leaf when they are few.
BoxTree::Node BoxTree::parted(std::span<Entry> entries, std::uint32_t first) {
  Node node;
  Bounds3 middles;
  for (const Entry& entry : entries) {
    node.bounds.include(entry.box.low);
    node.bounds.include(entry.box.high);
    middles.include(entry.box.low + entry.box.high);
  }
  if (entries.size() <= boxes_of_a_leaf) {
    node.first = first;
    node.count = static_cast<std::uint32_t>(entries.size());
    return node;
  }
  const int axis = longest_axis(middles);
  std::nth_element(entries.begin(),
                   entries.begin() + static_cast<std::ptrdiff_t>(half_of(entries.size())),
                   entries.end(),
                   [axis](const Entry& a, const Entry& b) {
                     const float p = along(a.box, axis), q = along(b.box, axis);
                     return p != q ? p < q : a.row < b.row;
                   });
  return node;
}

void BoxTree::add_nodes(std::vector<Node>& nodes, std::span<Entry> entries, std::uint32_t first) {
  const std::size_t at = nodes.size();
  nodes.push_back(parted(entries, first));
  if (nodes[at].count == 0) {
    const std::size_t half = half_of(entries.size());
    add_nodes(nodes, entries.first(half), first);
    add_nodes(nodes, entries.subspan(half), first + static_cast<std::uint32_t>(half));
  }
  nodes[at].beyond = static_cast<std::uint32_t>(nodes.size());
}

// As add_nodes() into nothing.
std::vector<BoxTree::Node> BoxTree::nodes_over(std::span<Entry> entries,
                                               std::uint32_t first,
                                               int levels) {
  std::vector<Node> nodes;
  if (levels == 0 || entries.size() < boxes_side_by_side) {
    add_nodes(nodes, entries, first);
    return nodes;
  }
  nodes.push_back(parted(entries, first));
  const std::size_t half = half_of(entries.size());
  std::array<std::vector<Node>, 2> below;
  parallel_for(2, [&](std::size_t i) {
    below[i] =
        i == 0 ? nodes_over(entries.first(half), first, levels - 1)
               : nodes_over(
                     entries.subspan(half), first + static_cast<std::uint32_t>(half), levels - 1);
  });
  for (const std::vector<Node>& part : below) {
    const auto before = static_cast<std::uint32_t>(nodes.size());
    for (Node node : part) {
      node.beyond += before;
      nodes.push_back(node);
    }
  }
  nodes.front().beyond = static_cast<std::uint32_t>(nodes.size());
  return nodes;
}

}  // namespace geometry
}  // namespace marketgen
