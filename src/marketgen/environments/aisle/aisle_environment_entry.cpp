// How episodes of In-Aisle Item Collection are drawn, opened, and given to learners.
#include "environments/aisle/aisle_environment.h"
#include "environments/aisle/shared_aisle.h"
#include "environments/certify.h"
#include "environments/environment_entry.h"
#include "episodes/aisle/aisle_world.h"
#include "episodes/aisle/sample_aisle.h"

namespace marketgen::environments {
namespace {

class AisleStoreSampler : public StoreSampler {
 public:
  AisleStoreSampler(std::unique_ptr<episodes::AisleSampler> sampler,
                    episodes::EpisodeOrigin origin,
                    std::shared_ptr<const episodes::AisleStore> store,
                    episodes::EpisodeProver prove)
      : sampler_(std::move(sampler)),
        origin_(std::move(origin)),
        store_(std::move(store)),
        prove_(std::move(prove)) {}

  Result<episodes::EpisodeSpec> sample(Seed seed, int index) override {
    return sampler_->sample(origin_, seed, index, prove_);
  }
  const std::vector<catalog::Product>& products() const override { return store_->scene.catalog; }
  episodes::EpisodeExclusions exclusions() const override { return sampler_->exclusions(); }
  Result<episodes::GoalChance> goal_chance(const catalog::Product& product) override {
    return sampler_->goal_chance(product);
  }
  std::vector<episodes::ConsideredProduct> considered() const override {
    return sampler_->considered();
  }
  void consider(const std::vector<episodes::ConsideredProduct>& products) override {
    sampler_->consider(products);
  }

 private:
  std::unique_ptr<episodes::AisleSampler> sampler_;
  episodes::EpisodeOrigin origin_;
  std::shared_ptr<const episodes::AisleStore> store_;
  episodes::EpisodeProver prove_;
};

// All stores have one book: a product that was tried in physics is not tried again.
class AisleSampling : public EpisodeSampler {
 public:
  AisleSampling(Arena& arena,
                std::string tools,
                std::shared_ptr<episodes::GraspBook> book,
                episodes::DrawRules rules)
      : arena_(arena), tools_(std::move(tools)), book_(std::move(book)), rules_(std::move(rules)) {}

  Result<std::unique_ptr<StoreSampler>> of_store(const episodes::EpisodeOrigin& origin) override {
    MARKETGEN_TRY(auto store, shared_aisle_store(arena_, origin.scene_hash, tools_, rules_.doors));
    MARKETGEN_TRY(auto sampler, episodes::AisleSampler::make(store, book_, rules_));
    episodes::EpisodeProver in_physics;
    if (rules_.split == episodes::Split::certified)
      in_physics = [this](const episodes::EpisodeSpec& spec) { return prove(arena_, spec); };
    return std::unique_ptr<StoreSampler>(std::make_unique<AisleStoreSampler>(
        std::move(sampler), origin, std::move(store), std::move(in_physics)));
  }
  Result<void> keep() override { return book_->keep(arena_.data(), arena_.catalog().content_hash); }

 private:
  Arena& arena_;
  std::string tools_;
  std::shared_ptr<episodes::GraspBook> book_;
  episodes::DrawRules rules_;
};

class AisleEnvironmentEntry : public EnvironmentEntry {
 public:
  Result<std::unique_ptr<episodes::TrackWorld>> open(
      Arena& arena,
      const episodes::EpisodeSpec& spec,
      const std::optional<episodes::Perturbation>& perturbation,
      const episodes::Realism& realism) const override {
    MARKETGEN_TRY(auto store,
                  shared_aisle_store(arena, spec.scene_hash, spec.tools, doors_of(spec)));
    auto world =
        std::make_unique<episodes::AisleWorld>(std::move(store), arena.catalog().frictions);
    MARKETGEN_CHECK(world->reset(spec, perturbation, realism));
    return std::unique_ptr<episodes::TrackWorld>(std::move(world));
  }

  Result<std::unique_ptr<Environment>> environment(
      std::shared_ptr<EpisodeGround> ground, const EnvironmentOptions& options) const override {
    return make_aisle_environment(std::move(ground), options);
  }

  Result<std::unique_ptr<EpisodeSampler>> sampler(Arena& arena,
                                                  const std::string& tools,
                                                  const episodes::DrawRules& rules) const override {
    MARKETGEN_TRY(auto book, episodes::open_aisle_book(arena.data(), arena.catalog(), tools));
    return std::unique_ptr<EpisodeSampler>(
        std::make_unique<AisleSampling>(arena, tools, std::move(book), rules));
  }
};

}  // namespace

const EnvironmentEntry& aisle_environment_entry() {
  static const AisleEnvironmentEntry entry;
  return entry;
}

}  // namespace marketgen::environments
