// A counter and the basket on it as an arm planner sees them. Base frame of the arm, metres.
#pragma once
#include "agent/workplace.h"
#include "skills/arm_executor.h"

namespace marketgen::skills {

// Where the hand is when it goes along a line.
enum class HandAt { basket, counter };
// Over the inside of the basket, or in it, however high.
bool is_over_basket(const agent::Workplace& place, Vec3 base_point);

// Ways keep off the counter and the basket. Lines keep off the counter and, of the basket, the
// outer skin when the hand is in it (its grasp was tested against the walls themselves, and an
// arm's spheres are larger than the hand), whole walls when it is outside.
Surroundings counter_surroundings(const agent::Workplace& place, HandAt hand);

// The counter alone, for getting away from where something is touched.
Surroundings counter_alone(const agent::Workplace& place);

}  // namespace marketgen::skills
