// Where what is held may be put down: stable ways round, free places, postures, by what is known of
// the product and what is seen of the counter. Base frame, metres.
#pragma once
#include <optional>
#include <vector>

#include "agent/known_products.h"
#include "agent/workplace.h"
#include "robots/grasp_tool.h"
#include "skills/arm_executor.h"

namespace marketgen {

struct HeldProduct {
  const KnownProduct* known = nullptr;
  Pose tip_from_product;
  double opening_m = 0;  // of the gripper when it lets go
};

struct FreePlace {
  Pose base_from_product, base_from_tip;
  Vec3 approach;  // straight down, tip frame
};

struct PlaceAsk {
  WorkArea area;                      // the whole product is to stand in it
  std::vector<WorkArea> kept_free;    // and in none of these
  const std::vector<Vec3f>& counter;  // measured points of what stands about
  std::vector<WorkBox> walls;         // of the basket, base_from_box
};

constexpr double let_go_height_m = 0.004;  // over the counter

// Best first, at most `most`.
std::vector<FreePlace> free_places(const GraspTool& tool,
                                   const ArmExecutor& arm,
                                   const HeldProduct& held,
                                   const PlaceAsk& ask,
                                   std::size_t most);

// What is held, as spheres on the link of the tip.
AttachedObject held_spheres(const Robot& robot, const HeldProduct& held);

}  // namespace marketgen
