// Runs episodes with a policy and sums up what became of them.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.h"
#include "catalog/rows.h"
#include "episodes/episode_result.h"
#include "episodes/episode_spec.h"
#include "evaluation/product_pictures.h"
#include "grasping/grasp_shares.h"

namespace marketgen {

// A policy's error ends its episode and stands in the result. Errors: those of CheckoutWorld and,
// for a name that is no policy's, usage.bad_flag.
Result<EpisodeResult> run_episode(const std::filesystem::path& data,
                                  const EpisodeSpec& spec,
                                  const std::vector<Product>& products,
                                  const std::vector<FrictionRow>& frictions,
                                  const std::string& policy);
// The same with pictures that other episodes share.
Result<EpisodeResult> run_episode(const std::filesystem::path& data,
                                  const EpisodeSpec& spec,
                                  const std::vector<Product>& products,
                                  const std::vector<FrictionRow>& frictions,
                                  const std::string& policy,
                                  PictureLibrary& library);

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
  double mean_simulated_s = 0, mean_wall_s = 0;
  std::vector<FailureCount> failures;  // of episodes that are not strict; those that occur

  static constexpr auto fields = field_list(
      field("episodes", &EvaluationSummary::episodes, "how many"),
      field("success_partial", &EvaluationSummary::success_partial, "mean over the episodes"),
      field("goals", &EvaluationSummary::goals, "goals reached, of all"),
      field("strict", &EvaluationSummary::strict, "episodes with all goals reached"),
      field("clean", &EvaluationSummary::clean, "those without side effects"),
      field("mean_simulated_s", &EvaluationSummary::mean_simulated_s, "simulated, an episode"),
      field("mean_wall_s", &EvaluationSummary::mean_wall_s, "of computing, an episode"),
      field("failures", &EvaluationSummary::failures, "by what kept the agent from its goals"));
};
EvaluationSummary summarize(const std::vector<EpisodeResult>& results);

}  // namespace marketgen
