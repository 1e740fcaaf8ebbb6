// Runs episodes with a policy and sums up what became of them.
#pragma once
#include <string>
#include <vector>

#include "base/progress.h"
#include "episodes/episode_result.h"
#include "episodes/episode_spec.h"
#include "evaluation/arena.h"
#include "grasping/grasp_shares.h"

namespace marketgen {

// Looks on while an episode is run: a film, a test.
class EpisodeWatcher {
 public:
  virtual ~EpisodeWatcher() = default;
  virtual Result<void> begin(const TrackWorld& world) = 0;  // which outlives the run's steps
  virtual Result<void> step() = 0;                          // after every control step
};

// A policy's error ends its episode and stands in the result. Errors: those of Arena and of the
// watcher.
Result<EpisodeResult> run_episode(Arena& arena,
                                  const EpisodeSpec& spec,
                                  const std::string& policy,
                                  EpisodeWatcher* watcher = nullptr);

struct FailureCount {
  FailureCode failure = FailureCode::none;
  int episodes = 0;
  static constexpr auto fields =
      field_list(field("failure", &FailureCount::failure, "what kept the agent from its goals"),
                 field("episodes", &FailureCount::episodes, "how many"));
};

struct EvaluationSummary {
  int episodes = 0;
  double success_partial = 0;
  Share goals, strict, clean;  // goals: over all goals of all episodes
  double spl = 0, spl_subset = 0, mean_path_m = 0, mean_path_success_m = 0;
  double mean_simulated_s = 0, mean_wall_s = 0;
  std::vector<FailureCount> failures;  // of episodes that are not strict; those that occur

  static constexpr auto fields = field_list(
      field("episodes", &EvaluationSummary::episodes, "how many"),
      field("success_partial", &EvaluationSummary::success_partial, "mean over the episodes"),
      field("goals", &EvaluationSummary::goals, "goals reached, of all"),
      field("strict", &EvaluationSummary::strict, "episodes with all goals reached"),
      field("clean", &EvaluationSummary::clean, "those without side effects"),
      field("spl", &EvaluationSummary::spl, "mean over the episodes; as the paper has it"),
      field("spl_subset", &EvaluationSummary::spl_subset, "against the goals that were reached"),
      field("mean_path_m", &EvaluationSummary::mean_path_m, "driven, an episode"),
      field("mean_path_success_m",
            &EvaluationSummary::mean_path_success_m,
            "driven, an episode with all goals reached"),
      field("mean_simulated_s", &EvaluationSummary::mean_simulated_s, "simulated, an episode"),
      field("mean_wall_s", &EvaluationSummary::mean_wall_s, "of computing, an episode"),
      field("failures", &EvaluationSummary::failures, "by what kept the agent from its goals"));
};
EvaluationSummary summarize(const std::vector<EpisodeResult>& results);

}  // namespace marketgen
