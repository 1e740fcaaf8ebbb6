// How episodes are drawn, whatever their track.
#pragma once
#include <string>

#include "episodes/certificate.h"
#include "episodes/difficulty.h"
#include "episodes/episode_spec.h"
#include "episodes/training_set.h"

namespace marketgen::episodes {

struct DrawRules {
  Split split = Split::planned;
  Instructions instructions = Instructions::words;
  TrainingSet trained_on = {};  // no goal is of it
  Doors doors = Doors::none;    // aisle: where goals stand
  Difficulty difficulty = {};
  std::string station = {};  // checkout: a row of data/benchmark; the track's own when empty
};

}  // namespace marketgen::episodes
