// The place of Checkout Unloading as a store: an empty room with the counter in it, and the
// episode's items. What is seen is what is met.
#pragma once
#include <memory>
#include <vector>

#include "episodes/checkout/checkout_station.h"
#include "episodes/episode_goods.h"
#include "episodes/episode_spec.h"
#include "scene/scene.h"

namespace marketgen::episodes {

Pose store_from_station(const CheckoutStation& station);

// Fixture 0 is the counter, product i is item i where the episode begins, `goods[i]` what it is.
// The layout has the episode's name.
std::unique_ptr<scene::Scene> checkout_scene(const CheckoutStation& station,
                                             const EpisodeSpec& spec,
                                             const std::vector<SharedEpisodeGoods>& goods);

}  // namespace marketgen::episodes
