// Draws episodes of In-Aisle Item Collection from a store, each with a witness: one way to fetch
// all of its goals, planned against everything that stands in the store.
#pragma once
#include <map>
#include <memory>
#include <mutex>

#include "base/seed.h"
#include "collect/collect_plan.h"
#include "episodes/aisle_store.h"
#include "episodes/sample_checkout.h"
#include "robots/grasp_tool.h"

namespace marketgen {

constexpr int least_goals = 2, most_goals = 4;

// For one store. Any number of threads may draw at once: an episode depends on seed and index only.
class AisleSampler {
 public:
  // Errors: those of load_grasp_tool; episode.impossible when too few products stand within reach.
  static Result<std::unique_ptr<AisleSampler>> make(const std::filesystem::path& data,
                                                    std::shared_ptr<const AisleStore> store,
                                                    std::vector<FrictionRow> frictions);

  // Errors: episode.impossible with what was missing; those of plan_collect that are not about one
  // product.
  Result<EpisodeSpec> sample(const EpisodeOrigin& origin, Seed seed, int index);

  // Of the products that were considered so far: those that the grasp study does not hold, by why.
  EpisodeExclusions exclusions() const;

 private:
  struct Witness;
  AisleSampler() = default;
  Result<bool> is_holdable(const Product& product);
  Result<std::optional<WitnessPick>> pick(const std::string& sku, Witness& witness, Seed seed);
  Result<bool> can_drop(const CollectPlan& plan, Witness& witness, Seed seed);
  CategoryPlace category_place(const Product& product) const;
  std::optional<FloorPlace> draw_start(Stream& draw) const;
  Result<std::optional<EpisodeSpec>> attempt(EpisodeSpec spec, Seed seed);

  std::shared_ptr<const AisleStore> store_;
  std::vector<FrictionRow> frictions_;
  GraspTool tool_;
  std::map<std::string, std::vector<const Product*>> shapes_;  // within reach, by archetype
  mutable std::mutex mutex_;
  std::map<std::string, std::string> studied_;  // SKU: "held", or why not
};

}  // namespace marketgen
