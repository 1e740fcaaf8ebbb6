#include "perception/shelf_grasps.h"

#include <algorithm>

#include "skills/hand_room.h"

namespace marketgen::perception {
namespace {

constexpr double of_intrusion_per_m = 8;  // of a candidate's score, 0..1
constexpr double borne_m = 0.03;          // of intrusion; what is deeper is no worse

}  // namespace

motion::GraspQuery query_from_front(const ShelfGraspQuestion& question) {
  motion::GraspQuery query;
  query.friction = question.known.pad_friction;
  query.from_front = true;
  query.walls = question.walls;
  return query;
}

SeenGrasp shelf_grasp(const ShelfGraspQuestion& question,
                      const motion::GraspCandidate& candidate,
                      const robots::GraspTool& tool) {
  SeenGrasp grasp =
      with_intrusion({skills::carrying_grasp(question.base_from_product, candidate, tool.force_n)},
                     tool,
                     question.others);
  grasp.score -= of_intrusion_per_m * std::min(grasp.intrusion_m, borne_m);
  return grasp;
}

Result<std::vector<SeenGrasp>> FrontGrasps::grasps(const ShelfGraspQuestion& question) const {
  motion::GraspQuery query = query_from_front(question);
  const auto look = [&] {
    return motion::grasp_candidates(question.known.product, question.known.body, tool_, query);
  };
  MARKETGEN_TRY(motion::GraspCandidates candidates, look());
  if (candidates.found.empty()) {  // too wide for fingers with so much room
    query.finger_gap_m = motion::wedge_gap_m;
    MARKETGEN_TRY(candidates, look());
  }
  std::vector<SeenGrasp> grasps;
  for (const motion::GraspCandidate& candidate : candidates.found)
    grasps.push_back(shelf_grasp(question, candidate, tool_));
  std::ranges::stable_sort(grasps, std::greater<>{}, &SeenGrasp::score);
  return grasps;
}

}  // namespace marketgen::perception
