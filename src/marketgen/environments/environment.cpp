#include "environments/environment.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/build_info.h"
#include "base/byte_archive.h"
#include "base/hash.h"
#include "environments/environment_entry.h"
#include "episodes/check_episodes.h"
#include "episodes/track_entry.h"
#include "io/json.h"

namespace marketgen::environments {
namespace {

constexpr char state_tag[] = "market-state/1";

// What the numbers of a state mean depends on these.
std::string made_by(const episodes::TrackWorld& world) {
  return fmt::format("{} {} {:016x} {}",
                     state_tag,
                     program_version,
                     hash64(io::write_json_line(world.spec())),
                     world.realism().name);
}

}  // namespace

Result<std::unique_ptr<Environment>> Environment::create(std::shared_ptr<EpisodeGround> ground,
                                                         episodes::Track track,
                                                         const EnvironmentOptions& options) {
  return environment_entry_of(track).environment(std::move(ground), options);
}

void Environment::set_robot(const robots::Robot& robot, const ObservationBounds& bounds) {
  const bool opens = options_.stage == episodes::Stage::open;
  actions_.emplace(robot,
                   options_.control,
                   options_.stop,
                   opens ? episodes::opening_grip_n : agent::ToolCommand{}.force_n);
  parts_ = robot_parts(robot, bounds);
  item_rows_ = options_.item_rows > 0 ? options_.item_rows : ground_->max_items(track_);
  if (options_.privileged)
    std::ranges::move(privileged_parts(robot, item_rows_, bounds), std::back_inserter(parts_));
  for (const ObservationPart& part : parts_) {
    size_ += count_of(part);
    low_.insert(low_.end(), part.low.begin(), part.low.end());
    high_.insert(high_.end(), part.high.begin(), part.high.end());
  }
}

Result<void> Environment::check_room(const episodes::EpisodeSpec& spec) const {
  const int items = episodes::entry_of(track_).items_of(spec);
  if (!options_.privileged || items <= item_rows_) return {};
  return Error{"episode.impossible",
               spec.id,
               fmt::format("observations of \"state\" have room for {} items, the episode is about "
                           "{}; use \"state_robot\", or a file that has it",
                           item_rows_,
                           items)};
}

// At what only some options need.
Result<void> Environment::look() {
  if (!options_.privileged && options_.reward != RewardMode::shaped) return {};
  MARKETGEN_TRY(seen_items_, items());
  if (options_.reward == RewardMode::shaped) progress_ = progress_now();
  return {};
}

Result<void> Environment::reset(const episodes::EpisodeSpec& spec) {
  if (spec.track != track_)
    return Error{
        "episode.unknown_track",
        spec.id,
        fmt::format(
            "it is of the track {}, the environment of {}", name_of(spec.track), name_of(track_))};
  MARKETGEN_CHECK(episodes::check_episode(spec, spec.id));
  MARKETGEN_CHECK(ground_->check(spec));
  MARKETGEN_CHECK(check_room(spec));
  run_.reset();
  MARKETGEN_TRY(episodes::TrackWorld* const world, begin(spec));
  run_.emplace(*world, options_.stop ? EndsWhen::agent_stops : EndsWhen::goals_are_met);
  target_ = world->observe().position;
  cuts_.clear();
  ++resets_;
  return look();
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

Result<episodes::WayToStand> Environment::way_to_stand() const {
  return Error{"usage.bad_flag", "way_to_stand", "at a counter nobody drives"};
}

Result<episodes::DoorSeen> Environment::door() const {
  return Error{"usage.bad_flag", "door", "at a counter there is none"};
}

Result<StepOutcome> Environment::step(std::span<const double> action) {
  MARKETGEN_CHECK(check(action));
  MARKETGEN_TRY(MappedAction mapped, actions_->action(action, world().sensed_state(), target_));
  MARKETGEN_TRY(const RunStep made, run_->step(mapped.action));
  target_ = actions_->led(mapped.action.position, world().told());
  cuts_ = std::move(mapped.cuts);
  const double before = progress_;
  MARKETGEN_CHECK(made.terminated || made.truncated ? finish() : look());
  StepOutcome outcome{0, made.terminated, made.truncated};
  outcome.reward = options_.reward == RewardMode::shaped ? progress_ - before : reward();
  return outcome;
}

Result<void> Environment::finish() {
  MARKETGEN_CHECK(run_->finish());
  return look();
}

episodes::EpisodeResult Environment::judged(episodes::EpisodeEnd end) {
  if (!run_->result()) {
    const auto done = finish();
    if (!done.ok() && !end.broken) end.broken = done.error();
  }
  return run_->judged(std::move(end));
}

bool Environment::succeeded() const {
  return run_->result() && run_->result()->success_strict;
}

double Environment::progress_now() const {
  if (succeeded()) return 1;
  const auto tools = actions_->tool_poses(world().robot_state());
  return goal_progress(world().spec().goals, seen_items_, place(), tools, progress_scale());
}

double Environment::reward() const {
  const auto& result = run_->result();
  if (options_.reward == RewardMode::sparse) return result ? result->success_partial : 0.0;
  return succeeded() ? 1 : nearness();
}

void Environment::observe(std::span<float> into) const {
  const RobotSeen seen{world().observe(), tool_poses()};
  std::vector<double> numbers;
  numbers.reserve(size_);
  add_robot_numbers(world().robot(), seen, numbers);
  if (options_.privileged)
    add_privileged_numbers(seen_items_,
                           item_rows_,
                           place(),
                           actions_->tool_poses(world().robot_state()),
                           world().spec().instruction,
                           numbers);
  for (std::size_t i = 0; i < size_; ++i)
    into[i] = static_cast<float>(std::clamp(numbers[i], low_[i], high_[i]));
}

std::string Environment::save() const {
  ByteWriter writer;
  const std::string result = run_->result() ? io::write_json(*run_->result()) : "";
  writer(made_by(world()), world().save(), target_, run_->in_time(), result);
  const std::string content = writer.take();
  writer(hash64(content), content);
  return writer.take();
}

Result<void> Environment::restore(std::string_view moment) {
  const auto bad = [&](const char* message) {
    return Error{"physics.bad_command", "state", message};
  };
  std::uint64_t hash = 0;
  std::string content, made, state, result;
  ByteReader whole(moment);
  whole(hash, content);
  if (!whole.ok() || hash64(content) != hash)
    return bad("these bytes are no whole state of an environment");
  std::vector<double> target;
  bool in_time = true;
  ByteReader reader(content);
  reader(made, state, target, in_time, result);
  if (!reader.ok() || made != made_by(world()) || target.size() != target_.size())
    return bad("the state is of another episode or realism, or of another version of marketgen");
  std::optional<episodes::EpisodeResult> ended;
  if (!result.empty()) {
    MARKETGEN_TRY(ended, io::read_json<episodes::EpisodeResult>(result, "state"));
  }
  MARKETGEN_CHECK(run_->restore(state, in_time, std::move(ended)));
  target_ = std::move(target);
  cuts_.clear();
  return look();
}

}  // namespace marketgen::environments
