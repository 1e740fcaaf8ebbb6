// Where on the floor a robot may be.
#pragma once
#include "catalog/catalog.h"
#include "export/export.h"
#include "navigation/occupancy.h"
#include "scene/scene.h"

namespace marketgen::exporters {

// Cells that the middle of the robot of `options` gets to from the entrance, off the keepout floor;
// all others are blocked. Precondition: check_nav2_options().
navigation::OccupancyGrid robot_floor(const scene::Scene& scene,
                                      const catalog::Catalog& catalog,
                                      const ExportOptions& options);

// Cells on which nothing stands that a robot of `options` would run into. Precondition: as above.
navigation::OccupancyGrid open_floor(const scene::Scene& scene, const ExportOptions& options);

}  // namespace marketgen::exporters
