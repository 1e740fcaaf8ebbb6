// Where a robot drives to in a store: doors, tills, and a place before every bay of shelves.
#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "catalog/catalog.h"
#include "export/export.h"
#include "scene/scene.h"

namespace marketgen::exporters {

enum class WaypointKind { entrance, exit, checkout, shelf };
constexpr std::array<std::string_view, 4> names_of(WaypointKind) {
  return {"entrance", "exit", "checkout", "shelf"};
}

// A pose of the robot's base, store frame.
struct Waypoint {
  std::string
      name;  // unique: an opening's id, "<fixture>/queue", "<fixture>/till", "<fixture>/side-0"
  WaypointKind kind = WaypointKind::shelf;
  double x_m = 0, y_m = 0, yaw = 0;     // radians; 0 looks east
  std::string fixture, zone;            // empty for doors
  std::vector<std::string> categories;  // of goods on the bay, those with most items first
};

// Every place keeps the robot's radius from all that stands, lies outside the keepout floor, and is
// reached from the entrance. What has no such place near enough is `unreachable`.
struct Waypoints {
  std::vector<Waypoint> places;
  std::map<std::string, std::vector<std::string>>
      by_category;  // names of shelves' places, those with most items first
  std::vector<std::string> unreachable;
};

Waypoints find_waypoints(const scene::Scene& scene,
                         const catalog::Catalog& catalog,
                         const ExportOptions& options);

}  // namespace marketgen::exporters
