// The parts of the check of a nav2 export: what its masks and waypoints say, held against the
// layout and the items.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "export/export.h"
#include "export/nav2_read.h"
#include "scene/scene.h"

namespace marketgen::exporters {

// How much of each cell of the map lies in any of the polygons.
enum class Covered : std::uint8_t { none, partly, wholly };
std::vector<Covered> covered_by(const ReadMap& map, const std::vector<PolygonMm>& polygons);

// Robots keep out of all outside the room and of the staff's floor, and of nothing else.
Result<void> compare_keepout(const scene::Scene& scene,
                             const catalog::Catalog& catalog,
                             const ReadMap& keepout,
                             const std::string& where);

// They drive slowly before doors and where people pay; elsewhere only in narrow aisles.
Result<void> compare_speed(const scene::Scene& scene,
                           const catalog::Catalog& catalog,
                           const ExportOptions& options,
                           const ReadMap& speed,
                           const std::string& where);

// The servers' parameters name the masks, as seen from the folder of `map`.
Result<void> check_filters(const std::filesystem::path& map, const std::filesystem::path& filters);

// A robot has room at every place, and a way from the first, which is a door.
Result<void> check_ways(const ReadWaypoints& waypoints,
                        const ReadMap& map,
                        const ReadMap& keepout,
                        const std::string& where);

// Doors, tills and bays have a place each, or are named as what has none; before bays the robot
// looks at them from where it reaches them, and they sell what the places say.
Result<void> compare_places(const scene::Scene& scene,
                            const catalog::Catalog& catalog,
                            const ReadMap& map,
                            const ReadWaypoints& waypoints,
                            const std::string& where);

}  // namespace marketgen::exporters
