// Runs an episode with a policy.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "environments/arena.h"
#include "episodes/episode_end.h"
#include "episodes/episode_result.h"
#include "episodes/episode_spec.h"

namespace marketgen::environments {

// Looks on while an episode is run: a film, a test.
class EpisodeWatcher {
 public:
  virtual ~EpisodeWatcher() = default;
  virtual Result<void> begin(
      const episodes::TrackWorld& world) = 0;  // which outlives the run's steps
  virtual Result<void> step() = 0;             // after every control step
  virtual void meets(agent::Policy&) {}        // once, who acts; outlives the run's steps
  virtual void asks() {}                       // before the policy is asked
  virtual void answered() {}                   // it has answered, or failed
};

// Several that look on, in their order; none of them is null.
class EpisodeWatchers : public EpisodeWatcher {
 public:
  explicit EpisodeWatchers(std::vector<EpisodeWatcher*> watchers)
      : watchers_(std::move(watchers)) {}
  Result<void> begin(const episodes::TrackWorld& world) override;
  Result<void> step() override;
  void meets(agent::Policy& policy) override;
  void asks() override;
  void answered() override;

 private:
  std::vector<EpisodeWatcher*> watchers_;
};

// What the policy is told before it begins.
agent::Task task_of(const episodes::EpisodeSpec& spec);

// In a world that was reset to the episode. A policy's error, what it throws and an action that is
// none end its episode and stand in the result, which is kept as one of `name`; its `wall_s` is the
// caller's to add. Errors: an interrupt; those of EpisodeWatcher::begin.
Result<episodes::EpisodeResult> run_policy(episodes::TrackWorld& world,
                                           agent::Policy& policy,
                                           const std::string& name,
                                           EpisodeWatcher* watcher = nullptr);

// The same with a world and a policy of the arena's, perturbed and of a realism as Arena::open has
// it. Errors: those, too.
Result<episodes::EpisodeResult> run_episode(
    Arena& arena,
    const episodes::EpisodeSpec& spec,
    const std::string& policy,
    EpisodeWatcher* watcher = nullptr,
    const std::optional<episodes::Perturbation>& perturbation = {},
    const episodes::Realism& realism = {});

}  // namespace marketgen::environments
