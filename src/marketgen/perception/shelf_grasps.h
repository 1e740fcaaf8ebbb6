// Where a gripper may take hold of a product that was found on a shelf, from the aisle.
//
// Base frame, metres.
#pragma once
#include "perception/grasp_source.h"

namespace marketgen::perception {

struct ShelfGraspQuestion {
  const agent::KnownProduct& known;
  Pose base_from_product;
  const std::vector<Vec3f>& others;  // measured points that are not the product's
  SeenIn seen_in = {};
  std::vector<motion::GraspObstacle> walls = {};  // boards and panels about it, product frame
};

class ShelfGraspSource {
 public:
  virtual ~ShelfGraspSource() = default;
  // Best first. Errors: of grasp_candidates.
  virtual Result<std::vector<SeenGrasp>> grasps(const ShelfGraspQuestion& question) const = 0;
};

// What such a source asks of grasps: from the front, between neighbours that far apart.
motion::GraspQuery query_from_front(const ShelfGraspQuestion& question);
// A grasp with its worth, less what the open hand reaches into.
SeenGrasp shelf_grasp(const ShelfGraspQuestion& question,
                      const motion::GraspCandidate& candidate,
                      const robots::GraspTool& tool);

// Antipodal grasps on the catalogue's shape from the front. Between packs that stand 2 to 8 mm
// apart a finger must press its way, so that reaching into what is measured beside only puts a
// grasp behind another.
class FrontGrasps : public ShelfGraspSource {
 public:
  explicit FrontGrasps(const robots::GraspTool& tool) : tool_(tool) {}  // must outlive it
  Result<std::vector<SeenGrasp>> grasps(const ShelfGraspQuestion& question) const override;

 private:
  const robots::GraspTool& tool_;
};

}  // namespace marketgen::perception
