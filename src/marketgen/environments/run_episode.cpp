#include "environments/run_episode.h"

#include <chrono>
#include <exception>
#include <optional>

#include "base/interrupt.h"
#include "environments/episode_run.h"
#include "episodes/told_goals.h"

namespace marketgen::environments {
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
std::optional<Break> act_out(EpisodeRun& run, agent::Policy& policy, EpisodeWatcher* watcher) {
  agent::Observation now = run.world().observe();
  const agent::Task task = task_of(run.world().spec());
  const auto begun = asked(watcher, [&] { return policy.begin(task, now); });
  if (!begun.ok()) return Break{begun.error(), true};
  while (run.running()) {
    if (const auto go_on = check_interrupt(); !go_on.ok()) return Break{go_on.error()};
    const auto action = asked(watcher, [&] { return policy.act(now); });
    if (!action.ok()) return Break{action.error(), true};
    auto stepped = run.step(*action);
    if (!stepped.ok()) return Break{stepped.error(), stepped.error().code == "episode.bad_action"};
    now = std::move(stepped->now);
    if (watcher == nullptr) continue;
    if (const auto seen = watcher->step(); !seen.ok()) return Break{seen.error()};
  }
  return std::nullopt;
}

}  // namespace

Result<void> EpisodeWatchers::begin(const episodes::TrackWorld& world) {
  for (EpisodeWatcher* watcher : watchers_)
    MARKETGEN_CHECK(watcher->begin(world));
  return {};
}

Result<void> EpisodeWatchers::step() {
  for (EpisodeWatcher* watcher : watchers_)
    MARKETGEN_CHECK(watcher->step());
  return {};
}

void EpisodeWatchers::meets(agent::Policy& policy) {
  for (EpisodeWatcher* watcher : watchers_)
    watcher->meets(policy);
}

void EpisodeWatchers::asks() {
  for (EpisodeWatcher* watcher : watchers_)
    watcher->asks();
}

void EpisodeWatchers::answered() {
  for (EpisodeWatcher* watcher : watchers_)
    watcher->answered();
}

agent::Task task_of(const episodes::EpisodeSpec& spec) {
  agent::Task task{spec.instruction, spec.limit_s};
  for (const episodes::ToldGoal& goal : episodes::told_goals(spec))
    task.goals.push_back({goal.sku.value_or(""), goal.count, goal.text.value_or("")});
  return task;
}

Result<episodes::EpisodeResult> run_policy(episodes::TrackWorld& world,
                                           agent::Policy& policy,
                                           const std::string& name,
                                           EpisodeWatcher* watcher) {
  if (watcher != nullptr) {
    MARKETGEN_CHECK(watcher->begin(world));
    watcher->meets(policy);
  }
  EpisodeRun run(world);
  const auto broken = act_out(run, policy, watcher);
  MARKETGEN_CHECK(check_interrupt());  // an episode that was broken off has no result
  episodes::EpisodeEnd end{name, policy.failure()};
  end.model = policy.model_use();
  end.parts = policy.parts_use();
  if (broken) {
    end.broken = broken->error;
    end.by_policy = broken->by_policy;
  }
  return run.judged(end);
}

Result<episodes::EpisodeResult> run_episode(
    Arena& arena,
    const episodes::EpisodeSpec& spec,
    const std::string& policy_name,
    EpisodeWatcher* watcher,
    const std::optional<episodes::Perturbation>& perturbation,
    const episodes::Realism& realism) {
  const auto began = std::chrono::steady_clock::now();
  MARKETGEN_TRY(const std::unique_ptr<episodes::TrackWorld> world,
                arena.open(spec, perturbation, realism));
  MARKETGEN_TRY(const std::unique_ptr<agent::Policy> policy, arena.policy(policy_name, *world));
  MARKETGEN_TRY(episodes::EpisodeResult result, run_policy(*world, *policy, policy_name, watcher));
  result.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return result;
}

}  // namespace marketgen::environments
