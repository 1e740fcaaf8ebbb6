// The bounding-volume tree of the world body's geoms, built better than MuJoCo builds it.
//
// MuJoCo halves the geoms at the median of their middles. In a store a back panel then shares its
// box with forty packs, and whatever moves is held against all of them. Here splits are chosen by
// the chance that a pack meets both halves (surface-area heuristic: Goldsmith and Salmon 1987;
// binned: Wald 2007).
#pragma once
#include <vector>

#include "physics/mujoco_guard.h"

namespace marketgen {

// Same leaves, same number of nodes, root first, children behind their parents. The boxes of inner
// nodes are left to WorldBounds. Without effect on a tree of fewer than three leaves.
void rebuild_world_tree(mjModel& model);

// For every body that moves, at every step, MuJoCo joins the contact bits of all geoms of the world
// body to see whether the two can meet at all: 26,000 geoms, 3 us a body. All goods that stand
// still have the same bits, so the first of them is enough. After the first mj_kinematics, which
// places all geoms; what lies near is found by the tree, which keeps them all. `product_geom`: the
// geom of each product, -1 for none.
void shorten_world_filter(mjModel& model, const std::vector<int>& product_geom);

}  // namespace marketgen
