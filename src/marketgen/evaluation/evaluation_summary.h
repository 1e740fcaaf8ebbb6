// Sums up what became of many episodes: what `summary.json` holds.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "episodes/episode_result.h"
#include "evaluation/store_bootstrap.h"
#include "grasping/grasp_shares.h"

namespace marketgen::evaluation {

struct FailureCount {
  episodes::FailureCode failure = episodes::FailureCode::none;
  int episodes = 0;
  static constexpr auto fields =
      field_list(field("failure", &FailureCount::failure, "what kept the agent from its goals"),
                 field("episodes", &FailureCount::episodes, "how many"));
};

struct ErrorCount {
  std::string error;
  int episodes = 0;
  static constexpr auto fields =
      field_list(field("error", &ErrorCount::error, "why they could not be run"),
                 field("episodes", &ErrorCount::episodes, "how many"));
};

// Whether an error is not that of the episode: any other would end likewise. An interrupt, a full
// disk, a policy that does not start.
bool ends_the_run(const Error& error);
// Of the rows of episodes that could not be run, by the code in their `error`; empty: it was run.
std::vector<ErrorCount> counted_errors(const std::vector<std::string>& errors);

// So many of all goals, which are no independent draws (evaluation/store_bootstrap.h).
struct GoalShare {
  int of = 0, number = 0;
  double share = 0, low = 0, high = 0;  // 0..1; 0 of nothing

  static constexpr auto fields =
      field_list(field("of", &GoalShare::of, "of how many"),
                 field("number", &GoalShare::number, "how many"),
                 field("share", &GoalShare::share, "0..1"),
                 field("low", &GoalShare::low, "95 % interval, bootstrap over stores"),
                 field("high", &GoalShare::high, "95 % interval, bootstrap over stores"));
};

struct EvaluationSummary {
  int episodes = 0, stores = 0;
  double success_partial = 0;
  Estimate partial;
  GoalShare goals;
  grasping::Share strict, clean, violations;
  double spl = 0, spl_subset = 0, mean_path_m = 0, mean_path_success_m = 0;
  double mean_simulated_s = 0, mean_wall_s = 0;
  std::vector<FailureCount> failures;  // of episodes that are not strict; those that occur
  std::vector<ErrorCount> errors;      // of episodes that could not be run
  int unfinished = 0;
  std::optional<agent::ModelUse> model;  // all of them together
  std::optional<agent::PartsUse> parts;  // likewise

  static constexpr auto fields = field_list(
      field("episodes", &EvaluationSummary::episodes, "that were run; all shares are of these"),
      field("stores", &EvaluationSummary::stores, "that they are of"),
      field("success_partial", &EvaluationSummary::success_partial, "mean over the episodes"),
      field("partial", &EvaluationSummary::partial, "the same, with its interval"),
      field("goals", &EvaluationSummary::goals, "goals reached, of all"),
      field("strict", &EvaluationSummary::strict, "episodes with all goals reached"),
      field("clean", &EvaluationSummary::clean, "those without side effects"),
      field("violations",
            &EvaluationSummary::violations,
            "episodes, also failed ones, that are void or break a limit on side effects"),
      field("spl", &EvaluationSummary::spl, "mean over the episodes; as the paper has it"),
      field("spl_subset", &EvaluationSummary::spl_subset, "against the goals that were reached"),
      field("mean_path_m", &EvaluationSummary::mean_path_m, "driven, an episode"),
      field("mean_path_success_m",
            &EvaluationSummary::mean_path_success_m,
            "driven, an episode with all goals reached"),
      field("mean_simulated_s", &EvaluationSummary::mean_simulated_s, "simulated, an episode"),
      field("mean_wall_s", &EvaluationSummary::mean_wall_s, "of computing, an episode"),
      field("failures", &EvaluationSummary::failures, "by what kept the agent from its goals"),
      field("errors", &EvaluationSummary::errors, "episodes that could not be run: in no share"),
      field("unfinished", &EvaluationSummary::unfinished, "episodes without a result so far"),
      field("model",
            &EvaluationSummary::model,
            "what the policy asked of a model outside of the program, in all of them"),
      field("parts",
            &EvaluationSummary::parts,
            "what the policy asked of parts that run in servers of their own, in all of them"));
};
// Which store an episode is of: stores may have the same name. Results of earlier versions have
// nothing else.
const std::string& store_of(const episodes::EpisodeResult& result);

// What the episodes add to the share of goals, to the mean partial score, and to strict success.
std::vector<ScoredEpisode> goal_scores(const std::vector<episodes::EpisodeResult>& results);
std::vector<ScoredEpisode> partial_scores(const std::vector<episodes::EpisodeResult>& results);
std::vector<ScoredEpisode> strict_scores(const std::vector<episodes::EpisodeResult>& results);
// Scores of the same episodes in the same order: what the first has more than the others.
std::vector<ScoredEpisode> differences(const std::vector<ScoredEpisode>& these,
                                       const std::vector<ScoredEpisode>& others);
// None of episodes that have no way to go.
std::optional<Estimate> spl_of(const std::vector<episodes::EpisodeResult>& results);

// Of the results that have no error; `unfinished` is the caller's to add.
EvaluationSummary summarize(const std::vector<episodes::EpisodeResult>& all);

}  // namespace marketgen::evaluation
