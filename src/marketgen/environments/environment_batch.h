// Many environments stepped in one call, on all threads, into the caller's memory.
//
// What each does depends on none of the others, nor on how many threads there are. A single
// environment is stepped through here, too: numbers are rounded alike then.
#pragma once
#include <span>
#include <vector>

#include "base/progress.h"
#include "environments/environment.h"

namespace marketgen::environments {

// Row-major, a row an environment; all environments have the same observation_size().
struct BatchBuffers {
  std::span<float> observations;
  std::span<double> rewards;
  std::span<bool> terminated, truncated;
};

// `actions`: a row an environment. Error episode.bad_action at "action of environment i" where one
// would be refused, and none has moved; other errors of Environment::step.
Result<void> step_all(std::span<Environment* const> environments,
                      std::span<const double> actions,
                      const BatchBuffers& into);

// To an episode each. Errors: those of Environment::reset.
Result<void> reset_all(std::span<Environment* const> environments,
                       std::span<const episodes::EpisodeSpec> episodes,
                       std::span<float> observations);

// Episodes of seeds, drawn side by side. Errors: of EpisodeGround::draw; internal.interrupted.
Result<std::vector<episodes::EpisodeSpec>> draw_all(
    EpisodeGround& ground,
    episodes::Track track,
    std::span<const std::uint64_t> seeds,
    const std::string& tools = {},
    episodes::Split split = episodes::Split::planned,
    Progress& progress = silent_progress());

}  // namespace marketgen::environments
