#include "physics/world_tree.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

namespace marketgen {
namespace {

constexpr int bins = 16;
constexpr double mover_m = 0.12;    // across what is held against the tree: a pack
constexpr double endless_m = 1000;  // planes reach further; they stay near the root

struct TreeLeaf {
  int geom = -1;
  std::array<mjtNum, 6> box{};  // middle, half extents
};

struct Extent {
  std::array<double, 3> low, high;
  int count = 0;
  Extent() {
    low.fill(std::numeric_limits<double>::max());
    high.fill(std::numeric_limits<double>::lowest());
  }
  void add(const TreeLeaf& leaf) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], leaf.box[i] - leaf.box[3 + i]);
      high[i] = std::max(high[i], leaf.box[i] + leaf.box[3 + i]);
    }
    ++count;
  }
  void add(const Extent& other) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], other.low[i]);
      high[i] = std::max(high[i], other.high[i]);
    }
    count += other.count;
  }
  // Proportional to the chance that a pack somewhere in the store meets the box.
  double cost() const {
    if (count == 0) return 0;
    const double x = high[0] - low[0] + mover_m, y = high[1] - low[1] + mover_m,
                 z = high[2] - low[2] + mover_m;
    return x * y * z * count;
  }
};

class TreeBuilder {
 public:
  explicit TreeBuilder(mjModel& model) : m_(model), first_(model.body_bvhadr[0]) {}

  void build() {
    const int count = m_.body_bvhnum[0];
    for (int node = 0; node < count; ++node) {
      const int geom = m_.bvh_nodeid[first_ + node];
      if (geom < 0) continue;
      TreeLeaf leaf{geom, {}};
      std::copy_n(m_.bvh_aabb + 6 * (first_ + node), 6, leaf.box.begin());
      leaves_.push_back(leaf);
    }
    if (leaves_.size() < 3 || static_cast<int>(2 * leaves_.size() - 1) != count) return;
    const auto endless = std::stable_partition(leaves_.begin(), leaves_.end(), [](const auto& l) {
      return std::max({l.box[3], l.box[4], l.box[5]}) > endless_m;
    });
    grow(leaves_, static_cast<std::size_t>(endless - leaves_.begin()), 0);
  }

 private:
  // Returns the node's number. The first `endless` leaves are split off one by one.
  int grow(std::span<TreeLeaf> leaves, std::size_t endless, int depth) {
    const int node = next_++, at = first_ + node;
    m_.bvh_depth[at] = depth;
    if (leaves.size() == 1) {
      m_.bvh_nodeid[at] = leaves.front().geom;
      m_.bvh_child[2 * at] = m_.bvh_child[2 * at + 1] = -1;
      std::copy_n(leaves.front().box.begin(), 6, m_.bvh_aabb + 6 * at);
      return node;
    }
    const std::size_t left = endless > 0 ? 1 : split(leaves);
    m_.bvh_nodeid[at] = -1;
    m_.bvh_child[2 * at] = grow(leaves.first(left), 0, depth + 1);
    m_.bvh_child[2 * at + 1] = grow(leaves.subspan(left), endless > 0 ? endless - 1 : 0, depth + 1);
    return node;
  }

  struct Cut {
    double cost = std::numeric_limits<double>::max();
    std::size_t axis = 0;
    int bin = 0;  // the last one on the left
  };

  static int bin_of(const TreeLeaf& leaf, std::size_t axis, double low, double width) {
    return std::clamp(static_cast<int>((leaf.box[axis] - low) / width * bins), 0, bins - 1);
  }

  static void look_for_cut(
      std::span<const TreeLeaf> leaves, std::size_t axis, double low, double width, Cut& best) {
    std::array<Extent, bins> filled, right;
    for (const TreeLeaf& leaf : leaves)
      filled[static_cast<std::size_t>(bin_of(leaf, axis, low, width))].add(leaf);
    for (std::size_t i = bins - 1; i > 0; --i) {
      if (i + 1 < bins) right[i] = right[i + 1];
      right[i].add(filled[i]);
    }
    Extent left;
    for (std::size_t i = 0; i + 1 < bins; ++i) {
      left.add(filled[i]);
      if (left.count == 0 || right[i + 1].count == 0) continue;
      const double cost = left.cost() + right[i + 1].cost();
      if (cost < best.cost) best = {cost, axis, static_cast<int>(i)};
    }
  }

  // Orders the leaves and returns how many come to the left.
  static std::size_t split(std::span<TreeLeaf> leaves) {
    Cut best;
    std::array<double, 3> low, width;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [least, most] = std::ranges::minmax_element(
          leaves, {}, [axis](const TreeLeaf& leaf) { return leaf.box[axis]; });
      low[axis] = least->box[axis];
      width[axis] = most->box[axis] - low[axis];
      if (width[axis] > 1e-9) look_for_cut(leaves, axis, low[axis], width[axis], best);
    }
    if (best.cost == std::numeric_limits<double>::max()) return leaves.size() / 2;
    const auto middle = std::stable_partition(leaves.begin(), leaves.end(), [&](const auto& leaf) {
      return bin_of(leaf, best.axis, low[best.axis], width[best.axis]) <= best.bin;
    });
    return static_cast<std::size_t>(middle - leaves.begin());
  }

  mjModel& m_;
  int first_, next_ = 0;
  std::vector<TreeLeaf> leaves_;
};

}  // namespace

void rebuild_world_tree(mjModel& model) {
  TreeBuilder(model).build();
}

void shorten_world_filter(mjModel& model, const std::vector<int>& product_geom) {
  int first = model.body_geomnum[0];
  for (const int geom : product_geom) {
    if (geom >= 0) first = std::min(first, geom - model.body_geomadr[0]);
  }
  model.body_geomnum[0] = std::min(first + 1, model.body_geomnum[0]);
}

}  // namespace marketgen
