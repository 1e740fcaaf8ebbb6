#include "evaluation/evaluation_summary.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <string_view>

namespace marketgen::evaluation {

bool ends_the_run(const Error& error) {
  constexpr std::array<std::string_view, 3> families{"internal.", "usage.", "io."};
  return error.code == "episode.no_policy" ||
         std::ranges::any_of(
             families, [&](std::string_view family) { return error.code.starts_with(family); });
}

std::vector<ErrorCount> counted_errors(const std::vector<std::string>& errors) {
  std::map<std::string, int> counts;
  for (const std::string& error : errors)
    if (!error.empty()) ++counts[error];
  std::vector<ErrorCount> counted;
  for (const auto& [error, episodes] : counts)
    counted.push_back({error, episodes});
  return counted;
}

EvaluationSummary summarize(const std::vector<episodes::EpisodeResult>& all) {
  EvaluationSummary summary;
  std::vector<std::string> errors;
  for (const episodes::EpisodeResult& result : all)
    errors.push_back(result.error);
  summary.errors = counted_errors(errors);
  std::vector<episodes::EpisodeResult> results;
  std::ranges::copy_if(all, std::back_inserter(results), [](const episodes::EpisodeResult& r) {
    return r.error.empty();
  });
  summary.episodes = static_cast<int>(results.size());
  int strict = 0, clean = 0, asked = 0, reached = 0;
  std::map<episodes::FailureCode, int> failures;
  for (const episodes::EpisodeResult& result : results) {
    strict += result.success_strict ? 1 : 0;
    clean += result.success_clean ? 1 : 0;
    asked += result.asked;
    reached += result.hits;
    if (!result.success_strict) ++failures[result.failure];
    const auto count = static_cast<double>(results.size());
    summary.success_partial += result.success_partial / count;
    summary.spl += result.spl / count;
    summary.spl_subset += result.spl_subset / count;
    summary.mean_path_m += result.path_m / count;
    summary.mean_simulated_s += result.simulated_s / count;
    summary.mean_wall_s += result.wall_s / count;
  }
  int succeeded = 0;
  for (const episodes::EpisodeResult& result : results) {
    if (!result.success_strict) continue;
    summary.mean_path_success_m += result.path_m;
    ++succeeded;
  }
  summary.mean_path_success_m /= std::max(succeeded, 1);
  summary.goals = grasping::share_of(reached, asked);
  summary.strict = grasping::share_of(strict, summary.episodes);
  summary.clean = grasping::share_of(clean, summary.episodes);
  for (const auto& [failure, episodes] : failures)
    summary.failures.push_back({failure, episodes});
  return summary;
}

}  // namespace marketgen::evaluation
