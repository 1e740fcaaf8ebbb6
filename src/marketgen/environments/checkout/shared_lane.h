// What all who are at one checkout lane of a store share: what is round it.
#pragma once
#include <memory>

#include "environments/arena.h"
#include "episodes/checkout/checkout_scene.h"

namespace marketgen::environments {

// Null for an episode that is in a room of its own. Errors: those of Arena::scene and
// checkout_at_lane.
Result<std::shared_ptr<const episodes::CheckoutPlace>> shared_lane(
    Arena& arena, const episodes::CheckoutStation& station, const episodes::EpisodeSpec& spec);

}  // namespace marketgen::environments
