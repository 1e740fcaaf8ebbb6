// An episode as it is run, whoever acts in it: the one stepping loop. Evaluations, policies in
// Python and reinforcement learning all step, end and judge through here.
//
//   EpisodeRun run(world);
//   while (run.running()) MARKETGEN_CHECK(run.step(action));
//   run.judged(end);
#pragma once
#include <optional>
#include <string_view>

#include "episodes/episode_end.h"
#include "episodes/episode_result.h"
#include "episodes/track_world.h"

namespace marketgen::environments {

// What ends an episode before its time is over.
enum class EndsWhen { agent_stops, goals_are_met };

struct RunStep {
  agent::Observation now;
  bool terminated = false;  // as EndsWhen says
  bool truncated = false;   // the time is over
};

// Not thread-safe. A function of the episode and of the actions, bit for bit.
class EpisodeRun {
 public:
  // `world` was reset to the episode and must outlive the run.
  explicit EpisodeRun(episodes::TrackWorld& world, EndsWhen rule = EndsWhen::agent_stops)
      : world_(world), rule_(rule) {}

  const episodes::TrackWorld& world() const { return world_; }
  bool running() const { return !world_.done(); }

  // One control step. Errors: those of TrackWorld::step, and the world is as before when it is
  // episode.bad_action; those of TrackWorld::goals_met.
  Result<RunStep> step(const agent::Action& action);

  // Waits for the judgement and judges, once. One that still runs is ended as it stands. Errors:
  // those of TrackWorld::finish.
  Result<void> finish();
  const std::optional<episodes::EpisodeResult>& result() const {
    return result_;
  }  // once it is finished

  // The result as evaluations keep it, of what finish() judged or could not judge.
  // `end.in_time` is not read: the run knows.
  episodes::EpisodeResult judged(episodes::EpisodeEnd end);

  // Of a moment that was saved: what there is beside the world's own. Errors: those of
  // TrackWorld::restore, and nothing has changed.
  bool in_time() const { return in_time_; }  // it was finished before the time was over
  Result<void> restore(std::string_view world,
                       bool in_time,
                       std::optional<episodes::EpisodeResult> result);

 private:
  episodes::TrackWorld& world_;
  EndsWhen rule_;
  bool in_time_ = true;
  std::optional<episodes::EpisodeResult> result_;
};

}  // namespace marketgen::environments
