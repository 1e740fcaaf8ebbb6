// How far an episode has come, for rewards that lead from nothing to its end.
#pragma once
#include <vector>

#include "environments/observation_parts.h"
#include "episodes/episode_spec.h"

namespace marketgen::environments {

struct ProgressScale {
  double reach_m = 0, carry_m = 0;  // of the tanh by which distances count
};

// Mean over the goals' items, each from 0 to 1: the tool comes to it (0 to 0.2), has hold of it
// (0.1), it comes nearer to where it is to go (0 to 0.4), is there (0.75), is let go (0.9), has
// rested there as long as the judge wants (1). Of several items of a goal those that have come
// farthest count, and the tool is asked to come to that which lacks least.
double goal_progress(const std::vector<episodes::EpisodeGoal>& goals,
                     const std::vector<EnvironmentItem>& items,
                     const EnvironmentPlace& place,
                     const std::vector<Pose>& tools,
                     const ProgressScale& scale);

}  // namespace marketgen::environments
