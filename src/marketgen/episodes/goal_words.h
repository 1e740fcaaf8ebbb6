// How an episode says what it asks for.
#pragma once
#include "episodes/referring_expression.h"

namespace marketgen::episodes {

// Writes the instruction and, in words, each goal's text: as spec.instructions says. `offer`: what
// the goals are told apart from; has all of them. False when words would fit another product, too.
bool tell_goals(const Offer& offer, InstructionVerb verb, Seed seed, EpisodeSpec& spec);

}  // namespace marketgen::episodes
