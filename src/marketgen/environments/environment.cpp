#include "environments/environment.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "environments/aisle_environment.h"
#include "environments/checkout_environment.h"
#include "episodes/check_episodes.h"

namespace marketgen {
namespace {

constexpr int pose_numbers = 7, place_numbers = 3;

std::size_t count_of(const ObservationPart& part) {
  std::size_t count = 1;
  for (const int length : part.shape)
    count *= static_cast<std::size_t>(length);
  return count;
}

bool has_cup(const Robot& robot) {
  return std::ranges::find(robot.tools, ToolKind::suction, &Tool::kind) != robot.tools.end();
}

std::vector<ObservationPart> parts_of(const Robot& robot) {
  const int joints = static_cast<int>(commanded_dofs(robot).size());
  const int tools = static_cast<int>(robot.tools.size());
  std::vector<ObservationPart> parts{{"agent", "qpos", {joints + tools}},
                                     {"agent", "qvel", {joints}}};
  parts.push_back({"extra",
                   "tcp_pose",
                   tools == 1 ? std::vector{pose_numbers} : std::vector{tools, pose_numbers}});
  if (robot.drive) parts.push_back({"extra", "base_pose", {place_numbers}});
  if (has_cup(robot)) parts.push_back({"agent", "sealed", {tools}});
  return parts;
}

}  // namespace

Result<std::unique_ptr<Environment>> Environment::create(std::shared_ptr<EpisodeGround> ground,
                                                         Track track,
                                                         const EnvironmentOptions& options) {
  if (track == Track::aisle) return make_aisle_environment(std::move(ground), options);
  return make_checkout_environment(std::move(ground), options);
}

void Environment::set_robot(const Robot& robot) {
  actions_.emplace(robot, options_.control);
  parts_ = parts_of(robot);
  for (const ObservationPart& part : parts_)
    size_ += count_of(part);
}

Result<void> Environment::reset(const EpisodeSpec& spec) {
  if (spec.track != track_)
    return Error{
        "episode.unknown_track",
        spec.id,
        fmt::format(
            "it is of the track {}, the environment of {}", name_of(spec.track), name_of(track_))};
  MARKETGEN_CHECK(check_episode(spec, spec.id));
  MARKETGEN_CHECK(ground_->check(spec));
  world_ = nullptr;
  result_.reset();
  MARKETGEN_TRY(world_, begin(spec));
  target_ = world_->observe().position;
  return {};
}

Result<void> Environment::check(std::span<const double> action) const {
  const auto bad = [](std::string message) {
    return Error{"episode.bad_action", "action", std::move(message)};
  };
  if (!running()) return bad("the episode is over, or has not begun: reset it first");
  if (action.size() != action_numbers().size())
    return bad(fmt::format("{} numbers; expected {}", action.size(), action_numbers().size()));
  for (std::size_t i = 0; i < action.size(); ++i)
    if (!std::isfinite(action[i]))
      return bad(fmt::format(
          "number {} ({}) is {}; expected a finite one", i, action_numbers()[i].name, action[i]));
  return {};
}

Result<StepOutcome> Environment::step(std::span<const double> action) {
  MARKETGEN_CHECK(check(action));
  const Action made = actions_->action(action, world_->robot_state(), target_);
  const auto stepped = world_->step(made);
  if (!stepped.ok()) return stepped.error();
  target_ = actions_->within_limits(made.position);
  StepOutcome outcome;
  if (world_->done()) {
    MARKETGEN_CHECK(finish());
    outcome.terminated = made.stop;
    outcome.truncated = !made.stop;
  }
  outcome.reward = reward();
  return outcome;
}

Result<void> Environment::finish() {
  in_time_ = world_->time_s() < world_->spec().limit_s - control_step_s / 2;
  MARKETGEN_TRY(result_, world_->finish());
  return {};
}

EpisodeResult Environment::judged(EpisodeEnd end) {
  if (!result_) {
    if (const auto done = finish(); !done.ok()) {
      if (!end.broken) end.broken = done.error();
      return with_end(unjudged(world_->spec()), end);
    }
  }
  end.in_time = in_time_;
  return with_end(*result_, end);
}

double Environment::reward() const {
  if (options_.reward == RewardMode::sparse) return result_ ? result_->success_partial : 0;
  return result_ && result_->success_strict ? 1 : nearness();
}

void Environment::observe(std::span<float> into) const {
  const Observation seen = world_->observe();
  auto next = into.begin();
  const auto add = [&](double value) { *next++ = static_cast<float>(value); };
  std::ranges::for_each(seen.position, add);
  std::ranges::for_each(seen.openings_m, add);
  std::ranges::for_each(seen.velocity, add);
  for (const Pose& p : actions_->tool_poses(world_->robot_state()))
    for (const double value : {p.position.x,
                               p.position.y,
                               p.position.z,
                               p.rotation.w,
                               p.rotation.x,
                               p.rotation.y,
                               p.rotation.z})
      add(value);
  if (world_->robot().drive)
    for (const double value : {seen.base.x_m, seen.base.y_m, seen.base.heading})
      add(value);
  if (has_cup(world_->robot())) std::ranges::for_each(seen.sealed, add);
}

}  // namespace marketgen
