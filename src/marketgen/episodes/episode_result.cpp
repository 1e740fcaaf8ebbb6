#include "episodes/episode_result.h"

namespace marketgen::episodes {

bool is_clean(const SideEffects& effects) {
  return effects.hard_contacts == 0 && effects.base_collisions == 0 && effects.toppled == 0 &&
         effects.dropped == 0 && effects.strayed == 0 && effects.protective_stops == 0 &&
         effects.doors_open.value_or(0) == 0 && effects.person_contacts.value_or(0) == 0;
}

void add_outcome(const EpisodeOutcome& outcome, EpisodeResult& result) {
  SideEffects& effects = result.side_effects;
  effects.wrong_items = outcome.wrong;
  result.goals = outcome.goals;
  result.hits = outcome.hits;
  result.asked = outcome.asked;
  result.is_void = outcome.is_void;
  result.success_partial =
      outcome.asked > 0 ? static_cast<double>(outcome.hits) / outcome.asked : 0;
  result.success_strict = outcome.asked > 0 && outcome.hits == outcome.asked;
  result.success_clean = result.success_strict && is_clean(effects);
}

}  // namespace marketgen::episodes
