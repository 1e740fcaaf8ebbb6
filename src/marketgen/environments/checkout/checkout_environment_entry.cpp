// How episodes of Checkout Unloading are drawn, opened, and given to learners.
#include "environments/checkout/checkout_environment.h"
#include "environments/environment_entry.h"
#include "episodes/checkout/sample_checkout.h"
#include "oracle/oracle_witness.h"

namespace marketgen {
namespace {

// Immutable: what every basket needs is found when it is made.
class CheckoutStoreSampler : public StoreSampler {
 public:
  CheckoutStoreSampler(const Arena& arena, EpisodeOrigin origin, const Scene& scene)
      : arena_(arena),
        origin_(std::move(origin)),
        stock_(checkout_stock(scene)),
        exclusions_(checkout_exclusions(scene)),
        certify_(checkout_certifier(arena.data())) {}

  Result<EpisodeSpec> sample(Seed seed, int index) override {
    return sample_checkout(
        arena_.data(), stock_, arena_.catalog().frictions, origin_, seed, index, certify_);
  }
  const std::vector<Product>& products() const override { return stock_; }
  EpisodeExclusions exclusions() const override { return exclusions_; }

 private:
  const Arena& arena_;
  EpisodeOrigin origin_;
  std::vector<Product> stock_;
  EpisodeExclusions exclusions_;
  CheckoutCertifier certify_;
};

class CheckoutSampling : public EpisodeSampler {
 public:
  explicit CheckoutSampling(Arena& arena) : arena_(arena) {}
  Result<std::unique_ptr<StoreSampler>> of_store(const EpisodeOrigin& origin) override {
    MARKETGEN_TRY(const auto scene, arena_.scene(origin.scene_hash));
    return std::unique_ptr<StoreSampler>(
        std::make_unique<CheckoutStoreSampler>(arena_, origin, *scene));
  }

 private:
  Arena& arena_;
};

class CheckoutEnvironmentEntry : public EnvironmentEntry {
 public:
  Result<std::unique_ptr<TrackWorld>> open(Arena& arena, const EpisodeSpec& spec) const override {
    MARKETGEN_TRY(
        CheckoutWorld made,
        CheckoutWorld::create(
            arena.data(), arena.catalog().frictions, spec.station.value_or(checkout_station)));
    auto world = std::make_unique<CheckoutWorld>(std::move(made));
    MARKETGEN_CHECK(world->reset(spec, arena.header().products));
    return std::unique_ptr<TrackWorld>(std::move(world));
  }

  Result<std::unique_ptr<Environment>> environment(
      std::shared_ptr<EpisodeGround> ground, const EnvironmentOptions& options) const override {
    return make_checkout_environment(std::move(ground), options);
  }

  Result<std::unique_ptr<EpisodeSampler>> sampler(Arena& arena,
                                                  const std::string& tools) const override {
    if (!tools.empty())
      return Error{
          "usage.bad_flag", "--tools", "only robots in aisles have a choice; drop the flag"};
    return std::unique_ptr<EpisodeSampler>(std::make_unique<CheckoutSampling>(arena));
  }
};

}  // namespace

const EnvironmentEntry& checkout_environment_entry() {
  static const CheckoutEnvironmentEntry entry;
  return entry;
}

}  // namespace marketgen
