// Checkout Unloading as an Environment.
#pragma once
#include "environments/environment.h"

namespace marketgen {

// Errors: those of CheckoutWorld::create.
Result<std::unique_ptr<Environment>> make_checkout_environment(
    std::shared_ptr<EpisodeGround> ground, const EnvironmentOptions& options);

}  // namespace marketgen
