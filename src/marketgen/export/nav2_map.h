// A store's floor as the maps of ROS 2's Nav2: what a robot would run into, where it must not go,
// and where it must go slowly.
#pragma once
#include <cstdint>
#include <vector>

#include "base/result.h"
#include "catalog/catalog.h"
#include "export/export.h"
#include "navigation/occupancy.h"
#include "scene/scene.h"

namespace marketgen::exporters {

enum class Nav2Cell : std::uint8_t { free, occupied, unknown };

// Cells row by row from the south-west, as in OccupancyGrid, over the room and its walls. Cells of
// the room lie as those of a grid made for the floor alone.
struct Nav2Map {
  navigation::OccupancyGrid frame;  // where the cells lie; none is blocked
  std::vector<Nav2Cell> cells;
  std::vector<std::uint8_t> keepout;        // 1: robots keep out, of all outside the room, too
  std::vector<std::uint8_t> speed_percent;  // of the robot's greatest speed; 0: no limit
};

// What stands on the floor lower than options.robot_height_m: fixtures by their footprints,
// columns, and products that the plan put somewhere else than on a shelf. None is thinner than a
// cell, so that none falls between the cells.
std::vector<RectMm> nav2_obstacles(const scene::Scene& scene, const ExportOptions& options);

// Robots drive slowly in aisles that lead to tills, and where a shopper with a basket and the robot
// cannot pass each other.
bool is_slow_aisle(const layout::Aisle& aisle, const ExportOptions& options);

// Whole millimetres.
int nav2_cell_mm(const ExportOptions& options);

// Error: usage.bad_flag for options out of range, and for a store of too many cells.
Result<void> check_nav2_options(const scene::Scene& scene, const ExportOptions& options);

// Precondition: check_nav2_options().
Nav2Map make_nav2_map(const scene::Scene& scene,
                      const catalog::Catalog& catalog,
                      const ExportOptions& options);

}  // namespace marketgen::exporters
