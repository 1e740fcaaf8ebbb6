#include "perception/shelf_grasps.h"

#include <algorithm>

#include "skills/hand_room.h"

namespace marketgen::perception {
namespace {

constexpr double of_intrusion_per_m = 8;  // of a candidate's score, 0..1
constexpr double borne_m = 0.03;          // of intrusion; what is deeper is no worse

}  // namespace

Result<std::vector<SeenGrasp>> FrontGrasps::grasps(const ShelfGraspQuestion& question) const {
  motion::GraspQuery query;
  query.friction = question.known.pad_friction;
  query.from_front = true;
  const auto look = [&] {
    return motion::grasp_candidates(question.known.product, question.known.body, tool_, query);
  };
  MARKETGEN_TRY(motion::GraspCandidates candidates, look());
  if (candidates.found.empty()) {  // too wide for fingers with so much room
    query.finger_gap_m = motion::wedge_gap_m;
    MARKETGEN_TRY(candidates, look());
  }
  std::vector<SeenGrasp> grasps;
  for (const motion::GraspCandidate& candidate : candidates.found) {
    SeenGrasp grasp{skills::carrying_grasp(question.base_from_product, candidate, tool_.force_n)};
    grasp.intrusion_m = skills::hand_overlap(
        skills::open_hand(tool_, grasp.opening_m), grasp.base_from_tip, question.others);
    grasp.score -= of_intrusion_per_m * std::min(grasp.intrusion_m, borne_m);
    grasps.push_back(grasp);
  }
  std::ranges::stable_sort(grasps, std::greater<>{}, &SeenGrasp::score);
  return grasps;
}

}  // namespace marketgen::perception
