// Where the oracle may take hold of an item, and what is in the way.
#pragma once
#include <vector>

#include "oracle/oracle_scene.h"

namespace marketgen {

struct GraspChoice {
  GraspStrategy strategy = GraspStrategy::side;
  Pose station_from_tip;
  double opening_m = 0, force_n = 0, width_m = 0;
  double score = 0;
  std::vector<std::size_t> blockers;  // items that the open tool would press aside too far
};

struct ItemGrasps {
  std::vector<GraspChoice> choices;     // those without blockers first, best first
  std::vector<std::size_t> lies_under;  // items that it would push when it is lifted
  bool free() const { return !choices.empty() && choices.front().blockers.empty(); }
};

// Grasps of the item as it lies between the walls, whatever lies round it. Errors: of
// grasp_candidates.
Result<std::vector<GraspCandidate>> lone_grasps(const OracleScene& scene, std::size_t item);

// The same with what is in their way now.
ItemGrasps item_grasps(const OracleScene& scene,
                       std::size_t item,
                       const std::vector<GraspCandidate>& lone);

}  // namespace marketgen
