// Where the oracle may take hold of an item, and what is in the way.
#pragma once
#include <vector>

#include "oracle/oracle_scene.h"

namespace marketgen::oracle {

struct GraspChoice : skills::HandGrasp {
  std::vector<std::size_t> blockers;  // items that the open tool would press aside too far
};

struct ItemGrasps {
  std::vector<GraspChoice> choices;     // those without blockers first, best first
  std::vector<std::size_t> lies_under;  // items that it would push when it is lifted
  bool free() const { return !choices.empty() && choices.front().blockers.empty(); }
};

// Of the item as it lies between the walls, whatever lies round it. Errors: of
// grasps_from_above.
Result<std::vector<motion::GraspCandidate>> lone_grasps(const OracleScene& scene, std::size_t item);

// The same with what is in their way now.
ItemGrasps item_grasps(const OracleScene& scene,
                       std::size_t item,
                       const std::vector<motion::GraspCandidate>& lone);

}  // namespace marketgen::oracle
