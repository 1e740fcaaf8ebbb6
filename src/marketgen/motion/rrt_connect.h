// RRT-Connect (Kuffner and LaValle, ICRA 2000) and shortcutting in a box of joint positions.
//
// Knows no robot: what is free is asked of the caller. Random numbers come from the seed's named
// streams alone, and every loop has a limit in iterations, never in time, so the same question has
// the same answer on every machine.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "base/result.h"
#include "base/seed.h"

namespace marketgen::motion {

using Configuration = std::vector<double>;  // rad or m, one a joint
using JointPath = std::vector<Configuration>;

// The callbacks must answer the same each time they are asked.
struct ConfigurationSpace {
  std::vector<double> lower, upper;  // finite, lower <= upper
  std::function<bool(std::span<const double>)> free;
  // The second configuration and the straight motion to it from the first, which is free.
  std::function<bool(std::span<const double>, std::span<const double>)> motion_free;
};

struct RrtOptions {
  int max_iterations = 20'000;  // random samples in all
  int max_nodes = 40'000;       // of both trees
  double range = 1.5;           // longest extension, Euclidean over the joints, rad
};

// A path from `start` to one of `goals`; both ends included. Errors: motion.bad_configuration
// (sizes, NaN, outside the box), motion.start_in_collision, motion.goal_in_collision (every goal),
// motion.no_path when the limits are used up.
Result<JointPath> rrt_connect(const ConfigurationSpace& space,
                              const Configuration& start,
                              const std::vector<Configuration>& goals,
                              Seed seed,
                              const RrtOptions& options = {});

// The path without needless corners: corners that can be skipped are, before and after `tries`
// random chords between two places of it. Never longer, ends unchanged; every new piece was asked
// of motion_free.
JointPath shortcut(const ConfigurationSpace& space, JointPath path, Seed seed, int tries = 60);

double distance(std::span<const double> a, std::span<const double> b);  // Euclidean
double length_of(const JointPath& path);

}  // namespace marketgen::motion
