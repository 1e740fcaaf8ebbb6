// What stands still in a World, in a tree of boxes: which of 30,000 geoms are near a place.
//
// Splits are chosen by the chance that a pack meets both halves (surface-area heuristic: Goldsmith
// and Salmon 1987; binned: Wald 2007). MuJoCo's own tree halves the geoms at the median of their
// middles: in a store a back panel then shares its box with forty packs.
#pragma once
#include <vector>

#include "physics/mujoco_guard.h"
#include "physics/world/product_grid.h"

namespace marketgen::physics {

class StillTree {
 public:
  // The geoms of a body that stands at the origin; planes are left out.
  StillTree(const mjModel& model, int body);

  std::vector<int> near(const Box3& box) const;  // geoms whose own boxes meet it
  const Box3& box(int geom) const { return nodes_[leaf(geom)].box; }
  void refit(const mjModel& model, int geom);  // where it stands now, O(log n)

 private:
  struct Node {
    Box3 box;
    int geom = -1;         // of a leaf
    std::size_t left = 0;  // of an inner node; the right one follows the left one's
    std::size_t right = 0, parent = 0;
  };
  std::size_t leaf(int geom) const {
    return leaf_of_[static_cast<std::size_t>(geom - first_geom_)];
  }
  friend class StillTreeBuilder;

  std::vector<Node> nodes_;  // root first, children behind their parents
  std::vector<std::size_t> leaf_of_;
  int first_geom_ = 0;
};

}  // namespace marketgen::physics
