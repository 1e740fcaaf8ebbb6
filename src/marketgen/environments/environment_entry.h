// What this module asks of each track of episodes/tracks.inc: how its episodes are drawn, opened,
// and given to learners. Defined in the track's own folder.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "environments/arena.h"
#include "environments/environment.h"
#include "environments/episode_sampler.h"
#include "episodes/draw_rules.h"

namespace marketgen::environments {

// Immutable; any number of threads may ask.
class EnvironmentEntry {
 public:
  virtual ~EnvironmentEntry() = default;
  // A world that was reset to the episode. Errors: as Arena::open.
  virtual Result<std::unique_ptr<episodes::TrackWorld>> open(
      Arena& arena,
      const episodes::EpisodeSpec& spec,
      const std::optional<episodes::Perturbation>& perturbation,
      const episodes::Realism& realism) const = 0;
  // Errors: of the station and its robot.
  virtual Result<std::unique_ptr<Environment>> environment(
      std::shared_ptr<EpisodeGround> ground, const EnvironmentOptions& options) const = 0;
  // `tools`: a tool set of the track's robot, the first when empty. The arena must outlive it.
  // Errors: of the station; usage.bad_flag when its robot has no choice.
  // With Split::certified the arena's header must have the rows of all that the stores sell.
  virtual Result<std::unique_ptr<EpisodeSampler>> sampler(
      Arena& arena, const std::string& tools, const episodes::DrawRules& rules = {}) const = 0;
};

#define MARKETGEN_TRACK(name, Type) const EnvironmentEntry& name##_environment_entry();
#include "episodes/tracks.inc"
#undef MARKETGEN_TRACK

const EnvironmentEntry& environment_entry_of(episodes::Track track);

}  // namespace marketgen::environments
