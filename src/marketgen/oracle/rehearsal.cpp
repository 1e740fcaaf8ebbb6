#include "oracle/rehearsal.h"

namespace marketgen::oracle {

Result<void> rehearse_in(episodes::TrackWorld& twin, agent::Policy& actor) {
  agent::Observation seen = twin.observe();
  while (!twin.done()) {
    MARKETGEN_TRY(const agent::Action action, actor.act(seen));
    if (action.stop) return {};
    MARKETGEN_TRY(seen, twin.step(action));
  }
  return {};
}

int harm_in(const episodes::SideEffects& effects) {
  return effects.hard_contacts + effects.toppled + effects.dropped + effects.strayed +
         effects.base_collisions + effects.protective_stops + effects.person_contacts.value_or(0);
}

}  // namespace marketgen::oracle
