#include "environments/program_policy.h"

#include "environments/run_episode.h"

namespace marketgen::environments {

Result<void> ProgramPolicy::begin() {
  policy_.reset();
  const episodes::TrackWorld& world = environment_.world();
  MARKETGEN_TRY(policy_, environment_.ground().policy(name_, world));
  MARKETGEN_CHECK(policy_->begin(task_of(world.spec()), world.observe()));
  reset_ = environment_.resets();
  return {};
}

Result<std::vector<double>> ProgramPolicy::act() {
  if (!environment_.running())
    return Error{"episode.bad_action",
                 "environment",
                 "the episode is over, or has not begun: reset the environment first"};
  if (!policy_ || reset_ != environment_.resets()) MARKETGEN_CHECK(begin());
  MARKETGEN_TRY(const agent::Action wanted, policy_->act(environment_.world().observe()));
  return environment_.numbers_of(wanted);
}

}  // namespace marketgen::environments
