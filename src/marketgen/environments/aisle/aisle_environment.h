// In-Aisle Item Collection as an Environment.
#pragma once
#include "environments/environment.h"

namespace marketgen::environments {

// Errors: those of load_aisle_station and load_station_robot.
Result<std::unique_ptr<Environment>> make_aisle_environment(std::shared_ptr<EpisodeGround> ground,
                                                            const EnvironmentOptions& options);

}  // namespace marketgen::environments
