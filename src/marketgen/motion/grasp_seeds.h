// Where it is worth looking for a grasp: places and directions that suit a pack's shape.
#pragma once
#include <vector>

#include "motion/grasp_candidates.h"
#include "motion/grasp_surface.h"

namespace marketgen::motion {

struct PinchSeed {
  GraspStrategy strategy = GraspStrategy::side;
  Vec3 center;             // of the pads, product frame
  Vec3 approach, closing;  // unit, at right angles
  bool inside = false;     // the open pads start from within the pack's outline (handles)
};

// For a gripper. Deterministic.
std::vector<PinchSeed> pinch_seeds(const assets::ProductBody& body,
                                   const GraspSurface& surface,
                                   const robots::GraspTool& tool);

struct SuctionSeed {
  GraspStrategy strategy = GraspStrategy::suction_front;
  Vec3 origin, travel;  // the cup comes from there, along the unit vector
};

std::vector<SuctionSeed> suction_seeds(const assets::ProductBody& body,
                                       const GraspSurface& surface);

// The same for a pack that lies any way round; `up` is the world's, product frame. Fingers close
// along the pack's axes and, square to its Z, every 15 degrees; approaches are swept round each of
// these. Strategies are named by the world: top is within 20 degrees of straight down.
std::vector<PinchSeed> pinch_seeds_from_above(const assets::ProductBody& body,
                                              const GraspSurface& surface,
                                              Vec3 up);
// As those seeds are named.
GraspStrategy strategy_from_above(Vec3 approach, Vec3 up);
std::vector<SuctionSeed> suction_seeds_from_above(const assets::ProductBody& body,
                                                  const GraspSurface& surface,
                                                  Vec3 up);

}  // namespace marketgen::motion
