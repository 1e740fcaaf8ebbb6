// Who acts in In-Aisle Item Collection.
#include "collect/collect_plan.h"
#include "environments/track_policies.h"
#include "episodes/aisle/aisle_senses.h"
#include "episodes/pictured_products.h"
#include "oracle/aisle_truth.h"
#include "oracle/oracle_aisle.h"
#include "policy/classical_aisle.h"

namespace marketgen {
namespace {

// A policy with what it sees and knows, in a store.
class SensingCollector : public WrappedPolicy {
 public:
  SensingCollector(const AisleWorld& world,
                   const std::vector<FrictionRow>& frictions,
                   LookLibrary& looks)
      : world_(world),
        eyes_(world),
        map_(world.store()),
        products_(world.store().scene.catalog, frictions),
        looks_(looks) {}

  Result<void> make(const std::filesystem::path& data, const PolicyName& name, Seed seed) {
    const AisleStore& store = world_.store();
    MARKETGEN_TRY(const std::string row, gripper_row(store.robot));
    MARKETGEN_TRY(tool_, load_grasp_tool(data, row));
    ClassicalAisleSetup setup;
    setup.eyes = &eyes_;
    setup.products = &products_;
    setup.looks = &looks_;
    setup.tool = tool_;
    setup.hints = category_hints(world_.spec());
    setup.body = {&store.robot, &map_, store.basket, store.driving, commanded_dofs(store.robot)};
    setup.modules = true_modules(name);
    policy_ = make_classical_aisle(std::move(setup), seed);
    return {};
  }

 private:
  ClassicalAisleModules true_modules(const PolicyName& name) const {
    ClassicalAisleModules modules;
    if (name.knows(TrueModule::masks)) modules.spots = std::make_unique<TrueSpots>(world_);
    if (name.knows(TrueModule::target)) modules.choice = std::make_unique<TrueShelfChoice>(world_);
    if (name.knows(TrueModule::grasp))
      modules.grasps = std::make_unique<TrueShelfGrasps>(world_, tool_);
    return modules;
  }

  const AisleWorld& world_;
  AisleEyes eyes_;
  StoreMap map_;
  PicturedProducts products_;
  LookLibrary& looks_;
  GraspTool tool_;
};

}  // namespace

Result<std::unique_ptr<Policy>> make_oracle(Arena& arena, const AisleWorld& world, Seed seed) {
  return make_aisle_oracle(world, arena.data(), seed);
}

Result<std::unique_ptr<Policy>> make_classical(Arena& arena,
                                               const AisleWorld& world,
                                               const PolicyName& asked,
                                               Seed seed) {
  auto policy = std::make_unique<SensingCollector>(world, arena.catalog().frictions, arena.looks());
  MARKETGEN_CHECK(policy->make(arena.data(), asked, seed));
  return std::unique_ptr<Policy>(std::move(policy));
}

}  // namespace marketgen
