#include "environments/environment_batch.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/interrupt.h"
#include "base/parallel.h"

namespace marketgen::environments {
namespace {

// Runs work(i) for each i; the first error by index.
Result<void> for_each_of(std::size_t count, const std::function<Result<void>(std::size_t)>& work) {
  const auto done =
      parallel_map(count, [&](std::size_t i) { return std::make_shared<Result<void>>(work(i)); });
  for (const auto& result : done)
    MARKETGEN_CHECK(*result);
  return {};
}

std::span<float> row_of(std::span<float> rows, std::size_t row, const Environment& environment) {
  return rows.subspan(row * environment.observation_size(), environment.observation_size());
}

}  // namespace

Result<void> step_all(std::span<Environment* const> environments,
                      std::span<const double> actions,
                      const BatchBuffers& into) {
  const std::size_t numbers = environments.empty() ? 0 : actions.size() / environments.size();
  const auto action_of = [&](std::size_t i) { return actions.subspan(i * numbers, numbers); };
  for (std::size_t i = 0; i < environments.size(); ++i) {
    const auto fit = environments[i]->check(action_of(i));
    if (fit.ok()) continue;
    Error error = fit.error();
    if (environments.size() > 1) error.where = fmt::format("action of environment {}", i);
    return error;
  }
  return for_each_of(environments.size(), [&](std::size_t i) -> Result<void> {
    MARKETGEN_TRY(const StepOutcome outcome, environments[i]->step(action_of(i)));
    environments[i]->observe(row_of(into.observations, i, *environments[i]));
    into.rewards[i] = outcome.reward;
    into.terminated[i] = outcome.terminated;
    into.truncated[i] = outcome.truncated;
    return {};
  });
}

Result<void> reset_all(std::span<Environment* const> environments,
                       std::span<const episodes::EpisodeSpec> episodes,
                       std::span<float> observations) {
  return for_each_of(environments.size(), [&](std::size_t i) -> Result<void> {
    MARKETGEN_CHECK(environments[i]->reset(episodes[i]));
    environments[i]->observe(row_of(observations, i, *environments[i]));
    return {};
  });
}

Result<std::vector<episodes::EpisodeSpec>> draw_all(EpisodeGround& ground,
                                                    episodes::Track track,
                                                    std::span<const std::uint64_t> seeds,
                                                    const std::string& tools,
                                                    episodes::Split split,
                                                    Progress& progress) {
  std::vector<episodes::EpisodeSpec> drawn(seeds.size());
  progress.begin("episodes", seeds.size());
  const auto done = for_each_of(seeds.size(), [&](std::size_t i) -> Result<void> {
    MARKETGEN_CHECK(check_interrupt());
    MARKETGEN_TRY(drawn[i], ground.draw(track, seeds[i], tools, split));
    progress.advance();
    return {};
  });
  progress.end();
  if (!done.ok()) return done.error();
  return drawn;
}

}  // namespace marketgen::environments
