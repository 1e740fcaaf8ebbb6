#include "audit/traffic.h"

#include <algorithm>
#include <map>
#include <utility>

#include "navigation/occupancy.h"
#include "plan/bsp.h"
#include "plan/floor_places.h"
#include "scene/standing_place.h"

namespace marketgen::audit {
namespace {

// Component that people enter: that of the first entrance, or the largest.
int entrance_component(const layout::Layout& layout,
                       const navigation::OccupancyGrid& grid,
                       const navigation::Components& components) {
  constexpr int search_mm = 1500;
  for (const plan::Opening& opening : layout.shell.openings) {
    if (opening.kind != plan::OpeningKind::entrance) continue;
    const PointMm inside =
        plan::point_inside(plan::shell_rect(layout.shell), opening, robot_radius_mm + 100);
    const auto cell = navigation::nearest_free(grid, inside, search_mm);
    if (cell) return components.label[*cell];
  }
  return components.largest();
}

}  // namespace

std::vector<RectMm> obstacles_of(const layout::Layout& layout) {
  std::vector<RectMm> obstacles;
  for (const layout::Fixture& fixture : layout.fixtures)
    obstacles.push_back(layout::footprint_of(fixture));
  for (const plan::Column& column : layout.shell.columns)
    obstacles.push_back(plan::footprint_of(column));
  return obstacles;
}

Traffic measure_traffic(const scene::Scene& scene) {
  Traffic traffic;
  const navigation::OccupancyGrid grid = navigation::make_occupancy(
      plan::floor_of(scene.layout.shell), obstacles_of(scene.layout), robot_radius_mm);
  const navigation::Components components = navigation::find_components(grid);
  std::int64_t free_cells = 0;
  for (std::size_t c = 1; c < components.cells.size(); ++c)
    free_cells += components.cells[c];
  const int largest = components.largest();
  if (free_cells == 0)
    traffic.largest_share = 0;
  else
    traffic.largest_share =
        static_cast<double>(components.cells[static_cast<std::size_t>(largest)]) /
        static_cast<double>(free_cells);

  const int entrance = entrance_component(scene.layout, grid, components);
  std::map<std::pair<std::uint32_t, std::int32_t>, bool> bays;  // fixture and side: is it reached
  for (std::uint32_t shelf = 0; shelf < scene.shelves.size(); ++shelf) {
    const auto cell = navigation::nearest_free(
        grid, scene::standing_point(scene, shelf), scene::standing_reach_mm);
    const bool is_reached = cell && components.label[*cell] == entrance;
    if (!is_reached) traffic.unreachable.push_back(shelf);
    bays[{scene.shelves[shelf].fixture, scene.shelves[shelf].side}] |= is_reached;
  }
  if (!scene.shelves.empty()) {
    traffic.reachable_shelves = 1 - static_cast<double>(traffic.unreachable.size()) /
                                        static_cast<double>(scene.shelves.size());
    const auto reached = std::ranges::count_if(bays, [](const auto& bay) { return bay.second; });
    traffic.reachable_bays = static_cast<double>(reached) / static_cast<double>(bays.size());
  }
  return traffic;
}

}  // namespace marketgen::audit
