// Slices that follow a drawn floor: a decision tree on the map of its zones.
//
// The floor is cut from wall to wall, again and again, where the fewest squares come to lie on the
// wrong side. Any floor that can be cut up so is found again; another one gets its nearest.
#pragma once
#include <vector>

#include "drawing/zone_drawing.h"
#include "intake/slices.h"

namespace marketgen::intake {

struct FittedSlices {
  Slice root;
  std::vector<RectMm> rects;  // by zone of the map; empty for zones that have no square
  double iou = 0;             // micro_iou of these
};

// Each zone that has squares becomes one leaf; bare floor between two sides of a cut becomes its
// gap, other bare floor belongs to the zone around it. Deterministic. Precondition: a zone has
// squares, and `zones` is more than every index in the map.
FittedSlices fit_slices(const drawing::ZoneMap& map, std::size_t zones, int width_mm, int depth_mm);

// The floor on which map and rectangles name the same zone, of that on which either names one, over
// all zones together. The map is stretched to the floor.
double micro_iou(const drawing::ZoneMap& map,
                 const std::vector<RectMm>& rects,
                 int width_mm,
                 int depth_mm);

}  // namespace marketgen::intake
