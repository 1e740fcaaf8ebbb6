// Draws episodes of the track's easiest task: one light box stands on the counter and is to be
// brought onto the unloading area, carried or pushed. Nothing is planned or tried for it, so that
// drawing one takes no time.
#pragma once
#include <filesystem>
#include <vector>

#include "episodes/checkout/sample_checkout.h"

namespace marketgen::episodes {

inline constexpr char one_item_station[] = "one-item";

// A box that stands steadily and fits between the fingers.
bool is_one_item(const catalog::Product& product);

// Its place and the way it faces are drawn within the station's `set_aside`. Error
// episode.impossible: there is no such product in `stock`; those of load_checkout_station.
Result<EpisodeSpec> sample_one_item(const std::filesystem::path& data,
                                    const std::vector<catalog::Product>& stock,
                                    const EpisodeOrigin& origin,
                                    Seed seed,
                                    int index);

}  // namespace marketgen::episodes
