// Who acts in Checkout Unloading.
#include "environments/track_policies.h"
#include "episodes/checkout/checkout_senses.h"
#include "episodes/pictured_products.h"
#include "oracle/checkout_truth.h"
#include "oracle/oracle_checkout.h"
#include "oracle/oracle_scene.h"
#include "policy/classical_checkout.h"

namespace marketgen {
namespace {

// A policy with what it sees and knows.
class SensingPolicy : public WrappedPolicy {
 public:
  SensingPolicy(const CheckoutWorld& world,
                std::shared_ptr<const std::vector<Product>> stock,
                const std::vector<FrictionRow>& frictions,
                LookLibrary& looks)
      : world_(world),
        eyes_(world),
        stock_(std::move(stock)),
        products_(*stock_, frictions),
        looks_(looks) {}

  Result<void> make(const std::filesystem::path& data, const PolicyName& name, Seed seed) {
    MARKETGEN_TRY(tool_, load_checkout_tool(world_, data));
    ClassicalSetup setup;
    setup.eyes = &eyes_;
    setup.products = &products_;
    setup.looks = &looks_;
    setup.robot = &world_.robot();
    setup.tool = tool_;
    setup.place = workplace_of(world_.station());
    setup.modules = true_modules(name);
    MARKETGEN_TRY(policy_, make_classical_checkout(std::move(setup), seed));
    return {};
  }

 private:
  ClassicalModules true_modules(const PolicyName& name) const {
    ClassicalModules modules;
    if (name.knows(TrueModule::masks)) modules.masks = std::make_unique<TrueMasks>(eyes_);
    if (name.knows(TrueModule::target)) modules.targets = std::make_unique<TrueTargets>(world_);
    if (name.knows(TrueModule::grasp)) modules.grasps = std::make_unique<TrueGrasps>(world_, tool_);
    return modules;
  }

  const CheckoutWorld& world_;
  CheckoutEyes eyes_;
  std::shared_ptr<const std::vector<Product>> stock_;
  PicturedProducts products_;
  LookLibrary& looks_;
  GraspTool tool_;
};

}  // namespace

Result<std::unique_ptr<Policy>> make_oracle(Arena& arena, const CheckoutWorld& world, Seed seed) {
  return make_checkout_oracle(world, arena.data(), seed);
}

Result<std::unique_ptr<Policy>> make_classical(Arena& arena,
                                               const CheckoutWorld& world,
                                               const PolicyName& asked,
                                               Seed seed) {
  MARKETGEN_TRY(auto sold, arena.stock(world.spec().scene_hash));
  auto policy = std::make_unique<SensingPolicy>(
      world, std::move(sold), arena.catalog().frictions, arena.looks());
  MARKETGEN_CHECK(policy->make(arena.data(), asked, seed));
  return std::unique_ptr<Policy>(std::move(policy));
}

}  // namespace marketgen
