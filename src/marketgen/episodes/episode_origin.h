// What the episodes of every track begin with: the store that they are drawn from, and what it
// sells.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/seed.h"
#include "episodes/episode_spec.h"
#include "scene/scene.h"

namespace marketgen::episodes {

struct EpisodeOrigin {
  std::string store, scene_hash, plan_hash;
};

// The beginning of episode `index` of a seed: its id, KIND/SCENE/SEED/INDEX, where it is from, and
// `own`, the seed of what it draws.
EpisodeSpec begun_spec(
    std::string_view kind, const EpisodeOrigin& origin, Seed seed, int index, Seed own);

// Run `number` of an episode, from 1: the first is the episode itself, for others all that is drawn
// while it runs (by the policy, by a realism for noise and goods) is drawn anew.
constexpr int max_repetitions = 1000;
EpisodeSpec repetition_of(EpisodeSpec spec, int number);

// As instructions name it: brand, name, variant, net content.
std::string spoken_product(const catalog::Product& product);

// All that stands on the store's shelves, lies or hangs there, sorted by SKU.
std::vector<catalog::Product> store_stock(const scene::Scene& scene);

}  // namespace marketgen::episodes
