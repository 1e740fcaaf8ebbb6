// What the oracle knows of a running Checkout Unloading: everything, as shapes.
#pragma once
#include <filesystem>
#include <vector>

#include "episodes/checkout/checkout_world.h"
#include "robots/grasp_tool.h"
#include "skills/arm_executor.h"
#include "skills/counter_obstacles.h"
#include "skills/hand_grasp.h"
#include "skills/hand_room.h"

namespace marketgen::oracle {

// Of the tool that the counter's robot carries. Errors: of load_grasp_tool.
Result<robots::GraspTool> load_checkout_tool(const episodes::CheckoutWorld& world,
                                             const std::filesystem::path& data);

// What a cup holds it carries slowly: more peels packs off. Errors: of ArmExecutor::make.
Result<skills::ArmExecutor> make_checkout_arm(const episodes::CheckoutWorld& world,
                                              const robots::GraspTool& tool);

class OracleScene {
 public:
  // Both must outlive it. The world is reset before.
  OracleScene(const episodes::CheckoutWorld& world, const robots::GraspTool& tool);

  const episodes::CheckoutWorld& world() const { return world_; }
  const robots::GraspTool& tool() const { return tool_; }
  std::size_t items() const { return world_.item_count(); }

  // ---- As things stand now; station frame. ----
  agent::Workplace place() const;
  skills::PlacedBody body(std::size_t item) const;
  std::vector<skills::PlacedBody> walls() const;  // of the basket, and its ledges
  skills::LyingPack lying(std::size_t item) const;
  double rim_z_m() const { return world_.station().basket.height_m; }

  // How deep points of item `a`, moved by `by`, lie in item `b`.
  double item_overlap(std::size_t a, Vec3 by, std::size_t b) const;

  Vec3 middle(std::size_t item) const { return lying(item).middle(); }     // of its mass
  Vec3 half_extents_at(std::size_t item, const Quaternion& turned) const;  // of its box, turned
  Vec3 box_middle(std::size_t item, const Pose& pose) const;
  bool is_target(std::size_t item) const;
  bool in_basket(std::size_t item) const;
  bool in_unloading(std::size_t item) const;

  // Everything but `without`.
  skills::Surroundings surroundings(const std::vector<std::size_t>& without,
                                    skills::HandAt hand = skills::HandAt::basket) const;

 private:
  const episodes::CheckoutWorld& world_;
  const robots::GraspTool& tool_;
  agent::Workplace place_;                      // as it was at first
  std::vector<motion::GraspSurface> surfaces_;  // of the items
  skills::BasketWalls walls_;
};

}  // namespace marketgen::oracle
