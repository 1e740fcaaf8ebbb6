// Something on a shelf that is to be taken: where it stands, and how a hand may take hold of it.
//
// Store frame; SI units.
#pragma once
#include <string>
#include <vector>

#include "agent/known_products.h"
#include "perception/shelf_grasps.h"
#include "policy/aisle_sight.h"
#include "robots/grasp_tool.h"

namespace marketgen::policy {

struct PickTarget {
  const agent::KnownProduct* known = nullptr;
  Pose store_from_product;
  std::vector<robots::Grasp> grasps;  // best first
  std::string tool_row;               // of the gripper that they are for
};

// What was seen about it and what the map says there.
struct PickSight {
  const std::vector<Vec3f>& points;  // measured, of it and of others
  perception::SeenIn seen_in = {};
  std::vector<motion::GraspObstacle> walls = {};  // product frame
};

// Errors: of the source.
Result<PickTarget> pick_target(const agent::KnownProduct& known,
                               const perception::ProductLook& look,
                               const Pose& store_from_product,
                               const robots::GraspTool& tool,
                               const perception::ShelfGraspSource& grasps,
                               const PickSight& sight);

}  // namespace marketgen::policy
