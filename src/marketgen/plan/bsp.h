// The BSP tree of a plan made concrete: which rectangle of the floor each node covers.
//
// Used by validation (is there room?), by layout and by planners that score candidate trees.
// Rounding: the first child gets floor(ratio * room + 0.5) millimetres of the room left after the
// gap; the gap and the second child take the rest, so children never overlap and nothing is lost.
#pragma once
#include <cstddef>
#include <vector>

#include "geometry/rectangle.h"
#include "plan/plan.h"

namespace marketgen::plan {

// What holds for an inner node that does not say: halves with nothing between them.
constexpr double default_split_ratio = 0.5;
constexpr int default_gap_mm = 0;
constexpr int max_gap_mm = 8000;  // Node::gap_mm

// Narrower ground holds neither a fixture nor a shopper.
constexpr int min_node_side_mm = 1000;

struct NodeRect {
  std::size_t node;  // index into Plan::nodes
  RectMm rect;       // store frame
  int depth;         // the root has 0
};

// The bounding rectangle of the shell.
RectMm shell_rect(const Shell& shell);

// The two parts of `rect` cut by `node`; a part can be empty when the gap is wider than the
// rectangle. Precondition: inner node.
std::array<RectMm, 2> split_rect(const RectMm& rect, const Node& node);

// Every node, parents before children, first child first. Precondition: valid tree.
std::vector<NodeRect> node_rectangles(const Plan& plan);

// The rectangle of each zone, in the order of Plan::zones. Precondition: valid tree.
std::vector<RectMm> zone_rectangles(const Plan& plan);

}  // namespace marketgen::plan
