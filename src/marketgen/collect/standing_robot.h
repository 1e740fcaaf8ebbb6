// Whether robots can stand where they are put in a store: on its floor or on something, clear of
// what is built there and of one another.
//
// A robot is its links' spheres. They hold the capsules with which it touches in a World, and reach
// at most 5 mm beyond them: what stands by this check begins without a contact. The root link's end
// at its base plane: it stands on what carries it.
// Doors and drawers count where they are at rest. Products do not count: a hand may hold one.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "robots/placed_robot.h"
#include "scene/scene.h"

namespace marketgen::collect {

// Errors, at the robot's `where`:
//   robot.outside_store  its base or a link lies outside the walls, or below the floor
//   robot.blocked        a link is in a fixture, a column or an earlier robot of the list; names
//                        both, and the nearest place within 1.5 m where the robot would be clear
//   robot.no_support     its base is in the air; says how high the thing under it is
Result<void> check_standing(const scene::Scene& scene, std::span<const robots::PlacedRobot> robots);

// Robots as a person writes them (placed_robot.h), loaded from the data rows and checked. Errors
// name `where` + the text: those of parse_robot_spec(), place_robot() and check_standing().
Result<std::vector<robots::PlacedRobot>> standing_robots(const scene::Scene& scene,
                                                         std::span<const std::string> texts,
                                                         const std::string& where);

}  // namespace marketgen::collect
