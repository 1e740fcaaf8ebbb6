// The truth about a running In-Aisle Item Collection behind the interfaces of `classical`'s
// modules; see oracle/checkout_truth.h. What stands farther away than the boards that were
// given, or in none of the pictures, is not told: the search stays the planner's.
#pragma once
#include "episodes/aisle/aisle_world.h"
#include "perception/shelf_choice.h"
#include "perception/shelf_grasps.h"
#include "robots/grasp_tool.h"

namespace marketgen {

// Where packs stand at the front of the boards, of whatever product. `world` must outlive it.
class TrueSpots : public SpotSource {
 public:
  explicit TrueSpots(const AisleWorld& world) : world_(world) {}
  std::vector<ShelfSpot> spots(const std::vector<ViewCloud>& views,
                               const std::vector<BoardAhead>& boards,
                               Vec3f size) const override;

 private:
  const AisleWorld& world_;
};

// Which packs are the product. `world` must outlive it.
class TrueShelfChoice : public ShelfChoice {
 public:
  explicit TrueShelfChoice(const AisleWorld& world) : world_(world) {}
  std::vector<FoundOnShelf> find(const WantedProduct& wanted,
                                 const std::vector<ViewCloud>& views,
                                 const std::vector<BoardAhead>& boards,
                                 const std::vector<ShelfSpot>& spots) const override;
  FittedPose again(const ProductLook& look,
                   const std::vector<ViewCloud>& views,
                   const Pose& base_from_product) const override;

 private:
  const AisleWorld& world_;
};

// The grasps by which the episode's witness would have it taken, of the pack that stands there, in
// the store frame. None where no such pack stands. Both must outlive it.
class TrueShelfGrasps : public ShelfGraspSource {
 public:
  TrueShelfGrasps(const AisleWorld& world, const GraspTool& tool) : world_(world), tool_(tool) {}
  Result<std::vector<SeenGrasp>> grasps(const ShelfGraspQuestion& question) const override;

 private:
  const AisleWorld& world_;
  const GraspTool& tool_;
};

}  // namespace marketgen
