#include "export/robot_floor.h"

#include <cmath>

#include "export/nav2_map.h"
#include "layout/floor.h"
#include "layout/reach.h"
#include "layout/staff_floor.h"
#include "plan/bsp.h"

namespace marketgen::exporters {
namespace {

navigation::OccupancyGrid floor_for(const scene::Scene& scene,
                                    const ExportOptions& options,
                                    int clearance_mm) {
  return navigation::make_occupancy(plan::floor_of(scene.layout.shell),
                                    nav2_obstacles(scene, options),
                                    clearance_mm,
                                    nav2_cell_mm(options));
}

}  // namespace

navigation::OccupancyGrid robot_floor(const scene::Scene& scene,
                                      const catalog::Catalog& catalog,
                                      const ExportOptions& options) {
  std::vector<PolygonMm> keepout;
  for (const layout::StaffFloor& staff : layout::staff_floor(scene.layout, catalog))
    keepout.push_back(staff.polygon_mm);
  const plan::Shell& shell = scene.layout.shell;
  const int radius_mm = static_cast<int>(std::lround(options.robot_radius_m * 1000));
  layout::Reach reach =
      layout::reach_on(with_blocked(floor_for(scene, options, radius_mm), keepout),
                       layout::make_floor(shell),
                       shell);
  for (std::size_t cell = 0; cell < reach.grid.blocked.size(); ++cell) {
    if (!reach.reached(cell)) reach.grid.blocked[cell] = 1;
  }
  return std::move(reach.grid);
}

navigation::OccupancyGrid open_floor(const scene::Scene& scene, const ExportOptions& options) {
  return floor_for(scene, options, 0);
}

}  // namespace marketgen::exporters
