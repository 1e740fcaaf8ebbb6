// People whom a robot's scanner tells of, as what its ways keep clear of.
#pragma once
#include <vector>

#include "agent/policy.h"
#include "motion/base_follower.h"

namespace marketgen::skills {

// Between the base, whose own margin is 0.1 m, and somebody's body: 0.5 m with it, as beside a
// truck without a driver (ISO 3691-4).
inline constexpr double clear_of_people_m = 0.4;

// Where they are taken to stand on the robot's map, each with the room about them.
std::vector<motion::MovingDisc> people_about(const agent::Observation& now);

// Whether somebody is in the way of a base that goes straight ahead, or back.
bool is_in_way(const agent::Observation& now, bool back);

}  // namespace marketgen::skills
