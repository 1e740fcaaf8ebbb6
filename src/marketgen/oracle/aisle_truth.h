// The truth about a running In-Aisle Item Collection behind the interfaces of `classical`'s
// modules; see oracle/checkout_truth.h. What stands farther away than the boards that were
// given, or in none of the pictures, is not told: the search stays the planner's.
#pragma once
#include "episodes/aisle/aisle_world.h"
#include "perception/shelf_choice.h"
#include "perception/shelf_grasps.h"
#include "robots/grasp_tool.h"

namespace marketgen::oracle {

// Where packs stand at the front of the boards, of whatever product. `world` must outlive it.
class TrueSpots : public perception::SpotSource {
 public:
  explicit TrueSpots(const episodes::AisleWorld& world) : world_(world) {}
  std::vector<perception::ShelfSpot> spots(const std::vector<perception::ViewCloud>& views,
                                           const std::vector<perception::BoardAhead>& boards,
                                           Vec3f size) const override;

 private:
  const episodes::AisleWorld& world_;
};

// Which packs are the product. `world` must outlive it.
class TrueShelfChoice : public perception::ShelfChoice {
 public:
  explicit TrueShelfChoice(const episodes::AisleWorld& world) : world_(world) {}
  std::vector<perception::FoundOnShelf> find(
      const perception::WantedProduct& wanted,
      const std::vector<perception::ViewCloud>& views,
      const std::vector<perception::BoardAhead>& boards,
      const std::vector<perception::ShelfSpot>& spots) const override;
  perception::FittedPose again(const perception::WantedProduct& wanted,
                               const std::vector<perception::ViewCloud>& views,
                               const Pose& base_from_product) const override;

 private:
  const episodes::AisleWorld& world_;
};

// The grasps by which the episode's witness would have it taken, of the pack that stands there, in
// the store frame. None where no such pack stands. Both must outlive it.
class TrueShelfGrasps : public perception::ShelfGraspSource {
 public:
  TrueShelfGrasps(const episodes::AisleWorld& world, const robots::GraspTool& tool)
      : world_(world), tool_(tool) {}
  Result<std::vector<perception::SeenGrasp>> grasps(
      const perception::ShelfGraspQuestion& question) const override;

 private:
  const episodes::AisleWorld& world_;
  const robots::GraspTool& tool_;
};

}  // namespace marketgen::oracle
