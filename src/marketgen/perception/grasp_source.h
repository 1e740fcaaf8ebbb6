// Where a gripper may take hold of a product that was found, and what is seen to be in its way.
//
// Base frame, metres.
#pragma once
#include <vector>

#include "agent/known_products.h"
#include "agent/workplace.h"
#include "perception/pose_source.h"
#include "robots/grasp_tool.h"
#include "skills/hand_grasp.h"

namespace marketgen::perception {

struct SeenGrasp : skills::HandGrasp {
  double intrusion_m = 0;  // how far the open hand reaches into what else is seen, at most
  bool proposed = false;   // by a server, before the program's own
};

// What a product was found in, for sources that look for themselves.
struct SeenIn {
  const std::vector<ViewCloud>* views = nullptr;  // null: no pictures
  Pose base_from_views = {};                      // their frame
};

struct GraspQuestion {
  const agent::KnownProduct& known;
  Pose base_from_product;
  Pose base_from_basket;
  const std::vector<Vec3f>& others;  // measured points that are not the product's
  SeenIn seen_in = {};
};

class GraspSource {
 public:
  virtual ~GraspSource() = default;
  // Best first. Errors: of grasp_candidates.
  virtual Result<std::vector<SeenGrasp>> grasps(const GraspQuestion& question) const = 0;
};

// The product as the question has it, on what it lies on.
skills::LyingPack lying_pack(const GraspQuestion& question, const agent::Workplace& place);
// A grasp, with how far the open hand reaches into what else was measured.
SeenGrasp with_intrusion(SeenGrasp grasp,
                         const robots::GraspTool& tool,
                         const std::vector<Vec3f>& others);

// Antipodal grasps on the catalogue's shape where it was found, from above, off the basket's walls;
// the hand then tested against the measured points there and on its way.
class FittedGrasps : public GraspSource {
 public:
  // Both must outlive it.
  FittedGrasps(const robots::GraspTool& tool, const agent::Workplace& place)
      : tool_(tool), place_(place) {}
  Result<std::vector<SeenGrasp>> grasps(const GraspQuestion& question) const override;

 private:
  const robots::GraspTool& tool_;
  const agent::Workplace& place_;
};

// Points of surfaces in all views, about `spacing_m` apart, below `max_z` and before the arm's own
// body.
std::vector<Vec3f> thinned_points(const std::vector<ViewCloud>& views,
                                  double spacing_m,
                                  double max_z);

// Those that a product, lying so, does not explain.
std::vector<Vec3f> other_points(const std::vector<Vec3f>& points,
                                const ProductLook& look,
                                const Pose& base_from_product);

}  // namespace marketgen::perception
