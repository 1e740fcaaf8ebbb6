#include "physics/world/still_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "physics/goods/body_patch.h"

namespace marketgen::physics {
namespace {

constexpr int bins = 16;
constexpr double mover_m = 0.12;  // across what is held against the tree: a pack

struct TreeLeaf {
  int geom = -1;
  Box3 box;
  std::array<double, 3> middle{};
};

Box3 nothing() {
  constexpr double most = std::numeric_limits<double>::max();
  return {{most, most, most}, {-most, -most, -most}};
}

Box3 joined(const Box3& a, const Box3& b) {
  return {
      {std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y), std::min(a.low.z, b.low.z)},
      {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y), std::max(a.high.z, b.high.z)}};
}

struct LeafExtent {
  Box3 box = nothing();
  int count = 0;
  void add(const LeafExtent& other) {
    box = joined(box, other.box);
    count += other.count;
  }
  // Proportional to the chance that a pack somewhere in the store meets the box.
  double cost() const {
    if (count == 0) return 0;
    const Vec3 size = box.high - box.low;
    return (size.x + mover_m) * (size.y + mover_m) * (size.z + mover_m) * count;
  }
};

struct Cut {
  double cost = std::numeric_limits<double>::max();
  std::size_t axis = 0;
  int bin = 0;  // the last one on the left
};

int bin_of(const TreeLeaf& leaf, std::size_t axis, double low, double width) {
  return std::clamp(static_cast<int>((leaf.middle[axis] - low) / width * bins), 0, bins - 1);
}

// The best cut across one axis.
Cut best_cut(std::span<const TreeLeaf> leaves, std::size_t axis, double low, double width) {
  std::array<LeafExtent, bins> filled, right;
  for (const TreeLeaf& leaf : leaves)
    filled[static_cast<std::size_t>(bin_of(leaf, axis, low, width))].add({leaf.box, 1});
  for (std::size_t i = bins - 1; i > 0; --i) {
    if (i + 1 < bins) right[i] = right[i + 1];
    right[i].add(filled[i]);
  }
  Cut best;
  LeafExtent left;
  for (std::size_t i = 0; i + 1 < bins; ++i) {
    left.add(filled[i]);
    if (left.count == 0 || right[i + 1].count == 0) continue;
    const double cost = left.cost() + right[i + 1].cost();
    if (cost < best.cost) best = {cost, axis, static_cast<int>(i)};
  }
  return best;
}

// Orders the leaves and returns how many come to the left.
std::size_t split(std::span<TreeLeaf> leaves) {
  Cut best;
  std::array<double, 3> low, width;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [least, most] = std::ranges::minmax_element(
        leaves, {}, [axis](const TreeLeaf& leaf) { return leaf.middle[axis]; });
    low[axis] = least->middle[axis];
    width[axis] = most->middle[axis] - low[axis];
    if (width[axis] <= 1e-9) continue;
    const Cut cut = best_cut(leaves, axis, low[axis], width[axis]);
    if (cut.cost < best.cost) best = cut;
  }
  if (best.cost == std::numeric_limits<double>::max()) return leaves.size() / 2;
  const auto middle = std::stable_partition(leaves.begin(), leaves.end(), [&](const auto& leaf) {
    return bin_of(leaf, best.axis, low[best.axis], width[best.axis]) <= best.bin;
  });
  return static_cast<std::size_t>(middle - leaves.begin());
}

Box3 box_of_still(const mjModel& m, int geom) {
  mjtNum turned[9];
  mju_quat2Mat(turned, m.geom_quat + 4 * geom);
  return box_of_geom(m, geom, m.geom_pos + 3 * geom, turned);
}

}  // namespace

class StillTreeBuilder {
 public:
  explicit StillTreeBuilder(StillTree& tree) : tree_(tree) {}

  void grow(std::span<TreeLeaf> leaves, std::size_t parent) {
    const std::size_t node = tree_.nodes_.size();
    tree_.nodes_.push_back({});
    tree_.nodes_[node].parent = parent;
    if (leaves.size() == 1) {
      const TreeLeaf& leaf = leaves.front();
      tree_.nodes_[node].box = leaf.box;
      tree_.nodes_[node].geom = leaf.geom;
      tree_.leaf_of_[static_cast<std::size_t>(leaf.geom - tree_.first_geom_)] = node;
      return;
    }
    const std::size_t left = split(leaves);
    tree_.nodes_[node].left = tree_.nodes_.size();
    grow(leaves.first(left), node);
    tree_.nodes_[node].right = tree_.nodes_.size();
    grow(leaves.subspan(left), node);
    const StillTree::Node& made = tree_.nodes_[node];
    tree_.nodes_[node].box = joined(tree_.nodes_[made.left].box, tree_.nodes_[made.right].box);
  }

 private:
  StillTree& tree_;
};

StillTree::StillTree(const mjModel& m, int body) : first_geom_(m.body_geomadr[body]) {
  const int count = m.body_geomnum[body];
  leaf_of_.assign(static_cast<std::size_t>(count), 0);
  std::vector<TreeLeaf> leaves;
  for (int geom = first_geom_; geom < first_geom_ + count; ++geom) {
    if (m.geom_type[geom] == mjGEOM_PLANE) continue;
    const Box3 box = box_of_still(m, geom);
    const Vec3 middle = (box.low + box.high) / 2;
    leaves.push_back({geom, box, {middle.x, middle.y, middle.z}});
  }
  nodes_.reserve(2 * leaves.size());
  if (!leaves.empty()) StillTreeBuilder(*this).grow(leaves, 0);
}

std::vector<int> StillTree::near(const Box3& box) const {
  std::vector<int> found;
  std::vector<std::size_t> open;
  if (!nodes_.empty()) open.push_back(0);
  while (!open.empty()) {
    const Node& node = nodes_[open.back()];
    open.pop_back();
    if (!node.box.meets(box, 0)) continue;
    if (node.geom >= 0) {
      found.push_back(node.geom);
    } else {
      open.push_back(node.right);
      open.push_back(node.left);
    }
  }
  return found;
}

void StillTree::refit(const mjModel& m, int geom) {
  std::size_t node = leaf(geom);
  nodes_[node].box = box_of_still(m, geom);
  while (node > 0) {
    node = nodes_[node].parent;
    nodes_[node].box = joined(nodes_[nodes_[node].left].box, nodes_[nodes_[node].right].box);
  }
}

}  // namespace marketgen::physics
