// Doors of a store's fixtures that a robot can open: upright hinges with a bar to pull on.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "collect/goods_now.h"
#include "skills/door_ways.h"

namespace marketgen::collect {

// A row of Scene::joints as a door. None for what is no door of this kind: drawers, lids, sliding
// panes, leaves that swing both ways or have no upright round bar before them.
std::optional<skills::HingedDoor> hinged_door(const scene::Scene& scene, std::uint32_t joint);

// The same where it must be one. Error: collect.no_door, with the joint.
Result<skills::HingedDoor> known_door(const scene::Scene& scene, std::uint32_t joint);

// The door that stands before a product when it is shut, a row of Scene::joints, seen from the
// front of its shelf. None where there is none that hinged_door() knows.
std::optional<std::uint32_t> door_before(const scene::Scene& scene, std::uint32_t product);

// The upright rectangle of floor over which an open leaf stands.
RectMm leaf_footprint(const skills::HingedDoor& door, double position_rad);

// What plan_open_door() and plan_shut_door() are asked of a door of the store as it is now, for
// `robot` that drives in the state `driving`. What the robot carries and the tool are the caller's
// to add. The store and the robot must outlive it. Errors: collect.no_door, with the joint; those
// of add_product_obstacles.
Result<skills::DoorQuestion> door_question(const GoodsNow& store,
                                           std::uint32_t joint,
                                           const robots::Robot& robot,
                                           std::vector<double> driving);

}  // namespace marketgen::collect
