#include "evaluation/arena.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "episodes/aisle_world.h"
#include "episodes/checkout_world.h"
#include "policy/oracle_aisle.h"
#include "policy/oracle_checkout.h"
#include "policy/random_policy.h"
#include "store/store.h"

namespace marketgen {
namespace {

constexpr std::array<std::string_view, 2> policies{"oracle", "random"};

}  // namespace

Result<std::shared_ptr<const AisleStore>> Arena::aisle_store(const std::string& scene_hash) {
  const std::scoped_lock lock(mutex_);
  if (const auto open = stores_.find(scene_hash); open != stores_.end()) return open->second;
  const auto row = std::ranges::find(header_.stores, scene_hash, &EpisodeStore::scene_hash);
  if (row == header_.stores.end())
    return Error{"episode.other_store", scene_hash, "the header has no store of this scene"};
  MARKETGEN_TRY(Scene scene, scene_of_plan(row->plan, catalog_, row->seed));
  if (const std::string made = marketgen::scene_hash(scene); made != scene_hash)
    return Error{
        "episode.other_store",
        row->name,
        fmt::format("its plan gives scene {}, the episodes are of {}: another catalogue or "
                    "version of marketgen drew them; draw them again",
                    made,
                    scene_hash)};
  MARKETGEN_TRY(auto store, open_aisle_store(data_, std::move(scene)));
  stores_.emplace(scene_hash, store);
  return store;
}

Result<std::unique_ptr<TrackWorld>> Arena::open(const EpisodeSpec& spec) {
  if (spec.track == Track::aisle) {
    MARKETGEN_TRY(auto store, aisle_store(spec.scene_hash));
    auto world = std::make_unique<AisleWorld>(std::move(store), catalog_.frictions);
    MARKETGEN_CHECK(world->reset(spec));
    return std::unique_ptr<TrackWorld>(std::move(world));
  }
  MARKETGEN_TRY(CheckoutWorld made, CheckoutWorld::create(data_, catalog_.frictions));
  auto world = std::make_unique<CheckoutWorld>(std::move(made));
  MARKETGEN_CHECK(world->reset(spec, header_.products));
  return std::unique_ptr<TrackWorld>(std::move(world));
}

Result<std::unique_ptr<Policy>> Arena::policy(const std::string& name,
                                              const TrackWorld& world) const {
  const Seed seed = Seed(world.spec().seed).child(name);
  if (name == "random")
    return std::unique_ptr<Policy>(
        std::make_unique<RandomPolicy>(seed, world.robot().drive.has_value()));
  if (name == "oracle") {
    if (const auto* checkout = dynamic_cast<const CheckoutWorld*>(&world))
      return make_checkout_oracle(*checkout, data_, seed);
    if (const auto* aisle = dynamic_cast<const AisleWorld*>(&world))
      return make_aisle_oracle(*aisle, data_, seed);
  }
  return Error{
      "usage.bad_flag",
      "--policy",
      fmt::format("there is no policy \"{}\"; there are: {}", name, fmt::join(policies, ", "))};
}

}  // namespace marketgen
