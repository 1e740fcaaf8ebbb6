// The robots under data/robots, as every user gets them.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "robots/robot_row.h"

namespace marketgen {

inline const std::filesystem::path committed_rows =
    std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data";

// A robot without links, and a failure, when it does not load.
inline robots::Robot committed_robot(const std::string& id, const robots::RobotTools& tools = {}) {
  auto robot = robots::load_robot(committed_rows, id, tools);
  EXPECT_TRUE(robot.ok()) << (robot.ok() ? "" : to_string(robot.error()));
  return robot.ok() ? std::move(robot).value() : robots::Robot{};
}

// Position (m) and rotation together: the largest entry in which the two matrices differ.
inline double largest_difference(const Pose& a, const Pose& b) {
  const Matrix34 x = matrix_of(a), y = matrix_of(b);
  double worst = 0;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 4; ++c)
      worst = std::max(worst, std::abs(x.m[r][c] - y.m[r][c]));
  }
  return worst;
}

}  // namespace marketgen
