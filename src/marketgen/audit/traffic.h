// NAV and reach: how much of the free floor hangs together for a robot, and which shelves it can
// stand before.
#pragma once
#include "scene/scene.h"

namespace marketgen::audit {

constexpr int robot_radius_mm = 420;  // Realman dual-arm base with shoulders, turning in place

struct Traffic {
  double largest_share = 1;  // largest free component / free floor
  double reachable_shelves =
      1;  // shelves with free floor before them that hangs together with the entrance
  double reachable_bays = 1;  // sides of modules of which one shelf at least is such a shelf
  std::vector<std::uint32_t> unreachable;  // rows of scene.shelves
};

// Footprints of fixtures and columns: what ways over the floor go round.
std::vector<RectMm> obstacles_of(const layout::Layout& layout);

Traffic measure_traffic(const scene::Scene& scene);

}  // namespace marketgen::audit
