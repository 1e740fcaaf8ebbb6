// A balanced tree over boxes: who is near whom, in about n log n however the sizes are mixed and
// however crowded a place is. Immutable once built; any thread may ask.
#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace marketgen {
inline namespace geometry {

// Smallest overlap of two boxes over the axes; negative when they are apart.
inline float overlap_of(const Bounds3& a, const Bounds3& b) {
  const float x = std::min(a.high.x, b.high.x) - std::max(a.low.x, b.low.x);
  const float y = std::min(a.high.y, b.high.y) - std::max(a.low.y, b.low.y);
  const float z = std::min(a.high.z, b.high.z) - std::max(a.low.z, b.low.z);
  return std::min({x, y, z});
}

class BoxTree {
 public:
  explicit BoxTree(std::span<const Bounds3> boxes);  // which are copied

  // Calls visit(i) for every box i that overlaps `box` by at least `overlap_m` (negative: is no
  // farther away than that), in an order that the boxes alone decide.
  template <class Visit>
  void each_near(const Bounds3& box, float overlap_m, const Visit& visit) const {
    for (std::size_t at = 0; at < nodes_.size();) {
      const Node& node = nodes_[at];
      if (overlap_of(node.bounds, box) < overlap_m) {
        at = node.beyond;
        continue;
      }
      for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
        if (overlap_of(boxes_[k], box) >= overlap_m) visit(rows_[k]);
      }
      ++at;
    }
  }

 private:
  // Depth first: a node's children follow it, and `beyond` is the first node that is not below it.
  struct Node {
    Bounds3 bounds;
    std::uint32_t first = 0, count = 0;  // boxes of a leaf
    std::uint32_t beyond = 0;
  };

  struct Entry {
    Bounds3 box;
    std::uint32_t row = 0;
  };

  static Node parted(std::span<Entry> entries, std::uint32_t first);
  static void add_nodes(std::vector<Node>& nodes, std::span<Entry> entries, std::uint32_t first);
  static std::vector<Node> nodes_over(std::span<Entry> entries, std::uint32_t first, int levels);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> rows_;  // of the caller's boxes, leaf by leaf
  std::vector<Bounds3> boxes_;       // in the order of rows_
};

}  // namespace geometry
}  // namespace marketgen
