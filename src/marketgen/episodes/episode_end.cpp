#include "episodes/episode_end.h"

namespace marketgen::episodes {
namespace {

FailureCode told_by_policy(const std::string& word) {
  const auto told = value_named<FailureCode>(word);
  const bool may_be_told = told && *told != FailureCode::none &&
                           *told != FailureCode::policy_error && *told != FailureCode::not_run;
  return may_be_told ? *told : FailureCode::unknown;
}

}  // namespace

bool ended_in_time(const TrackWorld& world) {
  return world.time_s() < world.spec().limit_s - control_step_s / 2;
}

FailureCode failure_of(const EpisodeResult& judged, const EpisodeEnd& end) {
  if (judged.success_strict) return FailureCode::none;
  if (end.broken) return end.by_policy ? FailureCode::policy_error : FailureCode::unknown;
  if (!end.in_time) return FailureCode::timeout;
  if (judged.is_void) return FailureCode::collision;
  if (judged.side_effects.wrong_items > 0) return FailureCode::wrong_item;
  return told_by_policy(end.told);
}

EpisodeResult with_end(EpisodeResult judged, const EpisodeEnd& end) {
  judged.policy = end.policy;
  judged.isolation = end.isolation;
  judged.failure = failure_of(judged, end);
  if (end.broken) judged.detail = to_string(*end.broken);
  judged.wall_s = end.wall_s;
  judged.model = end.model;
  judged.parts = end.parts;
  return judged;
}

EpisodeResult unjudged(const EpisodeSpec& spec) {
  EpisodeResult result;
  result.episode = spec.id;
  result.store = spec.store;
  result.scene_hash = spec.scene_hash;
  for (const EpisodeGoal& goal : spec.goals) {
    result.goals.push_back({goal.sku, goal.count, 0});
    result.asked += goal.count;
  }
  return result;
}

}  // namespace marketgen::episodes
