// What the oracles rehearse: what they have begun is carried out in a twin of their world, and only
// what does no harm there is done. Physics repeats itself bit for bit, and so do the oracles.
#pragma once
#include "agent/policy.h"
#include "base/result.h"
#include "episodes/track_world.h"

namespace marketgen::oracle {

// Worse than any harm that the ledger counts.
constexpr int harm_of_void = 100, harm_of_not_placed = 10;

// Lets `actor` act in the twin until it stops or the time is over.
Result<void> rehearse_in(episodes::TrackWorld& twin, agent::Policy& actor);

// What the ledger has so far of what no clean episode has (is_clean()).
int harm_in(const episodes::SideEffects& effects);

}  // namespace marketgen::oracle
