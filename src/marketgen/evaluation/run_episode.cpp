#include "evaluation/run_episode.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <exception>
#include <iterator>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "base/interrupt.h"

namespace marketgen {
namespace {

// A policy of somebody else's may throw anything.
template <class Answer>
auto asked(EpisodeWatcher* watcher, const Answer& answer) -> decltype(answer()) {
  const auto failed = [](std::string why) {
    return Error{"episode.policy_failed", "policy", std::move(why)};
  };
  if (watcher != nullptr) watcher->asks();
  auto given = [&]() -> decltype(answer()) {
    try {
      return answer();
    } catch (const Interrupted&) {
      throw;
    } catch (const std::exception& thrown) {
      return failed(thrown.what());
    } catch (...) {
      return failed("it threw something that is no std::exception");
    }
  }();
  if (watcher != nullptr) watcher->answered();
  return given;
}

// What ended an episode before its time.
struct Break {
  Error error;
  bool by_policy = false;
};

// Until the policy stops or the time is over.
std::optional<Break> act_out(TrackWorld& world, Policy& policy, EpisodeWatcher* watcher) {
  Observation now = world.observe();
  const Task task = task_of(world.spec());
  const auto begun = asked(watcher, [&] { return policy.begin(task, now); });
  if (!begun.ok()) return Break{begun.error(), true};
  while (!world.done()) {
    if (const auto go_on = check_interrupt(); !go_on.ok()) return Break{go_on.error()};
    const auto action = asked(watcher, [&] { return policy.act(now); });
    if (!action.ok()) return Break{action.error(), true};
    auto stepped = world.step(*action);
    if (!stepped.ok()) return Break{stepped.error(), stepped.error().code == "episode.bad_action"};
    now = std::move(stepped).value();
    if (watcher == nullptr) continue;
    if (const auto seen = watcher->step(); !seen.ok()) return Break{seen.error()};
  }
  return std::nullopt;
}

}  // namespace

Task task_of(const EpisodeSpec& spec) {
  Task task{spec.instruction, spec.limit_s};
  for (const EpisodeGoal& goal : spec.goals)
    task.goals.push_back({goal.sku, goal.count});
  return task;
}

Result<EpisodeResult> run_episode(Arena& arena,
                                  const EpisodeSpec& spec,
                                  const std::string& policy_name,
                                  EpisodeWatcher* watcher) {
  const auto began = std::chrono::steady_clock::now();
  MARKETGEN_TRY(const std::unique_ptr<TrackWorld> world, arena.open(spec));
  MARKETGEN_TRY(const std::unique_ptr<Policy> policy, arena.policy(policy_name, *world));
  if (watcher != nullptr) MARKETGEN_CHECK(watcher->begin(*world));
  const auto broken = act_out(*world, *policy, watcher);
  MARKETGEN_CHECK(check_interrupt());  // an episode that was broken off has no result
  EpisodeEnd end{policy_name, policy->failure()};
  end.in_time = ended_in_time(*world);
  auto judged = world->finish();
  if (!judged.ok()) end.broken = judged.error();
  if (broken) {
    end.broken = broken->error;
    end.by_policy = broken->by_policy;
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  end.wall_s = took.count();
  return with_end(judged.ok() ? std::move(judged).value() : unjudged(spec), end);
}

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

EvaluationSummary summarize(const std::vector<EpisodeResult>& all) {
  EvaluationSummary summary;
  std::vector<std::string> errors;
  for (const EpisodeResult& result : all)
    errors.push_back(result.error);
  summary.errors = counted_errors(errors);
  std::vector<EpisodeResult> results;
  std::ranges::copy_if(
      all, std::back_inserter(results), [](const EpisodeResult& r) { return r.error.empty(); });
  summary.episodes = static_cast<int>(results.size());
  int strict = 0, clean = 0, asked = 0, reached = 0;
  std::map<FailureCode, int> failures;
  for (const EpisodeResult& result : results) {
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
