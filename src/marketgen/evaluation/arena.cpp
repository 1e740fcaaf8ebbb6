#include "evaluation/arena.h"

#include <algorithm>

#include <fmt/format.h>

#include "catalog/user_products.h"
#include "collect/collect_plan.h"
#include "episodes/aisle_world.h"
#include "episodes/checkout_world.h"
#include "episodes/sample_checkout.h"
#include "evaluation/aisle_senses.h"
#include "evaluation/aisle_truth.h"
#include "evaluation/checkout_senses.h"
#include "evaluation/checkout_truth.h"
#include "evaluation/policy_name.h"
#include "oracle/oracle_aisle.h"
#include "oracle/oracle_checkout.h"
#include "oracle/oracle_scene.h"
#include "policy/classical_aisle.h"
#include "policy/classical_checkout.h"
#include "policy/random_policy.h"

namespace marketgen {
namespace {

// A policy that needs things that live as long as it does.
class WrappedPolicy : public Policy {
 public:
  Result<void> begin(const Task& task, const Observation& first) override {
    return policy_->begin(task, first);
  }
  Result<Action> act(const Observation& now) override { return policy_->act(now); }
  std::string failure() const override { return policy_->failure(); }

 protected:
  std::unique_ptr<Policy> policy_;
};

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

// The same in a store.
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

void Arena::offer(std::shared_ptr<const Store> store) {
  const std::scoped_lock lock(mutex_);
  offered_[store->manifest.scene_hash] = std::move(store);
}

Result<Scene> Arena::scene_of(const std::string& scene_hash) const {
  if (const auto offered = offered_.find(scene_hash); offered != offered_.end())
    return offered->second->scene;
  const auto row = std::ranges::find(header_.stores, scene_hash, &EpisodeStore::scene_hash);
  if (row == header_.stores.end())
    return Error{"episode.other_store", scene_hash, "the header has no store of this scene"};
  MARKETGEN_TRY(Scene scene,
                row->own
                    ? scene_of_plan(row->plan, with_own_products(catalog_, *row->own), row->seed)
                    : scene_of_plan(row->plan, catalog_, row->seed));
  if (const std::string made = marketgen::scene_hash(scene); made != scene_hash)
    return Error{
        "episode.other_store",
        row->name,
        fmt::format("its plan gives scene {}, the episodes are of {}: another catalogue or "
                    "version of marketgen drew them; draw them again",
                    made,
                    scene_hash)};
  return scene;
}

Result<std::shared_ptr<const AisleStore>> Arena::aisle_store(const std::string& scene_hash,
                                                             const std::string& tools) {
  const std::scoped_lock lock(mutex_);
  if (const auto open = stores_.find({scene_hash, tools}); open != stores_.end())
    return open->second;
  MARKETGEN_TRY(Scene scene, scene_of(scene_hash));
  MARKETGEN_TRY(auto store, open_aisle_store(data_, std::move(scene), tools));
  stores_.emplace(std::pair{scene_hash, tools}, store);
  return store;
}

Result<std::shared_ptr<const std::vector<Product>>> Arena::stock(const std::string& scene_hash) {
  const std::scoped_lock lock(mutex_);
  auto& stock = stocks_[scene_hash];
  if (!stock) {
    MARKETGEN_TRY(const Scene scene, scene_of(scene_hash));
    stock = std::make_shared<const std::vector<Product>>(store_stock(scene));
  }
  return stock;
}

Result<std::unique_ptr<TrackWorld>> Arena::open(const EpisodeSpec& spec) {
  if (spec.track == Track::aisle) {
    MARKETGEN_TRY(auto store, aisle_store(spec.scene_hash, spec.tools));
    auto world = std::make_unique<AisleWorld>(std::move(store), catalog_.frictions);
    MARKETGEN_CHECK(world->reset(spec));
    return std::unique_ptr<TrackWorld>(std::move(world));
  }
  MARKETGEN_TRY(
      CheckoutWorld made,
      CheckoutWorld::create(data_, catalog_.frictions, spec.station.value_or(checkout_station)));
  auto world = std::make_unique<CheckoutWorld>(std::move(made));
  MARKETGEN_CHECK(world->reset(spec, header_.products));
  return std::unique_ptr<TrackWorld>(std::move(world));
}

Result<std::unique_ptr<Policy>> Arena::policy(const std::string& name, const TrackWorld& world) {
  MARKETGEN_TRY(const PolicyName asked, read_policy_name(name));
  const Seed seed = Seed(world.spec().seed).child(asked.name);
  if (asked.name == "random")
    return std::unique_ptr<Policy>(
        std::make_unique<RandomPolicy>(seed, world.robot().drive.has_value()));
  const auto* checkout = dynamic_cast<const CheckoutWorld*>(&world);
  const auto* aisle = dynamic_cast<const AisleWorld*>(&world);
  if (asked.name == "oracle" && checkout != nullptr)
    return make_checkout_oracle(*checkout, data_, seed);
  if (asked.name == "oracle" && aisle != nullptr) return make_aisle_oracle(*aisle, data_, seed);
  if (checkout != nullptr) {
    MARKETGEN_TRY(auto sold, stock(world.spec().scene_hash));
    auto policy =
        std::make_unique<SensingPolicy>(*checkout, std::move(sold), catalog_.frictions, looks_);
    MARKETGEN_CHECK(policy->make(data_, asked, seed));
    return std::unique_ptr<Policy>(std::move(policy));
  }
  if (aisle != nullptr) {
    auto policy = std::make_unique<SensingCollector>(*aisle, catalog_.frictions, looks_);
    MARKETGEN_CHECK(policy->make(data_, asked, seed));
    return std::unique_ptr<Policy>(std::move(policy));
  }
  return Error{
      "usage.bad_flag",
      "--policy",
      fmt::format(
          "there is no policy \"{}\" for the track {}", asked.name, name_of(world.spec().track))};
}

}  // namespace marketgen
