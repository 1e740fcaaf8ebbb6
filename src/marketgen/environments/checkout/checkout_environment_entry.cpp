// How episodes of Checkout Unloading are drawn, opened, and given to learners.
#include "environments/certify.h"
#include "environments/checkout/checkout_environment.h"
#include "environments/checkout/shared_lane.h"
#include "environments/environment_entry.h"
#include "episodes/checkout/checkout_lanes.h"
#include "episodes/checkout/sample_checkout.h"
#include "oracle/oracle_witness.h"

namespace marketgen::environments {
namespace {

// Immutable: what every basket needs is found when it is made.
class CheckoutStoreSampler : public StoreSampler {
 public:
  CheckoutStoreSampler(Arena& arena,
                       episodes::EpisodeOrigin origin,
                       const scene::Scene& scene,
                       const episodes::CheckoutStation& station,
                       episodes::CheckoutHand hand,
                       episodes::DrawRules rules)
      : arena_(arena),
        origin_(std::move(origin)),
        rules_(std::move(rules)),
        hand_(std::move(hand)),
        stock_(episodes::checkout_stock(scene)),
        lanes_(episodes::checkout_lanes(scene, arena.catalog(), station)),
        exclusions_(episodes::checkout_exclusions(scene, hand_, rules_.trained_on)) {
    exclusions_.lanes = lanes_.left_out;
    if (rules_.split == episodes::Split::planned || rules_.split == episodes::Split::certified)
      certify_ = oracle::checkout_certifier(arena.data());
    if (rules_.split == episodes::Split::certified)
      prove_ = [this](const episodes::EpisodeSpec& spec) {
        return prove(arena_, episodes::at_a_lane(spec, lanes_));
      };
  }

  // Poured and shown to be possible in the room: at a lane that suits there is nothing more that
  // the arm could meet. In physics it is tried at the lane.
  Result<episodes::EpisodeSpec> sample(Seed seed, int index) override {
    MARKETGEN_TRY(auto drawn,
                  episodes::sample_checkout(arena_.data(),
                                            stock_,
                                            arena_.catalog().frictions,
                                            origin_,
                                            seed,
                                            index,
                                            certify_,
                                            prove_,
                                            rules_,
                                            hand_));
    return episodes::at_a_lane(std::move(drawn), lanes_);
  }
  const std::vector<catalog::Product>& products() const override { return stock_; }
  episodes::EpisodeExclusions exclusions() const override { return exclusions_; }
  Result<episodes::GoalChance> goal_chance(const catalog::Product& product) override {
    const episodes::CheckoutRefusal why = hand_.refusal(product);
    return episodes::GoalChance{why == episodes::CheckoutRefusal::none ? ""
                                                                       : std::string(name_of(why))};
  }

 private:
  Arena& arena_;
  episodes::EpisodeOrigin origin_;
  episodes::DrawRules rules_;
  episodes::CheckoutHand hand_;
  std::vector<catalog::Product> stock_;
  episodes::CheckoutLanes lanes_;
  episodes::EpisodeExclusions exclusions_;
  episodes::CheckoutCertifier certify_;
  episodes::EpisodeProver prove_;
};

class CheckoutSampling : public EpisodeSampler {
 public:
  CheckoutSampling(Arena& arena, std::string tools, episodes::DrawRules rules)
      : arena_(arena), tools_(std::move(tools)), rules_(std::move(rules)) {}
  Result<std::unique_ptr<StoreSampler>> of_store(const episodes::EpisodeOrigin& origin) override {
    MARKETGEN_TRY(const auto scene, arena_.scene(origin.scene_hash));
    MARKETGEN_TRY(
        const auto station,
        episodes::load_checkout_station(arena_.data(), episodes::station_or_own(rules_.station)));
    MARKETGEN_TRY(episodes::CheckoutHand hand,
                  episodes::checkout_hand(arena_.data(),
                                          arena_.catalog().frictions,
                                          episodes::store_stock(*scene),
                                          tools_,
                                          rules_.station));
    return std::unique_ptr<StoreSampler>(std::make_unique<CheckoutStoreSampler>(
        arena_, origin, *scene, station, std::move(hand), rules_));
  }

 private:
  Arena& arena_;
  std::string tools_;
  episodes::DrawRules rules_;
};

class CheckoutEnvironmentEntry : public EnvironmentEntry {
 public:
  Result<std::unique_ptr<episodes::TrackWorld>> open(
      Arena& arena,
      const episodes::EpisodeSpec& spec,
      const std::optional<episodes::Perturbation>& perturbation,
      const episodes::Realism& realism) const override {
    MARKETGEN_TRY(episodes::CheckoutWorld made,
                  episodes::CheckoutWorld::create(arena.data(),
                                                  arena.catalog().frictions,
                                                  spec.station.value_or(episodes::checkout_station),
                                                  spec.tools));
    auto world = std::make_unique<episodes::CheckoutWorld>(std::move(made));
    MARKETGEN_TRY(auto lane, shared_lane(arena, world->station(), spec));
    MARKETGEN_CHECK(world->reset(spec, arena.products(), std::move(lane), perturbation, realism));
    return std::unique_ptr<episodes::TrackWorld>(std::move(world));
  }

  Result<std::unique_ptr<Environment>> environment(
      std::shared_ptr<EpisodeGround> ground, const EnvironmentOptions& options) const override {
    return make_checkout_environment(std::move(ground), options);
  }

  Result<std::unique_ptr<EpisodeSampler>> sampler(Arena& arena,
                                                  const std::string& tools,
                                                  const episodes::DrawRules& rules) const override {
    MARKETGEN_CHECK(episodes::load_checkout_station(
        arena.data(), episodes::station_or_own(rules.station), tools));
    return std::unique_ptr<EpisodeSampler>(std::make_unique<CheckoutSampling>(arena, tools, rules));
  }
};

}  // namespace

const EnvironmentEntry& checkout_environment_entry() {
  static const CheckoutEnvironmentEntry entry;
  return entry;
}

}  // namespace marketgen::environments
