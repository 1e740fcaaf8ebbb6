// The truth about a running Checkout Unloading behind the interfaces of `classical`'s modules: put
// in place of one of them, it shows what that one costs. Results that were reached so say so
// (environments/policy_name.h).
#pragma once
#include "episodes/checkout/checkout_senses.h"
#include "perception/grasp_source.h"
#include "perception/target_choice.h"
#include "robots/grasp_tool.h"

namespace marketgen::oracle {

// Every item's pixels in the picture that was taken last. `eyes` must outlive it.
class TrueMasks : public perception::MaskSource {
 public:
  explicit TrueMasks(const episodes::CheckoutEyes& eyes) : eyes_(eyes) {}
  std::vector<perception::Mask> masks(const perception::ViewCloud& cloud,
                                      const std::vector<std::uint8_t>& wanted) const override;

 private:
  const episodes::CheckoutEyes& eyes_;
};

// Where the items lie, seen or not. Of more of one product than are wanted those that are unloaded,
// or else those that show most. `world` must outlive it.
class TrueTargets : public perception::TargetChoice {
 public:
  explicit TrueTargets(const episodes::CheckoutWorld& world) : world_(world) {}
  std::vector<perception::FoundProduct> find(
      const std::vector<perception::WantedProduct>& wanted,
      const std::vector<perception::ViewCloud>& views,
      const std::vector<perception::MaskedView>& masked) const override;

 private:
  const episodes::CheckoutWorld& world_;
};

// The oracle's grasps of the item that lies there, with how deep the hand reaches into others. None
// where no such item lies. Both must outlive it.
class TrueGrasps : public perception::GraspSource {
 public:
  TrueGrasps(const episodes::CheckoutWorld& world, const robots::GraspTool& tool)
      : world_(world), tool_(tool) {}
  Result<std::vector<perception::SeenGrasp>> grasps(
      const perception::GraspQuestion& question) const override;

 private:
  const episodes::CheckoutWorld& world_;
  const robots::GraspTool& tool_;
};

}  // namespace marketgen::oracle
