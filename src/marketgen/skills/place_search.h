// Where what is held may be put down on a counter: stable ways round, free places, postures.
//
// What stands about is given: as bodies that are known, as points that were measured, or both. Base
// frame of the arm, whose Z = 0 is the counter; metres.
#pragma once
#include <vector>

#include "skills/arm_executor.h"
#include "skills/hand_room.h"
#include "skills/held_product.h"

namespace marketgen::skills {

// What is held, and how.
struct HeldPack {
  const catalog::Product* product = nullptr;
  const assets::ProductBody* body = nullptr;
  Pose tip_from_product;
  Quaternion base_from_product;  // as it is turned now
  double opening_m = 0;          // of the gripper when it lets go
};

struct CounterBody : PlacedBody {
  TurnedBox box;  // that holds it, base frame
};

struct PlaceQuestion {
  agent::WorkArea area;                    // the whole pack is to stand in it
  std::vector<agent::WorkArea> kept_free;  // and in none of these
  std::vector<CounterBody> bodies;         // that stand about
  const std::vector<Vec3f>* points =
      nullptr;                    // measured, on what stands about; none: there are none
  std::vector<PlacedBody> walls;  // of the basket
  double unsure_m = 0;            // so far may be off what is said of all this
  bool corners_first = false;     // wide packs leave room to those that come after them
};

struct FreePlace {
  Pose base_from_product, base_from_tip;
  Vec3 approach;  // straight down, tip frame
};

constexpr double let_go_height_m = 0.004;  // over the counter

// Best first, at most `max_places`.
std::vector<FreePlace> free_places(const robots::GraspTool& tool,
                                   const ArmExecutor& arm,
                                   const HeldPack& held,
                                   const PlaceQuestion& question,
                                   std::size_t max_places);

// The basket and the area where goods that are asked for go, with room round both: what is in the
// way is put beside them.
std::vector<agent::WorkArea> areas_kept_free(const agent::Workplace& place);

// What is held, as spheres on the link of the arm's tip.
motion::AttachedObject held_spheres(const robots::Robot& robot,
                                    const assets::ProductBody& body,
                                    const Pose& tip_from_product);

}  // namespace marketgen::skills
