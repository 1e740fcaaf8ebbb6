// Which grasp is the better one, and how hard it is held: for packs that lie any way round on a
// counter or in a basket, and for those that stand on a shelf.
//
// Base frame, SI units.
#pragma once
#include <vector>

#include "agent/workplace.h"
#include "motion/grasp_candidates.h"

namespace marketgen::skills {

struct HandGrasp {
  motion::GraspStrategy strategy = motion::GraspStrategy::side;
  Pose base_from_tip;
  double opening_m = 0, force_n = 0, width_m = 0;
  double score = 0;  // what is in the hand's way left out
};

constexpr double cup_acceleration = 0.1;  // share of the joints' limits, with something on the cup

// Opening of a hand that holds nothing: as wide as it goes; a cup does not suck.
double open_m(const robots::GraspTool& tool);
// Opening of one that lets go of what it held with `held_m` between the pads: a little wider, as
// far as it goes; a cup stops sucking.
double let_go_m(const robots::GraspTool& tool, double held_m);

// Of a tool from straight down.
double tilt_deg(const Quaternion& base_from_tip);

// A pack as it lies.
struct LyingPack {
  const catalog::Product& product;
  const assets::ProductBody& body;
  double pad_friction = 0.5;
  Pose base_from_product;
  double ground_m = 0;  // height of what it lies on

  Vec3 middle() const { return base_from_product * to_double(body.center_of_mass); }  // of mass
};

// Walls and ledges of the basket as a grasp keeps off them.
std::vector<motion::GraspObstacle> wall_obstacles(const agent::Workplace& place);

// From above, off the walls, whatever lies round it. Errors: of grasp_candidates.
Result<std::vector<motion::GraspCandidate>> grasps_from_above(
    const LyingPack& pack,
    const robots::GraspTool& tool,
    const std::vector<motion::GraspObstacle>& walls);

// Those of the proposals (product frame) that hold it, from above and off the walls, too.
Result<std::vector<motion::CheckedPinch>> checked_from_above(
    const LyingPack& pack,
    const robots::GraspTool& tool,
    const std::vector<motion::GraspObstacle>& walls,
    const std::vector<motion::PinchProposal>& proposals);

// One of them, held firmly, with its worth: room, straight down, near the middle of mass.
HandGrasp lifting_grasp(const LyingPack& pack, const motion::GraspCandidate& candidate);

// What it takes off that worth when the open hand reaches so deep into something beside the pack.
double overlap_cost(double overlap_m);

// A grasp as it is carried out on a pack that stands on a shelf: it is carried about, so it is held
// harder than it must be, as far as the tool can.
HandGrasp carrying_grasp(const Pose& base_from_product,
                         const motion::GraspCandidate& candidate,
                         double max_force_n);

}  // namespace marketgen::skills
