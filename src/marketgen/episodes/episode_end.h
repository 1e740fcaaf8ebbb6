// How a judged episode is finished off: whose it is, and the one code for why it failed. Whoever
// runs episodes (the evaluation, a policy in Python, an environment) gets the code from here.
#pragma once
#include <optional>
#include <string>

#include "base/result.h"
#include "episodes/episode_result.h"
#include "episodes/track_world.h"

namespace marketgen::episodes {

// How an episode ended, as far as its world does not know.
struct EpisodeEnd {
  std::string policy = {};           // its name
  std::string told = "None";         // what it says kept it from its goals
  std::optional<Error> broken = {};  // the error that ended it before its time
  bool by_policy = false;            // that error is the policy's
  bool in_time = true;
  double wall_s = 0;
  std::optional<agent::ModelUse> model = {};  // that it asked of a model outside of the program
  std::optional<agent::PartsUse> parts = {};  // that it asked of parts in servers
  PolicyIsolation isolation = PolicyIsolation::own;
};

// Whether the agent stopped before the time was over; asked before TrackWorld::finish().
bool ended_in_time(const TrackWorld& world);

// By the first of these that holds: all goals are met, an error broke it off, the time was over,
// the basket was tilted too far or somebody was hurt, wrong items are there, what the policy says.
// A policy's error is PolicyError; Unknown when nobody can say, and when the physics broke it off
// (`detail` says how). A policy may tell any code but None, PolicyError and NotRun.
FailureCode failure_of(const EpisodeResult& judged, const EpisodeEnd& end);

// Adds to a judged result whose it is, why it failed, and the error.
EpisodeResult with_end(EpisodeResult judged, const EpisodeEnd& end);
// Of an episode that nobody could judge: nothing is in place.
EpisodeResult unjudged(const EpisodeSpec& spec);

}  // namespace marketgen::episodes
