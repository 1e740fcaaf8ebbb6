#include "evaluation/run_episode.h"

#include <algorithm>
#include <chrono>
#include <map>

#include <fmt/format.h>

#include "base/interrupt.h"
#include "episodes/checkout_world.h"
#include "evaluation/checkout_senses.h"
#include "policy/classical_checkout.h"
#include "policy/oracle_checkout.h"
#include "policy/random_policy.h"

namespace marketgen {
namespace {

// What `classical` sees and knows; it outlives the policy.
struct Senses {
  CheckoutEyes eyes;
  PicturedProducts products;
};

Result<std::unique_ptr<Policy>> classical_policy(const CheckoutWorld& world,
                                                 const std::filesystem::path& data,
                                                 Senses& senses) {
  ClassicalSetup setup;
  setup.eyes = &senses.eyes;
  setup.products = &senses.products;
  setup.robot = &world.robot();
  const std::vector<ToolChoiceRow>& tools = world.station().tools;
  const std::string row = tools.empty() ? world.robot().tools.front().row : tools.front().row;
  MARKETGEN_TRY(setup.tool, load_grasp_tool(data, row));
  setup.place = workplace_of(world.station());
  return make_classical_checkout(std::move(setup), Seed(world.spec().seed).child("classical"));
}

Result<std::unique_ptr<Policy>> policy_named(const std::string& name,
                                             const CheckoutWorld& world,
                                             const std::filesystem::path& data,
                                             Senses& senses) {
  if (name == "oracle")
    return make_checkout_oracle(world, data, Seed(world.spec().seed).child("oracle"));
  if (name == "classical") return classical_policy(world, data, senses);
  if (name == "random")
    return std::unique_ptr<Policy>(
        std::make_unique<RandomPolicy>(Seed(world.spec().seed).child("random")));
  return Error{"usage.bad_flag",
               "--policy",
               "there is no policy \"" + name + "\"; there are: classical, oracle, random"};
}

// Until the policy stops or the time is over.
Result<void> act_out(CheckoutWorld& world, Policy& policy) {
  Observation now = world.observe();
  Task task{world.spec().instruction, world.spec().limit_s};
  for (const EpisodeGoal& goal : world.spec().goals)
    task.goals.push_back({goal.sku, goal.count});
  MARKETGEN_CHECK(policy.begin(task, now));
  while (!world.done()) {
    MARKETGEN_CHECK(check_interrupt());
    MARKETGEN_TRY(const Action action, policy.act(now));
    MARKETGEN_TRY(now, world.step(action));
  }
  return {};
}

FailureCode failure_of(const EpisodeResult& result, const Policy& policy) {
  if (result.success_strict) return FailureCode::none;
  if (result.is_void) return FailureCode::collision;
  if (result.side_effects.wrong_items > 0) return FailureCode::wrong_item;
  const auto told = value_named<FailureCode>(policy.failure());
  return told && *told != FailureCode::none ? *told : FailureCode::dropped;
}

}  // namespace

Result<EpisodeResult> run_episode(const std::filesystem::path& data,
                                  const EpisodeSpec& spec,
                                  const std::vector<Product>& products,
                                  const std::vector<FrictionRow>& frictions,
                                  const std::string& policy_name,
                                  PictureLibrary& library) {
  const auto began = std::chrono::steady_clock::now();
  MARKETGEN_TRY(CheckoutWorld world, CheckoutWorld::create(data, frictions));
  MARKETGEN_CHECK(world.reset(spec, products));
  Senses senses{CheckoutEyes(world), PicturedProducts(products, frictions, library)};
  MARKETGEN_TRY(const std::unique_ptr<Policy> policy,
                policy_named(policy_name, world, data, senses));
  const auto acted = act_out(world, *policy);
  MARKETGEN_CHECK(check_interrupt());  // an episode that was broken off has no result
  const bool in_time = world.time_s() < spec.limit_s - control_step_s / 2;
  MARKETGEN_TRY(EpisodeResult result, world.finish());
  result.policy = policy_name;
  result.failure = failure_of(result, *policy);
  if (!in_time && !result.success_strict) result.failure = FailureCode::timeout;
  if (!acted.ok()) result.detail = to_string(acted.error());
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  result.wall_s = took.count();
  return result;
}

Result<EpisodeResult> run_episode(const std::filesystem::path& data,
                                  const EpisodeSpec& spec,
                                  const std::vector<Product>& products,
                                  const std::vector<FrictionRow>& frictions,
                                  const std::string& policy) {
  PictureLibrary library;
  return run_episode(data, spec, products, frictions, policy, library);
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
    summary.mean_simulated_s += result.simulated_s / count;
    summary.mean_wall_s += result.wall_s / count;
  }
  summary.goals = share_of(reached, asked);
  summary.strict = share_of(strict, summary.episodes);
  summary.clean = share_of(clean, summary.episodes);
  for (const auto& [failure, episodes] : failures)
    summary.failures.push_back({failure, episodes});
  return summary;
}

}  // namespace marketgen
