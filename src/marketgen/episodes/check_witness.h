// Whether an episode's certificate can be of this episode, as far as the file alone tells.
//
// Not seen here: whether a store has the product that an aisle's pick names, whether the robot
// stands free there, whether the items of a basket can be taken in the witness's order. Only
// planning it again, or the actors of Split::certified, would tell.
#pragma once
#include <string>

#include "base/result.h"
#include "episodes/episode_spec.h"

namespace marketgen::episodes {

// At "WHERE/certificate/...". Error episode.bad_value for a condition that is none of the track's,
// or there twice; for conditions that only a planned way shows where the witness does not fetch
// every goal; for a pick of what is not in the episode, of one thing twice, by a strategy or a
// grasp that there is not.
Result<void> check_witness(const EpisodeSpec& spec, const std::string& where);

}  // namespace marketgen::episodes
