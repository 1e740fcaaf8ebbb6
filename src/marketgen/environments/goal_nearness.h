// How near things are to where they are wanted: what dense rewards are made of.
#pragma once
#include <cmath>
#include <functional>
#include <vector>

#include "episodes/episode_spec.h"

namespace marketgen::environments {

// Mean over the items that the goals ask for of 1 - tanh(distance / scale), for each goal its
// nearest items. `distances`: of all items of a goal, metres. An item that is not there is at 0.
double goal_nearness(
    const std::vector<episodes::EpisodeGoal>& goals,
    double scale_m,
    const std::function<std::vector<double>(const episodes::EpisodeGoal& goal)>& distances);

}  // namespace marketgen::environments
