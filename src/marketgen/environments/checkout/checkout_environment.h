// Checkout Unloading as an Environment.
#pragma once
#include "environments/environment.h"

namespace marketgen::environments {

// Errors: those of CheckoutWorld::create.
Result<std::unique_ptr<Environment>> make_checkout_environment(
    std::shared_ptr<EpisodeGround> ground, const EnvironmentOptions& options);

// One of sample_one_item(), from the rows of the ground's products. Errors: as there.
Result<episodes::EpisodeSpec> draw_one_item(const EpisodeGround& ground, std::uint64_t seed);

}  // namespace marketgen::environments
