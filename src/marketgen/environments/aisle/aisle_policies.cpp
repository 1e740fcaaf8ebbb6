// Who acts in In-Aisle Item Collection.
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "collect/collect_plan.h"
#include "environments/goal_readers.h"
#include "environments/mark_questioner.h"
#include "environments/part_servers.h"
#include "environments/track_policies.h"
#include "episodes/aisle/aisle_senses.h"
#include "episodes/episode_origin.h"
#include "episodes/pictured_products.h"
#include "oracle/aisle_truth.h"
#include "oracle/oracle_aisle.h"
#include "perception/model_shelf.h"
#include "perception/served_grasps.h"
#include "policy/classical_aisle.h"

namespace marketgen::environments {
namespace {

// A policy with what it sees and knows, in a store.
class SensingCollector : public WrappedPolicy {
 public:
  SensingCollector(const episodes::AisleWorld& world,
                   std::shared_ptr<const std::vector<catalog::Product>> stock,
                   const catalog::Catalog& catalog,
                   perception::LookLibrary& looks)
      : world_(world),
        eyes_(world),
        stock_(std::move(stock)),
        catalog_(catalog),
        products_(world.store().scene.catalog, catalog.frictions),
        looks_(looks) {}

  Result<void> make(Arena& arena, const PolicyName& name, Seed seed) {
    MARKETGEN_TRY(questioner_, mark_questioner(name, arena));
    MARKETGEN_TRY(servers_, part_servers(name, arena));
    const episodes::AisleStore& store = world_.store();
    MARKETGEN_TRY(const std::string row, collect::gripper_row(store.robot));
    MARKETGEN_TRY(tool_, robots::load_grasp_tool(arena.data(), row));
    MARKETGEN_TRY(mapped_, world_.mapped());
    map_.emplace(*mapped_);
    policy::ClassicalAisleSetup setup;
    setup.eyes = &eyes_;
    setup.products = &products_;
    setup.looks = &looks_;
    setup.tool = tool_;
    setup.hints = episodes::category_hints(world_.spec());
    setup.body = {
        &store.robot, &*map_, store.basket, store.driving, episodes::commanded_dofs(store.robot)};
    setup.modules = modules_of(name);
    policy_ = policy::make_classical_aisle(std::move(setup), seed);
    return {};
  }

  std::optional<agent::ModelUse> model_use() const override {
    return questioner_ ? std::optional(questioner_->use()) : std::nullopt;
  }
  std::optional<agent::PartsUse> parts_use() const override { return servers_.use(); }

 private:
  policy::ClassicalAisleModules modules_of(const PolicyName& name) const {
    policy::ClassicalAisleModules modules;
    modules.language = goal_reader(name, world_.spec(), *stock_, catalog_);
    if (servers_.grasps)
      modules.grasps = std::make_unique<perception::ServedShelfGrasps>(tool_, servers_.grasps);
    if (name.knows(TrueModule::masks)) modules.spots = std::make_unique<oracle::TrueSpots>(world_);
    if (name.knows(TrueModule::target))
      modules.choice = std::make_unique<oracle::TrueShelfChoice>(world_);
    if (questioner_)
      modules.choice = std::make_unique<perception::ModelShelfChoice>(
          questioner_, std::make_unique<perception::UprightMatching>(), product_words(stock_));
    if (name.knows(TrueModule::grasp))
      modules.grasps = std::make_unique<oracle::TrueShelfGrasps>(world_, tool_);
    return modules;
  }

  const episodes::AisleWorld& world_;
  episodes::AisleEyes eyes_;
  std::shared_ptr<const episodes::AisleStore> mapped_;
  std::optional<episodes::StoreMap> map_;                       // of it
  std::shared_ptr<const std::vector<catalog::Product>> stock_;  // what is read from
  const catalog::Catalog& catalog_;
  episodes::PicturedProducts products_;
  perception::LookLibrary& looks_;
  robots::GraspTool tool_;
  std::shared_ptr<perception::MarkQuestioner> questioner_;  // of a policy that has a model
  PartServers servers_;
};

}  // namespace

Result<std::unique_ptr<agent::Policy>> make_oracle(Arena& arena,
                                                   const episodes::AisleWorld& world,
                                                   const oracle::OracleSearch& search,
                                                   Seed seed) {
  return oracle::make_aisle_oracle(world, arena.data(), seed, search);
}

Result<std::unique_ptr<agent::Policy>> make_classical(Arena& arena,
                                                      const episodes::AisleWorld& world,
                                                      const PolicyName& asked,
                                                      Seed seed) {
  if (!asked.masks_url.empty())
    return Error{"usage.bad_flag",
                 "--masks-url",
                 fmt::format("{}: in the aisles places on boards stand in the place of masks; "
                             "hybrid has --grasps-url and --model there",
                             world.spec().id)};
  auto stock = std::make_shared<const std::vector<catalog::Product>>(
      episodes::store_stock(world.store().scene));
  auto policy =
      std::make_unique<SensingCollector>(world, std::move(stock), arena.catalog(), arena.looks());
  MARKETGEN_CHECK(policy->make(arena, asked, seed));
  return std::unique_ptr<agent::Policy>(std::move(policy));
}

Result<std::unique_ptr<agent::Policy>> make_highest(Arena&,
                                                    const episodes::AisleWorld& world,
                                                    Seed) {
  return Error{"usage.bad_flag",
               "--policy",
               fmt::format("{}: highest lifts goods out of a basket on a counter; in the aisles "
                           "the blind policies are random and stop",
                           world.spec().id)};
}

}  // namespace marketgen::environments
