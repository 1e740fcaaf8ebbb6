#include "skills/hand_grasp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "agent/policy.h"

namespace marketgen::skills {
namespace {

constexpr std::size_t max_candidates = 64;
// How far open pads stand off the pack on either side; the second where the first finds nothing.
constexpr std::array open_on_each_side_m{0.005, 0.0025};
// Of the force that a grasp needs: goods are knocked while they are carried.
constexpr double firmness = 2;
constexpr double min_grip_n = 30, max_grip_n = 60;  // of what is lifted out of a basket

// ---- Weights of the score. Chosen by trial on drawn baskets; no other source. ----
constexpr double max_room_m = 0.015;
constexpr double of_room = 1000, of_tilt_deg = 0.2, of_middle_offset = 250, of_overlap = 3000;
// Of how firm the grasp is, 0..1 (GraspCandidate::score): faces that lean press the pack out.
constexpr double of_firmness = 30;

constexpr double let_go_wider_m = 0.014;

motion::GraspQuery query_from_above(const LyingPack& pack,
                                    const std::vector<motion::GraspObstacle>& walls) {
  motion::GraspQuery query;
  query.friction = pack.pad_friction;
  query.most = max_candidates;
  query.from_above = true;
  query.world_from_product = pack.base_from_product;
  query.world_from_product.position.z -= pack.ground_m;
  query.walls = walls;
  for (motion::GraspObstacle& wall : query.walls)
    wall.world_from_box.position.z -= pack.ground_m;
  return query;
}

}  // namespace

double open_m(const robots::GraspTool& tool) {
  return tool.kind == robots::ToolKind::suction ? agent::cup_off_m : tool.opening_m;
}

double let_go_m(const robots::GraspTool& tool, double held_m) {
  return tool.kind == robots::ToolKind::suction ? agent::cup_off_m
                                                : std::min(tool.opening_m, held_m + let_go_wider_m);
}

double tilt_deg(const Quaternion& base_from_tip) {
  const Vec3 ahead = rotate(base_from_tip, {0, 0, 1});
  return std::acos(std::clamp(-ahead.z, -1.0, 1.0)) * 180 / std::numbers::pi;
}

std::vector<motion::GraspObstacle> wall_obstacles(const agent::Workplace& place) {
  std::vector<motion::GraspObstacle> walls;
  for (const auto* boxes : {&place.walls, &place.ledges})
    for (const agent::WorkBox& box : *boxes)
      walls.push_back({place.base_from_basket * box.pose, box.half_size});
  return walls;
}

Result<std::vector<motion::GraspCandidate>> grasps_from_above(
    const LyingPack& pack,
    const robots::GraspTool& tool,
    const std::vector<motion::GraspObstacle>& walls) {
  motion::GraspQuery query = query_from_above(pack, walls);
  for (const double gap : open_on_each_side_m) {
    query.finger_gap_m = gap;
    MARKETGEN_TRY(motion::GraspCandidates found,
                  motion::grasp_candidates(pack.product, pack.body, tool, query));
    if (!found.found.empty()) return std::move(found.found);
  }
  return std::vector<motion::GraspCandidate>{};
}

Result<std::vector<motion::CheckedPinch>> checked_from_above(
    const LyingPack& pack,
    const robots::GraspTool& tool,
    const std::vector<motion::GraspObstacle>& walls,
    const std::vector<motion::PinchProposal>& proposals) {
  motion::GraspQuery query = query_from_above(pack, walls);
  query.finger_gap_m = open_on_each_side_m.back();
  return motion::check_pinches(pack.product, pack.body, tool, query, proposals);
}

HandGrasp lifting_grasp(const LyingPack& pack, const motion::GraspCandidate& candidate) {
  HandGrasp grasp;
  grasp.strategy = candidate.strategy;
  grasp.base_from_tip = pack.base_from_product * candidate.grasp.product_from_tool;
  grasp.opening_m =
      candidate.tool == robots::ToolKind::suction ? agent::cup_off_m : candidate.grasp.opening_m;
  grasp.width_m = candidate.width_m;
  grasp.force_n = std::clamp(candidate.grasp.force_n * firmness, min_grip_n, max_grip_n);
  grasp.score = of_firmness * candidate.score;
  const double offset = length(grasp.base_from_tip.position - pack.middle());
  grasp.score += of_room * std::min(candidate.clearance_m, max_room_m) -
                 of_tilt_deg * tilt_deg(grasp.base_from_tip.rotation) - of_middle_offset * offset;
  return grasp;
}

double overlap_cost(double overlap_m) {
  return of_overlap * std::min(overlap_m, max_room_m);
}

HandGrasp carrying_grasp(const Pose& base_from_product,
                         const motion::GraspCandidate& candidate,
                         double max_force_n) {
  HandGrasp grasp;
  grasp.strategy = candidate.strategy;
  grasp.base_from_tip = base_from_product * candidate.grasp.product_from_tool;
  grasp.opening_m = candidate.grasp.opening_m;
  grasp.force_n = std::min(candidate.grasp.force_n * firmness, max_force_n);
  grasp.width_m = candidate.width_m;
  grasp.score = candidate.score;
  return grasp;
}

}  // namespace marketgen::skills
