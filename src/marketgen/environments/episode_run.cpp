#include "environments/episode_run.h"

#include <utility>

namespace marketgen::environments {

Result<RunStep> EpisodeRun::step(const agent::Action& action) {
  RunStep made;
  MARKETGEN_TRY(made.now, world_.step(action));
  made.terminated = action.stop;
  if (rule_ == EndsWhen::goals_are_met) {
    MARKETGEN_TRY(made.terminated, world_.goals_met());
  }
  made.truncated = world_.done() && !made.terminated;
  return made;
}

Result<void> EpisodeRun::finish() {
  if (result_) return {};
  in_time_ = episodes::ended_in_time(world_);
  MARKETGEN_TRY(episodes::EpisodeResult judged, world_.finish());
  episodes::EpisodeEnd end;
  end.in_time = in_time_;
  result_ = episodes::with_end(std::move(judged), end);
  return {};
}

episodes::EpisodeResult EpisodeRun::judged(episodes::EpisodeEnd end) {
  const Result<void> done = finish();
  end.in_time = in_time_;
  if (result_) return episodes::with_end(*result_, end);
  if (!end.broken) end.broken = done.error();
  episodes::EpisodeResult open = episodes::unjudged(world_.spec());
  open.realism = world_.realism().name;
  return episodes::with_end(std::move(open), end);
}

Result<void> EpisodeRun::restore(std::string_view world,
                                 bool in_time,
                                 std::optional<episodes::EpisodeResult> result) {
  MARKETGEN_CHECK(world_.restore(world));
  in_time_ = in_time;
  result_ = std::move(result);
  return {};
}

}  // namespace marketgen::environments
