// Where a tool may take hold of a product: from its contact pieces, features and mass.
//
// Grippers. A seed is a place and two directions (approach, closing), from the strategy that suits
// the shape: side, neck, top, seam, handle. The pads are moved onto the pack along the closing
// direction. The seed is kept when both touch it, when what they touch lies opposite within the
// friction cone (antipodal: Nguyen, "Constructing force-closure grasps", IJRR 1988; here for pads,
// not points), when they hold the pack's weight while it is moved and do not let it turn, and when
// the open tool has room round the pack and over what it stands on.
//
// Cups. The lip must lie on the pack evenly enough to seal, and the cup must hold what hangs on it:
// pull, shear by friction, and the moment that peels it off.
//
// Packs are taken for rigid. Product frame as in assets/product_model.h: Z up, front towards -Y. SI
// units. Deterministic; thread-safe.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "assets/product_model.h"
#include "base/result.h"
#include "robots/grasp_tool.h"

namespace marketgen::motion {

enum class GraspStrategy {
  side,
  neck,
  top,
  seam,
  handle,
  suction_front,
  suction_top,
  suction_side
};
constexpr std::array<std::string_view, 8> names_of(GraspStrategy) {
  return {"side", "neck", "top", "seam", "handle", "suction_front", "suction_top", "suction_side"};
}

struct GraspCandidate {
  robots::ToolKind tool = robots::ToolKind::gripper;
  GraspStrategy strategy = GraspStrategy::side;
  robots::Grasp grasp = {};
  double width_m = 0;      // between the pads when they rest on the pack; 0 for a cup
  double clearance_m = 0;  // of the open tool: least distance to the pack, to what it stands on and
                           // to walls
  double side_room_m = 0;  // free space that each open finger takes up beside the pack
  double swing_n = 0;  // force at which the pack does not turn between the pads, whichever way up
                       // it is held; of a cup, the pull with which it is not peeled off then
  double score = 0;    // 0..1, best first
};

// Why there is no candidate: how far the best seed came.
enum class GraspRefusal { none, too_wide, not_opposed, turns, no_seal, too_heavy, no_room };
constexpr std::array<std::string_view, 7> names_of(GraspRefusal) {
  return {"none", "too_wide", "not_opposed", "turns", "no_seal", "too_heavy", "no_room"};
}

struct GraspCandidates {
  std::vector<GraspCandidate> found;  // best first, apart from one another
  GraspRefusal refusal = GraspRefusal::none;
  std::string reason;  // a sentence with the figures, empty when something was found
};

// A box that stands still where the pack lies.
struct GraspObstacle {
  Pose world_from_box;
  Vec3 half_size;
};

struct GraspQuery {
  double friction = 0.5;                 // of pads or lip on the product's material
  double finger_gap_m = 0.005;           // that the open pads keep from the pack on either side
  std::optional<double> ceiling_m = {};  // height of what is over the pack
  double neighbour_gap_m = 0;  // to its likes on either side, which the tool had better not meet; 0
                               // = there are none
  bool from_front = false;     // only approaches within 60 degrees of +Y, none from above
  std::size_t most = 8;        // candidates

  // ---- A pack that lies any way round among others. World frame: Z up; the pack lies on z = 0 or
  // on what is there. Candidates stay in the product frame. ----
  Pose world_from_product = {};
  bool from_above = false;                // only approaches within 65 degrees of straight down
  std::vector<GraspObstacle> walls = {};  // the open tool keeps clear of them
  std::vector<Pose> likes = {};           // world_from_product of other packs of the same product
};

// How fast a held product is moved at most: what a grasp must hold beside its weight. (The Panda
// may reach 13 m/s^2; who carries a full bottle by its neck goes slowly.)
constexpr double carry_acceleration_m_s2 = 2;
// What pads hold by friction is what must be held times this (2 is usual in sizing grippers by
// friction, in the makers' catalogues).
constexpr double grip_safety = 2;
// The same for what keeps a pack from turning between the pads.
constexpr double turn_safety = 1.2;

// The least finger_gap_m with which a gripper comes to a pack that stands among others.
constexpr double wedge_gap_m = 0.0015;

// So far the open tool may reach into the likes of a pack that lies among them: they give way.
constexpr double max_like_overlap_m = 0.008;

// Force on each of two pads that holds the mass.
double pinch_force_n(double mass_kg, double friction);

// Errors: catalog.bad_row for a product without mass or size; motion.bad_configuration for a query
// with a friction or gap that is not positive, or with poses that are not finite.
Result<GraspCandidates> grasp_candidates(const catalog::Product& product,
                                         const assets::ProductBody& body,
                                         const robots::GraspTool& tool,
                                         const GraspQuery& query);

// Where somebody else, a grasp network for one, would close a gripper's pads. Product frame.
struct PinchProposal {
  Vec3 center;             // of the pads
  Vec3 approach, closing;  // unit, at right angles
};
struct CheckedPinch {
  std::size_t proposal = 0;  // its number
  GraspCandidate candidate;
};

// Those of the proposals that hold the pack and have room, as the search's own seeds are judged; a
// hand may stay a little farther back than was proposed. In the order of the proposals. Errors: as
// grasp_candidates().
Result<std::vector<CheckedPinch>> check_pinches(const catalog::Product& product,
                                                const assets::ProductBody& body,
                                                const robots::GraspTool& tool,
                                                const GraspQuery& query,
                                                const std::vector<PinchProposal>& proposals);

}  // namespace marketgen::motion
