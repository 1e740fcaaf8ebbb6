// Gravity as everything here has it: physics, grasps, the robots' own models and hinges of
// fixtures.
#pragma once

namespace marketgen {

// m/s^2, along -Z. 9.80665 (ISO 80000-3) rounded as MuJoCo has it.
inline constexpr double standard_gravity = 9.81;

}  // namespace marketgen
