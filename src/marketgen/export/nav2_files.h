// What writer and reader of the nav2 export share: names of files, shades of cells, and how maps
// are read.
#pragma once
#include <cstdint>
#include <string_view>

namespace marketgen::exporters {

constexpr const char *nav2_map_image = "map.pgm", *nav2_filters = "filters.yaml",
                     *nav2_waypoints = "waypoints.yaml";

// As nav2_map_server reads them: how occupied a cell is, is how dark; more than `occupied_thresh`
// is occupied, less than `free_thresh` free, all between unknown (trinary) or so many percent
// (scale).
struct Nav2Mode {
  std::string_view name;
  double occupied_thresh, free_thresh;
};
constexpr Nav2Mode nav2_trinary{"trinary", 0.65, 0.25};
constexpr Nav2Mode nav2_scale{"scale", 1.0, 0.0};

// Not the 205 of map_saver: with Nav2's own free_thresh of 0.25 that is read as free.
constexpr std::uint8_t nav2_free_shade = 254, nav2_occupied_shade = 0, nav2_unknown_shade = 128;

}  // namespace marketgen::exporters
