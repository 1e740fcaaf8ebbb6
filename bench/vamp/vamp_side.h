// VAMP's RRT-Connect and simplification for its Panda, with its own settings.
#pragma once
#include <array>
#include <vector>

struct VampBox {
  std::array<float, 3> middle, half_size;  // m, axes along the world's
};
struct VampAnswer {
  bool asked = false, solved = false;  // asked: it holds start and goal for free
  double search_us = 0, simplify_us = 0;
  std::vector<std::array<float, 7>> path;
};
VampAnswer vamp_solve(const std::vector<VampBox>& boxes,
                      const std::array<float, 7>& start,
                      const std::array<float, 7>& goal,
                      int calls);
