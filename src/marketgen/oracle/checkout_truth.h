// The truth about a running Checkout Unloading behind the interfaces of `classical`'s modules: put
// in place of one of them, it shows what that one costs. Results that were reached so say so
// (environments/policy_name.h).
#pragma once
#include "episodes/checkout/checkout_senses.h"
#include "perception/grasp_source.h"
#include "perception/target_choice.h"
#include "robots/grasp_tool.h"

namespace marketgen {

// Every item's pixels in the picture that was taken last. `eyes` must outlive it.
class TrueMasks : public MaskSource {
 public:
  explicit TrueMasks(const CheckoutEyes& eyes) : eyes_(eyes) {}
  std::vector<Mask> masks(const ViewCloud& cloud,
                          const std::vector<std::uint8_t>& wanted) const override;

 private:
  const CheckoutEyes& eyes_;
};

// Where the items lie, seen or not. Of several of one product the one that is unloaded, or else the
// one that shows most. `world` must outlive it.
class TrueTargets : public TargetChoice {
 public:
  explicit TrueTargets(const CheckoutWorld& world) : world_(world) {}
  std::vector<FoundProduct> find(const std::vector<WantedProduct>& wanted,
                                 const std::vector<ViewCloud>& views,
                                 const std::vector<MaskedView>& masked) const override;

 private:
  const CheckoutWorld& world_;
};

// The oracle's grasps of the item that lies there, with how deep the hand reaches into others. None
// where no such item lies. Both must outlive it.
class TrueGrasps : public GraspSource {
 public:
  TrueGrasps(const CheckoutWorld& world, const GraspTool& tool) : world_(world), tool_(tool) {}
  Result<std::vector<SeenGrasp>> grasps(const GraspQuestion& question) const override;

 private:
  const CheckoutWorld& world_;
  const GraspTool& tool_;
};

}  // namespace marketgen
