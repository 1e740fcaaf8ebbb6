// How well a robot can move a frame of it from where it stands.
#pragma once
#include <span>
#include <vector>

#include "robots/robot.h"

namespace marketgen::robots {

// The smallest singular value of the frame's Jacobian over these degrees of freedom: how far, m or
// rad, it moves at least when its joints move by 1. At 0 there is a way in which it cannot be
// moved.
double min_gain(const Robot& robot,
                std::span<const double> q,
                int frame,
                const std::vector<int>& dofs);

// How far the nearest of these degrees of freedom is from a limit of its joint, rad or m; negative
// beyond it.
double min_room(const Robot& robot, std::span<const double> q, const std::vector<int>& dofs);

}  // namespace marketgen::robots
