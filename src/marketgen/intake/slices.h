// Floors cut into strips: an n-ary form of the BSP tree, in which designs are easier to say.
//
// A slice is a zone, or is cut across one axis into parts of known sizes with gaps between them.
// Sizes are whole millimetres and add up, so rectangles follow without a tree; `nodes_of` turns
// slices into the binary nodes of a plan.
#pragma once
#include <string>
#include <vector>

#include "geometry/rectangle.h"
#include "plan/plan.h"

namespace marketgen::intake {

struct Slice {
  int zone = -1;                    // index of the zone that fills it; -1 when it is cut
  plan::Axis axis = plan::Axis::x;  // cut across x: parts run west to east; y: south to north
  std::vector<Slice> parts;
  std::vector<int> sizes_mm;  // of the parts along the axis
  std::vector<int> gaps_mm;   // after each part but the last

  // A part that is cut across the same axis is taken in piece by piece: the binary tree then groups
  // the pieces as it likes.
  void add(Slice part, int size_mm, int gap_before_mm);
};

Slice zone_slice(int zone);
Slice cut_slice(plan::Axis axis);
// The same with x for y: what lay west to east lies south to north.
Slice transposed(Slice slice);
// A slice with one part is that part.
Slice simplified(Slice slice);

// The rectangle of each zone; zones that are nowhere keep an empty one.
std::vector<RectMm> zone_rects(const Slice& slice, const RectMm& rect, std::size_t zones);

// Cuts between the root and the deepest leaf in the best binary tree, or more than max_bsp_depth
// when a cut's ratio would leave what plans allow.
int tree_depth(const Slice& slice);

// The binary tree. Ids are "floor", "floor/1" and so on. `zone_ids` in the order of zone indices.
std::vector<plan::Node> nodes_of(const Slice& slice, const std::vector<std::string>& zone_ids);

}  // namespace marketgen::intake
