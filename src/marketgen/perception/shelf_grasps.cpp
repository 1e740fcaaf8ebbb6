#include "perception/shelf_grasps.h"

#include <algorithm>

namespace marketgen {
namespace {

constexpr double carry_firmness = 2;      // of the force that a grasp needs; it is carried about
constexpr double of_intrusion_per_m = 8;  // of a candidate's score, 0..1
constexpr double borne_m = 0.03;          // of intrusion; what is deeper is no worse

}  // namespace

SeenGrasp carried_grasp(const Pose& base_from_product,
                        const GraspCandidate& candidate,
                        const GraspTool& tool) {
  SeenGrasp grasp;
  grasp.base_from_tip = base_from_product * candidate.grasp.product_from_tool;
  grasp.opening_m = candidate.grasp.opening_m;
  grasp.force_n = std::min(candidate.grasp.force_n * carry_firmness, tool.force_n);
  grasp.width_m = candidate.width_m;
  grasp.score = candidate.score;
  return grasp;
}

Result<std::vector<SeenGrasp>> FrontGrasps::grasps(const ShelfGraspQuestion& question) const {
  GraspQuery query;
  query.friction = question.known.pad_friction;
  query.from_front = true;
  MARKETGEN_TRY(const GraspCandidates candidates,
                grasp_candidates(question.known.product, question.known.body, tool_, query));
  std::vector<SeenGrasp> grasps;
  for (const GraspCandidate& candidate : candidates.found) {
    SeenGrasp grasp = carried_grasp(question.base_from_product, candidate, tool_);
    grasp.intrusion_m =
        hand_intrusion(tool_, grasp.base_from_tip, grasp.opening_m, question.others);
    grasp.score -= of_intrusion_per_m * std::min(grasp.intrusion_m, borne_m);
    grasps.push_back(grasp);
  }
  std::ranges::stable_sort(grasps, std::greater<>{}, &SeenGrasp::score);
  return grasps;
}

}  // namespace marketgen
