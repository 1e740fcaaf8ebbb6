// Draws episodes of Checkout Unloading from a store's stock.
#pragma once
#include <vector>

#include "base/progress.h"
#include "base/seed.h"
#include "catalog/rows.h"
#include "episodes/episode_spec.h"
#include "scene/scene.h"

namespace marketgen {

constexpr int least_targets = 2, most_targets = 4;
constexpr int least_others = 4, most_others = 8;

// Whether the Panda can be expected to hold it, some way round, as it lies in the basket. What is
// left out, and why, is measured in the probe (docs: robot-tasks.md): flat and wide goods, goods
// wider than the gripper opens, small rounds, long produce, soft packs.
bool is_checkout_item(const Product& product);

// Of the products on the store's shelves, sorted by SKU.
std::vector<Product> checkout_stock(const Scene& scene);

struct EpisodeOrigin {
  std::string store, scene_hash, plan_hash;
};

// Episode `index` of a seed. Targets and others are different products, drawn evenly over shapes;
// dropped into the basket one after another, and settled. What spills is left out; drawn anew when
// too few stay. Errors: episode.impossible (too few kinds of goods); those of CheckoutWorld.
Result<EpisodeSpec> sample_checkout(const std::filesystem::path& data,
                                    const std::vector<Product>& stock,
                                    const std::vector<FrictionRow>& frictions,
                                    const EpisodeOrigin& origin,
                                    Seed seed,
                                    int index);

}  // namespace marketgen
