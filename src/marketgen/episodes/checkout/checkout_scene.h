// The place of Checkout Unloading as a store: a checkout lane with what is round it, or an empty
// room; the robot's counter in it, and the episode's items. What is seen is what is met.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "episodes/checkout/checkout_station.h"
#include "episodes/episode_goods.h"
#include "episodes/episode_spec.h"
#include "scene/scene.h"

namespace marketgen::episodes {

// What all episodes at one place share. Immutable.
struct CheckoutPlace {
  std::string lane;  // EpisodeSpec::lane; empty: a room of its own
  Pose store_from_station;
  scene::Scene surroundings;  // its last fixture is the counter; without the episode's items
};

CheckoutPlace checkout_room(const CheckoutStation& station);

// Of the store: its room, and what stands near the lane with all goods on it. The counter stands in
// the lane's place and has its id. Errors, at `where`: episode.other_store, the store has no such
// lane; episode.impossible, the robot has no room there.
Result<CheckoutPlace> checkout_at_lane(const CheckoutStation& station,
                                       const scene::Scene& store,
                                       const catalog::Catalog& catalog,
                                       const std::string& lane,
                                       const std::string& where);

// The place's products, then one a goods: item i of the episode where that begins, `goods[i]` what
// it is. The layout has the episode's name. `station_from_basket`: where its basket stands.
std::unique_ptr<scene::Scene> checkout_scene(const CheckoutPlace& place,
                                             const Pose& station_from_basket,
                                             const EpisodeSpec& spec,
                                             const std::vector<SharedEpisodeGoods>& goods);

// One more product of the place: the next of its items, there.
void add_item(scene::Scene& scene, const catalog::Product& product, const Pose& store_from_product);

}  // namespace marketgen::episodes
