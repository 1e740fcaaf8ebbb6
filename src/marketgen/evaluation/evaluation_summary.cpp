#include "evaluation/evaluation_summary.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <string_view>

namespace marketgen::evaluation {
namespace {

void add_shares(const std::vector<episodes::EpisodeResult>& results, EvaluationSummary& summary) {
  std::set<std::string_view> stores;
  std::map<episodes::FailureCode, int> failures;
  int strict = 0, clean = 0, violations = 0;
  for (const episodes::EpisodeResult& result : results) {
    stores.insert(store_of(result));
    strict += result.success_strict ? 1 : 0;
    clean += result.success_clean ? 1 : 0;
    violations += result.is_void || !episodes::is_clean(result.side_effects) ? 1 : 0;
    summary.goals.of += result.asked;
    summary.goals.number += result.hits;
    if (!result.success_strict) ++failures[result.failure];
  }
  summary.stores = static_cast<int>(stores.size());
  const Estimate goals = estimate_of(goal_scores(results));
  summary.goals.share = goals.value;
  summary.goals.low = goals.low;
  summary.goals.high = goals.high;
  summary.partial = estimate_of(partial_scores(results));
  summary.strict = grasping::share_of(strict, summary.episodes);
  summary.clean = grasping::share_of(clean, summary.episodes);
  summary.violations = grasping::share_of(violations, summary.episodes);
  for (const auto& [failure, episodes] : failures)
    summary.failures.push_back({failure, episodes});
}

void add_means(const std::vector<episodes::EpisodeResult>& results, EvaluationSummary& summary) {
  const auto count = static_cast<double>(results.size());
  int succeeded = 0;
  for (const episodes::EpisodeResult& result : results) {
    summary.success_partial += result.success_partial / count;
    summary.spl += result.spl / count;
    summary.spl_subset += result.spl_subset / count;
    summary.mean_path_m += result.path_m / count;
    summary.mean_simulated_s += result.simulated_s / count;
    summary.mean_wall_s += result.wall_s / count;
    if (!result.success_strict) continue;
    summary.mean_path_success_m += result.path_m;
    ++succeeded;
  }
  summary.mean_path_success_m /= std::max(succeeded, 1);
}

// What was asked outside of the program, if anything was.
template <class Use>
void add_use(const std::optional<Use>& one, std::optional<Use>& all) {
  if (!one) return;
  if (!all) all.emplace();
  *all += *one;
}

}  // namespace

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

const std::string& store_of(const episodes::EpisodeResult& result) {
  return result.scene_hash.empty() ? result.store : result.scene_hash;
}

std::vector<ScoredEpisode> goal_scores(const std::vector<episodes::EpisodeResult>& results) {
  std::vector<ScoredEpisode> scores;
  for (const episodes::EpisodeResult& result : results)
    scores.push_back(
        {store_of(result), static_cast<double>(result.hits), static_cast<double>(result.asked)});
  return scores;
}

std::vector<ScoredEpisode> partial_scores(const std::vector<episodes::EpisodeResult>& results) {
  std::vector<ScoredEpisode> scores;
  for (const episodes::EpisodeResult& result : results)
    scores.push_back({store_of(result), result.success_partial});
  return scores;
}

std::vector<ScoredEpisode> strict_scores(const std::vector<episodes::EpisodeResult>& results) {
  std::vector<ScoredEpisode> scores;
  for (const episodes::EpisodeResult& result : results)
    scores.push_back({store_of(result), result.success_strict ? 1.0 : 0.0});
  return scores;
}

std::vector<ScoredEpisode> differences(const std::vector<ScoredEpisode>& these,
                                       const std::vector<ScoredEpisode>& others) {
  std::vector<ScoredEpisode> all = these;
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i].score -= others[i].score;
  return all;
}

std::optional<Estimate> spl_of(const std::vector<episodes::EpisodeResult>& results) {
  std::vector<ScoredEpisode> scores;
  bool is_driven = false;
  for (const episodes::EpisodeResult& result : results) {
    scores.push_back({store_of(result), result.spl});
    is_driven = is_driven || result.shortest_m > 0;
  }
  if (!is_driven) return std::nullopt;
  return estimate_of(scores);
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
  add_shares(results, summary);
  add_means(results, summary);
  for (const episodes::EpisodeResult& result : results) {
    add_use(result.model, summary.model);
    add_use(result.parts, summary.parts);
  }
  return summary;
}

}  // namespace marketgen::evaluation
