// How a hand comes to a grasp in a basket, over its rim.
//
// Base frame of the arm, metres.
#pragma once
#include <span>
#include <vector>

#include "skills/arm_executor.h"
#include "skills/hand_room.h"

namespace marketgen::skills {

// The tip's pose and the same turned half round, the one that the arm reaches sooner first: a
// parallel gripper holds alike by both.
std::vector<Pose> either_way_round(const ArmExecutor& arm, const Pose& base_from_tip);
// The tip's poses by which a tool of the kind holds alike, those that the arm reaches sooner first:
// either way round of a gripper; of a cup, which may be turned about its axis, the best three.
std::vector<Pose> alike_ways(const ArmExecutor& arm,
                             const Pose& base_from_tip,
                             robots::ToolKind kind);

// The way to a grasp: so long that the fingers come from over the rim, which is so high.
ReachRequest reach_over_rim(const Pose& base_from_tip, double rim_z_m, double opening_m);

// Whether postures bring the tip to both ends of that way, and the open hand goes it without
// meeting the walls.
bool is_reached(const ArmExecutor& arm,
                const ReachRequest& request,
                const std::vector<robots::ToolSolid>& hand,
                std::span<const PlacedBody> walls);

}  // namespace marketgen::skills
