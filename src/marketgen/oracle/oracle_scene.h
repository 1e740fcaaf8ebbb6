// What the oracle knows of a running Checkout Unloading: everything, as shapes.
#pragma once
#include <cstdint>
#include <filesystem>
#include <utility>
#include <vector>

#include "episodes/checkout/checkout_world.h"
#include "motion/grasp_candidates.h"
#include "motion/grasp_surface.h"
#include "robots/grasp_tool.h"
#include "skills/arm_executor.h"

namespace marketgen {

// Of a tool from straight down.
double tilt_deg(const Quaternion& station_from_tip);

// Of the gripper that the counter's robot carries. Errors: of load_grasp_tool.
Result<GraspTool> load_checkout_tool(const CheckoutWorld& world, const std::filesystem::path& data);

class OracleScene {
 public:
  // Both must outlive it. The world is reset before.
  OracleScene(const CheckoutWorld& world, const GraspTool& tool);

  const CheckoutWorld& world() const { return world_; }
  const GraspTool& tool() const { return tool_; }
  std::size_t items() const { return world_.item_count(); }

  // How far a box overlaps the item, at most; 0 when apart. Station frame.
  double overlap(std::size_t item, const Pose& station_from_box, Vec3 half) const;
  // The same of the open tool, standing there and on its way to there.
  double tool_overlap(std::size_t item, const Pose& station_from_tip, double opening_m) const;
  // Whether the open tool, standing there, is nearer than `gap_m` to a wall of the basket.
  bool tool_meets_basket(const Pose& station_from_tip, double opening_m, double gap_m) const;
  // How deep points of item `a`, moved by `by`, lie in item `b`.
  double item_overlap(std::size_t a, Vec3 by, std::size_t b) const;

  Vec3 middle(std::size_t item) const;                                     // of its mass
  Vec3 half_extents_at(std::size_t item, const Quaternion& turned) const;  // of its box, turned
  Vec3 box_middle(std::size_t item, const Pose& pose) const;
  bool is_target(std::size_t item) const;
  bool in_basket(std::size_t item) const;
  bool in_unloading(std::size_t item) const;

  std::vector<ToolSolid> tool_solids(double opening_m) const;  // tool frame

  // Walls of the basket, station frame.
  std::vector<GraspObstacle> walls() const;
  // For ways: everything but `without`. For lines: the counter and, of the basket, the outer skin
  // for a hand inside (grasps were tested against the walls themselves), whole walls for one
  // outside.
  enum class Hand { inside, outside };
  Surroundings surroundings(const std::vector<std::size_t>& without,
                            Hand hand = Hand::inside) const;
  // The counter alone, for getting away from where something is touched.
  Surroundings counter_alone() const;

 private:
  BoxObstacle counter_top() const;
  void add_item(std::size_t item, Obstacles& obstacles) const;

  const CheckoutWorld& world_;
  const GraspTool& tool_;
  std::vector<GraspSurface> surfaces_;
  std::vector<std::pair<Pose, GraspSurface>> walls_;  // basket_from_wall, and the wall
};

}  // namespace marketgen
