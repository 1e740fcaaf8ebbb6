// Reach maps: how much of the space round an arm it can work in, and from how many sides.
//
// A map is a grid of cubes in the frame of the arm's base link. Each cell has the share of tool
// orientations, spread evenly over all rotations, at which the tip reaches the cell's centre within
// the joint limits. Obstacles and the arm's own body are not asked. Deterministic for any number of
// threads.
#pragma once
#include <array>
#include <vector>

#include "robots/arm_ik.h"

namespace marketgen::robots {

struct ReachMapOptions {
  Vec3 low{-1, -1, -0.6}, high{1, 1, 1.4};  // region, m, base link frame; every arm here fits in
  double cell_m = 0.1;
  int directions = 50;  // of the tool's Z axis: a spherical Fibonacci lattice (Swinbank 2006)
  int rolls = 6;        // about each direction
  SweepOptions sweep;   // of the redundancy
};

// The orientations tried, base_from_tip; directions x rolls of them, rolls fastest.
std::vector<Quaternion> reach_orientations(int directions, int rolls);

// Whether any value of a sweep of the redundancy has a solution.
bool can_reach(const ArmIk& arm, const Pose& base_from_tip, const SweepOptions& sweep = {});

struct ReachMap {
  Vec3 low;
  double cell_m = 0;
  std::array<int, 3> cells{};  // along X, Y and Z
  std::vector<float> shares;   // 0..1, X fastest

  Vec3 center(int x, int y, int z) const { return low + Vec3{x + 0.5, y + 0.5, z + 0.5} * cell_m; }
  float share(int x, int y, int z) const {
    return shares[static_cast<std::size_t>((z * cells[1] + y) * cells[0] + x)];
  }
  float share_at(Vec3 point) const;  // of the cell that holds it; 0 outside the map
};

// Errors: robot.bad_state when the region is empty or not finite, a count is below 1, or the map
// would have more than 4 million cells.
Result<ReachMap> make_reach_map(const ArmIk& arm, const ReachMapOptions& options = {});

}  // namespace marketgen::robots
