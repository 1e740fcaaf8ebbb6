#include "geometry/box_tree.h"

#include <algorithm>
#include <numeric>

namespace marketgen {
inline namespace geometry {
namespace {

constexpr std::uint32_t boxes_of_a_leaf = 8;

void include(Bounds3& bounds, const Bounds3& box) {
  bounds.include(box.low);
  bounds.include(box.high);
}

float along(const Bounds3& box, int axis) {
  const Vec3f twice = box.low + box.high;
  return axis == 0 ? twice.x : axis == 1 ? twice.y : twice.z;
}

// The axis along which the middles of the boxes lie farthest apart.
int longest_axis(std::span<const std::uint32_t> rows, std::span<const Bounds3> boxes) {
  Bounds3 middles;
  for (const std::uint32_t row : rows)
    middles.include(boxes[row].low + boxes[row].high);
  const Vec3f size = middles.size();
  if (size.x >= size.y && size.x >= size.z) return 0;
  return size.y >= size.z ? 1 : 2;
}

}  // namespace

BoxTree::BoxTree(std::span<const Bounds3> boxes) : rows_(boxes.size()) {
  std::iota(rows_.begin(), rows_.end(), 0U);
  boxes_.assign(boxes.begin(), boxes.end());
  if (!rows_.empty()) add_node(0, static_cast<std::uint32_t>(rows_.size()));
  for (std::size_t k = 0; k < rows_.size(); ++k)
    boxes_[k] = boxes[rows_[k]];
}

// Halves at the middle box, whatever the boxes: boxes that all lie in one place halve as well.
// Precondition: boxes_ is still in the caller's order.
void BoxTree::add_node(std::uint32_t first, std::uint32_t last) {
  const std::size_t at = nodes_.size();
  Node node;
  for (std::uint32_t k = first; k < last; ++k)
    include(node.bounds, boxes_[rows_[k]]);
  const bool leaf = last - first <= boxes_of_a_leaf;
  if (leaf) {
    node.first = first;
    node.count = last - first;
  }
  nodes_.push_back(node);
  if (!leaf) {
    const std::uint32_t middle = first + (last - first) / 2;
    const int axis = longest_axis({rows_.data() + first, last - first}, boxes_);
    std::nth_element(rows_.begin() + first,
                     rows_.begin() + middle,
                     rows_.begin() + last,
                     [&](std::uint32_t a, std::uint32_t b) {
                       const float p = along(boxes_[a], axis), q = along(boxes_[b], axis);
                       return p != q ? p < q : a < b;
                     });
    add_node(first, middle);
    add_node(middle, last);
  }
  nodes_[at].beyond = static_cast<std::uint32_t>(nodes_.size());
}

}  // namespace geometry
}  // namespace marketgen
