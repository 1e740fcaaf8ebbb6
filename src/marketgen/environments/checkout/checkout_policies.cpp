// Who acts in Checkout Unloading.
#include <optional>

#include <fmt/format.h>

#include "environments/goal_readers.h"
#include "environments/mark_questioner.h"
#include "environments/part_servers.h"
#include "environments/track_policies.h"
#include "episodes/checkout/checkout_senses.h"
#include "episodes/pictured_products.h"
#include "oracle/checkout_truth.h"
#include "oracle/oracle_checkout.h"
#include "oracle/oracle_scene.h"
#include "perception/served_grasps.h"
#include "perception/served_masks.h"
#include "policy/classical_checkout.h"
#include "policy/highest_first.h"

namespace marketgen::environments {
namespace {

// A policy with what it sees and knows.
class SensingPolicy : public WrappedPolicy {
 public:
  SensingPolicy(const episodes::CheckoutWorld& world,
                std::shared_ptr<const std::vector<catalog::Product>> stock,
                const catalog::Catalog& catalog,
                perception::LookLibrary& looks)
      : world_(world),
        eyes_(world),
        stock_(std::move(stock)),
        catalog_(catalog),
        products_(*stock_, catalog.frictions),
        looks_(looks) {}

  Result<void> make(Arena& arena, const PolicyName& name, Seed seed) {
    MARKETGEN_TRY(questioner_, mark_questioner(name, arena));
    MARKETGEN_TRY(servers_, part_servers(name, arena));
    MARKETGEN_TRY(tool_, oracle::load_checkout_tool(world_, arena.data()));
    policy::ClassicalSetup setup;
    setup.eyes = &eyes_;
    setup.products = &products_;
    setup.looks = &looks_;
    setup.robot = &world_.robot();
    setup.tool = tool_;
    place_ = setup.place = episodes::workplace_of(world_.station());
    setup.modules = modules_of(name);
    MARKETGEN_TRY(policy_, policy::make_classical_checkout(std::move(setup), seed));
    return {};
  }

  std::optional<agent::ModelUse> model_use() const override {
    return questioner_ ? std::optional(questioner_->use()) : std::nullopt;
  }
  std::optional<agent::PartsUse> parts_use() const override { return servers_.use(); }

 private:
  policy::ClassicalModules modules_of(const PolicyName& name) const {
    policy::ClassicalModules modules;
    modules.language = goal_reader(name, world_.spec(), *stock_, catalog_);
    if (servers_.masks)
      modules.masks = std::make_unique<perception::ServedMasks>(
          servers_.masks, std::make_unique<perception::GeometricMasks>());
    if (servers_.grasps)
      modules.grasps = std::make_unique<perception::ServedGrasps>(tool_, place_, servers_.grasps);
    if (name.knows(TrueModule::masks)) modules.masks = std::make_unique<oracle::TrueMasks>(eyes_);
    if (name.knows(TrueModule::target))
      modules.targets = std::make_unique<oracle::TrueTargets>(world_);
    if (questioner_) {
      modules.poses = std::make_unique<perception::SweptPoses>();
      modules.targets = std::make_unique<perception::ModelTargets>(
          questioner_,
          *modules.poses,
          std::make_unique<perception::CatalogueMatching>(*modules.poses),
          product_words(stock_));
    }
    if (name.knows(TrueModule::grasp))
      modules.grasps = std::make_unique<oracle::TrueGrasps>(world_, tool_);
    return modules;
  }

  const episodes::CheckoutWorld& world_;
  episodes::CheckoutEyes eyes_;
  std::shared_ptr<const std::vector<catalog::Product>> stock_;
  const catalog::Catalog& catalog_;
  episodes::PicturedProducts products_;
  perception::LookLibrary& looks_;
  robots::GraspTool tool_;
  agent::Workplace place_;
  std::shared_ptr<perception::MarkQuestioner> questioner_;  // of a policy that has a model
  PartServers servers_;
};

// The policy that sees heights alone, with its eyes.
class HeightsPolicy : public WrappedPolicy {
 public:
  explicit HeightsPolicy(const episodes::CheckoutWorld& world) : world_(world), eyes_(world) {}

  Result<void> make(const std::filesystem::path& data, Seed seed) {
    MARKETGEN_TRY(robots::GraspTool tool, oracle::load_checkout_tool(world_, data));
    MARKETGEN_TRY(
        policy_,
        policy::make_highest_first(
            {&eyes_, &world_.robot(), std::move(tool), episodes::workplace_of(world_.station())},
            seed));
    return {};
  }

 private:
  const episodes::CheckoutWorld& world_;
  episodes::CheckoutEyes eyes_;
};

// Who sees looks for faces between which fingers fit.
Result<void> check_has_gripper(const episodes::CheckoutWorld& world, const std::string& policy) {
  if (world.robot().tools.front().kind == robots::ToolKind::gripper) return {};
  return Error{
      "usage.bad_flag",
      "--policy",
      fmt::format("at the counter \"{}\" grasps with a gripper alone, and the episode \"{}\" "
                  "is for the tools \"{}\": take an oracle, or a policy of your own",
                  policy,
                  world.spec().id,
                  world.station().tools().id)};
}

}  // namespace

Result<std::unique_ptr<agent::Policy>> make_oracle(Arena& arena,
                                                   const episodes::CheckoutWorld& world,
                                                   const oracle::OracleSearch& search,
                                                   Seed seed) {
  return oracle::make_checkout_oracle(world, arena.data(), seed, search);
}

Result<std::unique_ptr<agent::Policy>> make_classical(Arena& arena,
                                                      const episodes::CheckoutWorld& world,
                                                      const PolicyName& asked,
                                                      Seed seed) {
  MARKETGEN_CHECK(check_has_gripper(world, asked.name));
  MARKETGEN_TRY(auto sold, arena.stock(world.spec().scene_hash));
  auto policy =
      std::make_unique<SensingPolicy>(world, std::move(sold), arena.catalog(), arena.looks());
  MARKETGEN_CHECK(policy->make(arena, asked, seed));
  return std::unique_ptr<agent::Policy>(std::move(policy));
}

Result<std::unique_ptr<agent::Policy>> make_highest(Arena& arena,
                                                    const episodes::CheckoutWorld& world,
                                                    Seed seed) {
  MARKETGEN_CHECK(check_has_gripper(world, "highest"));
  auto policy = std::make_unique<HeightsPolicy>(world);
  MARKETGEN_CHECK(policy->make(arena.data(), seed));
  return std::unique_ptr<agent::Policy>(std::move(policy));
}

}  // namespace marketgen::environments
