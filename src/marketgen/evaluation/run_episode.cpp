#include "evaluation/run_episode.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <map>

#include <fmt/format.h>

#include "base/interrupt.h"

namespace marketgen {
namespace {

// A policy of somebody else's may throw.
Result<Action> asked(Policy& policy, const Observation& now) {
  try {
    return policy.act(now);
  } catch (const std::exception& thrown) {
    return Error{"episode.policy_failed", "policy", thrown.what()};
  }
}

// Until the policy stops or the time is over.
Result<void> act_out(TrackWorld& world, Policy& policy, EpisodeWatcher* watcher) {
  Observation now = world.observe();
  Task task{world.spec().instruction, world.spec().limit_s};
  for (const EpisodeGoal& goal : world.spec().goals)
    task.goals.push_back({goal.sku, goal.count});
  MARKETGEN_CHECK(policy.begin(task, now));
  while (!world.done()) {
    MARKETGEN_CHECK(check_interrupt());
    MARKETGEN_TRY(const Action action, asked(policy, now));
    MARKETGEN_TRY(now, world.step(action));
    if (watcher != nullptr) MARKETGEN_CHECK(watcher->step());
  }
  return {};
}

// Of an episode whose physics broke down: nothing is in place.
EpisodeResult unjudged(const EpisodeSpec& spec) {
  EpisodeResult result;
  result.episode = spec.id;
  result.store = spec.store;
  for (const EpisodeGoal& goal : spec.goals)
    result.goals.push_back({goal.sku, goal.count, 0});
  return result;
}

FailureCode failure_of(const EpisodeResult& result, const Policy& policy) {
  if (result.success_strict) return FailureCode::none;
  if (result.is_void) return FailureCode::collision;
  if (result.side_effects.wrong_items > 0) return FailureCode::wrong_item;
  const auto told = value_named<FailureCode>(policy.failure());
  return told && *told != FailureCode::none ? *told : FailureCode::dropped;
}

}  // namespace

Result<EpisodeResult> run_episode(Arena& arena,
                                  const EpisodeSpec& spec,
                                  const std::string& policy_name,
                                  EpisodeWatcher* watcher) {
  const auto began = std::chrono::steady_clock::now();
  MARKETGEN_TRY(const std::unique_ptr<TrackWorld> world, arena.open(spec));
  MARKETGEN_TRY(const std::unique_ptr<Policy> policy, arena.policy(policy_name, *world));
  if (watcher != nullptr) MARKETGEN_CHECK(watcher->begin(*world));
  const auto acted = act_out(*world, *policy, watcher);
  MARKETGEN_CHECK(check_interrupt());  // an episode that was broken off has no result
  const bool in_time = world->time_s() < spec.limit_s - control_step_s / 2;
  auto judged = world->finish();
  EpisodeResult result = judged.ok() ? std::move(judged).value() : unjudged(spec);
  result.policy = policy_name;
  result.failure = failure_of(result, *policy);
  if (!in_time && !result.success_strict) result.failure = FailureCode::timeout;
  if (!judged.ok()) result.detail = to_string(judged.error());
  if (!acted.ok()) result.detail = to_string(acted.error());
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  result.wall_s = took.count();
  return result;
}

EvaluationSummary summarize(const std::vector<EpisodeResult>& results) {
  EvaluationSummary summary;
  summary.episodes = static_cast<int>(results.size());
  int strict = 0, clean = 0, asked = 0, reached = 0;
  std::map<FailureCode, int> failures;
  for (const EpisodeResult& result : results) {
    strict += result.success_strict ? 1 : 0;
    clean += result.success_clean ? 1 : 0;
    int of_this = 0;
    for (const GoalOutcome& goal : result.goals)
      of_this += goal.count;
    asked += of_this;
    reached += static_cast<int>(result.success_partial * of_this + 0.5);
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
  for (const EpisodeResult& result : results) {
    if (!result.success_strict) continue;
    summary.mean_path_success_m += result.path_m;
    ++succeeded;
  }
  summary.mean_path_success_m /= std::max(succeeded, 1);
  summary.goals = share_of(reached, asked);
  summary.strict = share_of(strict, summary.episodes);
  summary.clean = share_of(clean, summary.episodes);
  for (const auto& [failure, episodes] : failures)
    summary.failures.push_back({failure, episodes});
  return summary;
}

}  // namespace marketgen
