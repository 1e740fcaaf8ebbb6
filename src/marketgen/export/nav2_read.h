// What the files of a nav2 export hold, read as nav2_map_server reads them: its thresholds, its
// three modes, its picture from the top. Nothing here is shared with the writer but file names.
//
// Of YAML only what such files are made of: `key: value` with values in JSON or plain words, and
// lists of one JSON object a line. Whatever else stands there is an error.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/result.h"
#include "geometry/rectangle.h"

namespace marketgen::exporters {

// Values of OccupancyGrid.
constexpr std::int8_t nav2_unknown = -1, nav2_free = 0, nav2_occupied = 100;

// -1 unknown, 0 free to 100 occupied; row by row from the lower left.
struct ReadMap {
  int columns = 0, rows = 0;
  double resolution_m = 0;
  std::array<double, 3> origin{};  // x, y, yaw of the lower left corner
  std::vector<std::int8_t> values;

  // Index of the cell at a point, or of none: then at least values.size().
  std::size_t cell_at(double x_m, double y_m) const;
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  double x_of(int column) const { return origin[0] + (column + 0.5) * resolution_m; }
  double y_of(int row) const { return origin[1] + (row + 0.5) * resolution_m; }
  PointMm center(int column, int row) const;
  std::string in_words(int column, int row) const;  // "the cell at 1.025, 2.025 m"
};

// A map's YAML and the picture that it names. Errors: export.mismatch, io.*, input.*.
Result<ReadMap> read_nav2_map(const std::filesystem::path& yaml);

struct ReadWaypoint {
  std::string name, kind, fixture;  // of doors without a fixture
  double x = 0, y = 0, yaw = 0;
  std::vector<std::string> categories;
};
struct ReadWaypoints {
  double robot_radius = 0;
  std::vector<ReadWaypoint> places;
  std::map<std::string, std::vector<std::string>> by_category;
  std::vector<std::string> unreachable;
};
Result<ReadWaypoints> read_nav2_waypoints(const std::filesystem::path& yaml);

// The maps that a file of parameters names as `yaml_filename`.
Result<std::vector<std::string>> masks_named_in(const std::filesystem::path& yaml);

// The picture that a map's YAML names, as a path. Errors as read_nav2_map().
Result<std::filesystem::path> image_named_in(const std::filesystem::path& yaml);

}  // namespace marketgen::exporters
