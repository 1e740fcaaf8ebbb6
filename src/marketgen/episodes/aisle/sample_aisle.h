// Draws episodes of In-Aisle Item Collection from a store. With Split::planned each has a witness:
// one way to fetch all of its goals, planned against everything that stands in the store. With
// Split::certified a wider search may have found it, and a prover tries the whole in physics. With
// Split::paper goals stand in a front row, and a way leads there; with Split::all nothing is asked
// but that the world takes them.
#pragma once
#include <map>
#include <memory>
#include <mutex>

#include "base/seed.h"
#include "collect/collect_plan.h"
#include "episodes/aisle/aisle_store.h"
#include "episodes/aisle/door_book.h"
#include "episodes/aisle/grasp_book.h"
#include "episodes/draw_rules.h"
#include "episodes/episode_journal.h"
#include "episodes/episode_origin.h"
#include "episodes/goal_chance.h"
#include "episodes/goal_words.h"

namespace marketgen::episodes {

constexpr int max_items = max_goal_kinds;  // of a task, all goals together

// For one store. Any number of threads may draw at once: an episode depends on seed and index only.
class AisleSampler {
 public:
  // Error episode.impossible when too few products stand within reach.
  static Result<std::unique_ptr<AisleSampler>> make(std::shared_ptr<const AisleStore> store,
                                                    std::shared_ptr<GraspBook> book,
                                                    DrawRules rules = {});

  // Errors: episode.impossible with what was missing; those of plan_collect and plan_drop that are
  // not about one product; those of `prove`.
  Result<EpisodeSpec> sample(const EpisodeOrigin& origin,
                             Seed seed,
                             int index,
                             const EpisodeProver& prove = {});

  // Whether tasks may ask for a product of the store, and off which fixtures it is taken then. For
  // a sampler of Split::planned. What depends on the neighbours of one item is not looked at: a
  // plan past them may not be found. Errors: those of GraspBook::study.
  Result<GoalChance> goal_chance(const catalog::Product& product);

  // Of the products that were considered so far: those that the grasp study does not hold, or that
  // words do not tell apart from others, by why.
  EpisodeExclusions exclusions() const;
  // These products; and more, which another process considered while it drew for the same store.
  std::vector<ConsideredProduct> considered() const;
  void consider(const std::vector<ConsideredProduct>& products);

 private:
  struct Witness;
  using Shapes = std::map<std::string, std::vector<const catalog::Product*>>;  // by archetype
  AisleSampler() = default;

  // ---- What is asked for: aisle_goals.cpp ----
  static std::size_t count_of(const Shapes& shapes);  // products
  void add_drawn_from();
  const Shapes& shapes_for_next(const EpisodeSpec& spec, bool look_alikes) const;
  bool has_look_alike(const EpisodeSpec& spec) const;
  bool is_drawn_from(const catalog::Product& product) const;
  bool stands_on_levels(const std::string& sku) const;
  std::string why_not_drawn(const catalog::Product& product) const;

  // ---- A way to it ----
  Result<std::vector<int>> grasps_for(const catalog::Product& product);
  std::vector<std::string> shown() const;
  bool is_far_enough(const EpisodeSpec& spec) const;
  std::vector<std::uint32_t> nearest_rows(const std::string& sku, const Vec3& axle) const;
  bool can_be_told(const catalog::Product& product, Seed words);
  Result<int> witnessed(
      const catalog::Product& product, int count, EpisodeSpec& spec, Witness& witness, Seed seed);
  Result<bool> add_goal(
      const catalog::Product& product, int count, EpisodeSpec& spec, Witness& witness, Seed seed);
  Result<std::optional<WitnessPick>> pick(const catalog::Product& product,
                                          const std::vector<int>& grasps,
                                          std::size_t max_rows,
                                          Witness& witness,
                                          Seed seed);
  Result<std::optional<WitnessPick>> pick_wider(const catalog::Product& product,
                                                const std::vector<int>& grasps,
                                                Witness& witness,
                                                Seed seed);
  Result<std::optional<WitnessPick>> pick_row(std::uint32_t row,
                                              const collect::CollectOptions& options,
                                              Witness& witness,
                                              Seed seed,
                                              std::uint64_t number);
  Result<bool> can_drop(const collect::CollectPlan& plan,
                        const OpenDoor& door,
                        Witness& witness,
                        Seed seed);
  CategoryPlace category_place(const catalog::Product& product) const;
  std::optional<motion::FloorPlace> draw_start(Stream& draw) const;
  Result<std::optional<EpisodeSpec>> attempt(EpisodeSpec spec, Seed seed);

  std::shared_ptr<const AisleStore> store_;
  std::shared_ptr<GraspBook> book_;
  std::unique_ptr<DoorBook> doors_;
  DrawRules rules_;
  Offer offer_{std::vector<catalog::Product>{}};  // all that the store sells
  Shapes shapes_, alike_, unlike_;  // within reach: all; with a look-alike beside it; without
  mutable std::mutex mutex_;
  std::map<std::string, std::string> considered_;  // SKU: why it is not held, or empty
};

}  // namespace marketgen::episodes
