// Where a robot that audits shelves takes its pictures: along every run, square to the shelves.
#pragma once
#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "export/export.h"
#include "render/cameras/camera.h"
#include "scene/scene.h"

namespace marketgen::exporters {

struct ShelfShot {
  std::string zone, run;  // the fixture's id where it stands in no run
  int side = 0;           // 1 = back
  double distance_m = 0;  // of the camera before the foremost edge of the shelves there
  render::Camera camera;  // level, its lens above the middle of the robot
};

struct ShelfShots {
  std::vector<ShelfShot> shots;  // run by run, from the left as one looks at it; the lowest first
  int stops_without_room = 0;    // stops at which no floor before the shelves lets the robot stand
};

// Error: usage.bad_flag for options out of range.
Result<void> check_coco_options(const ExportOptions& options);

// Stops lie options.camera_spacing_m apart or a little less. The robot stands
// options.camera_distance_m before the shelves, or as near to that as it gets to from the entrance.
// Precondition: check_nav2_options() and check_coco_options().
ShelfShots shelf_shots(const scene::Scene& scene,
                       const catalog::Catalog& catalog,
                       const ExportOptions& options);

}  // namespace marketgen::exporters
