// The map's YAML, and beside it the pictures, masks, their servers' parameters and the waypoints.
#include <fmt/format.h>

#include <cmath>

#include "base/fields.h"
#include "export/exporter.h"
#include "export/nav2_files.h"
#include "export/nav2_map.h"
#include "export/nav2_waypoints.h"
#include "io/file.h"
#include "io/json.h"

namespace marketgen::exporters {
namespace {

// JSON is YAML, and its quotes keep any name whole.
std::string quoted(const std::string& text) {
  return io::write_json_line(text);
}

std::string quoted_list(const std::vector<std::string>& texts) {
  std::string list;
  for (const std::string& text : texts)
    list += (list.empty() ? "" : ", ") + quoted(text);
  return "[" + list + "]";
}

// Netpbm's P5, north at the top.
std::string pgm(const navigation::OccupancyGrid& frame, const std::vector<std::uint8_t>& shades) {
  std::string bytes = fmt::format("P5\n{} {}\n255\n", frame.columns, frame.rows);
  bytes.reserve(bytes.size() + shades.size());
  for (int row = frame.rows - 1; row >= 0; --row) {
    const auto from = shades.begin() + static_cast<std::ptrdiff_t>(frame.index(0, row));
    bytes.append(from, from + frame.columns);
  }
  return bytes;
}

template <class Cell, class Shade>
std::string picture_of(const navigation::OccupancyGrid& frame,
                       const std::vector<Cell>& cells,
                       Shade shade_of) {
  std::vector<std::uint8_t> shades;
  shades.reserve(cells.size());
  for (const Cell& cell : cells)
    shades.push_back(shade_of(cell));
  return pgm(frame, shades);
}

std::uint8_t shade_of_cell(Nav2Cell cell) {
  switch (cell) {
    case Nav2Cell::free:
      return nav2_free_shade;
    case Nav2Cell::occupied:
      return nav2_occupied_shade;
    case Nav2Cell::unknown:
      return nav2_unknown_shade;
  }
  fatal("no such cell");
}

// Read in the mode `scale` as the cell's value, 0 to 100.
std::uint8_t shade_of_value(int value) {
  return static_cast<std::uint8_t>(255 - std::lround(value * 2.55));
}

std::string map_yaml(const std::string& image,
                     const navigation::OccupancyGrid& frame,
                     const Nav2Mode& mode) {
  return fmt::format(
      "image: {}\n"
      "mode: {}\n"
      "resolution: {}\n"
      "origin: [{}, {}, 0]\n"
      "negate: 0\n"
      "occupied_thresh: {}\n"
      "free_thresh: {}\n",
      quoted(image),
      mode.name,
      frame.cell_mm / 1000.0,  // the nearest number to so many millimetres, as `* 1e-3` is not
      frame.bounds.x0 / 1000.0,
      frame.bounds.y0 / 1000.0,
      mode.occupied_thresh,
      mode.free_thresh);
}

std::string waypoint_line(const Waypoint& place) {
  std::string line =
      fmt::format(R"(  - {{"name": {}, "kind": "{}", "x": {:.3f}, "y": {:.3f}, "yaw": {:.4f})",
                  quoted(place.name),
                  name_of(place.kind),
                  place.x_m,
                  place.y_m,
                  std::round(place.yaw * 1e4) * 1e-4 + 0.0);  // no -0.0000
  if (!place.fixture.empty())
    line +=
        fmt::format(R"(, "fixture": {}, "zone": {})", quoted(place.fixture), quoted(place.zone));
  if (place.kind == WaypointKind::shelf)
    line += fmt::format(R"(, "categories": {})", quoted_list(place.categories));
  return line + "}\n";
}

std::string waypoints_yaml(const Waypoints& found, const ExportOptions& options) {
  std::string yaml = fmt::format(
      "# Poses of the robot's base: metres, radians (0 looks east); all are reached from the\n"
      "# entrance by a robot of this radius. Categories name their shelves, the fullest first.\n"
      "frame_id: map\n"
      "robot_radius: {}\n"
      "waypoints:{}\n",
      options.robot_radius_m,
      found.places.empty() ? " []" : "");
  for (const Waypoint& place : found.places)
    yaml += waypoint_line(place);
  yaml += found.by_category.empty() ? "categories: {}\n" : "categories:\n";
  for (const auto& [category, names] : found.by_category)
    yaml += fmt::format("  {}: {}\n", quoted(category), quoted_list(names));
  return yaml + fmt::format("unreachable: {}\n", quoted_list(found.unreachable));
}

// Nodes have the names that nav2_bringup gives them; topics are Nav2's tutorials'.
std::string filter_servers(const std::string& kind,
                           const std::string& mask,
                           int type,
                           const std::string& base,
                           const std::string& multiplier) {
  return fmt::format(
      "{0}_filter_mask_server:\n"
      "  ros__parameters:\n"
      "    yaml_filename: {1}\n"
      "    topic_name: {0}_filter_mask\n"
      "    frame_id: map\n"
      "{0}_costmap_filter_info_server:\n"
      "  ros__parameters:\n"
      "    type: {2}\n"
      "    filter_info_topic: {0}_costmap_filter_info\n"
      "    mask_topic: {0}_filter_mask\n"
      "    base: {3}\n"
      "    multiplier: {4}\n",
      kind,
      quoted(mask),
      type,
      base,
      multiplier);
}

std::string costmap_filters(const std::string& costmap) {
  return fmt::format(
      "{0}:\n"
      "  {0}:\n"
      "    ros__parameters:\n"
      "      filters: [keepout_filter, speed_filter]\n"
      "      keepout_filter:\n"
      "        plugin: nav2_costmap_2d::KeepoutFilter\n"
      "        enabled: true\n"
      "        filter_info_topic: keepout_costmap_filter_info\n"
      "      speed_filter:\n"
      "        plugin: nav2_costmap_2d::SpeedFilter\n"
      "        enabled: true\n"
      "        filter_info_topic: speed_costmap_filter_info\n"
      "        speed_limit_topic: speed_limit\n",
      costmap);
}

std::string filters_yaml(const std::string& folder) {
  return "# Parameters of Nav2's costmap filters: servers of both masks, and the filters that "
         "read\n"
         "# them. Paths are seen from the folder of the map's YAML.\n" +
         filter_servers("keepout", folder + "/keepout_mask.yaml", 0, "0.0", "1.0") +
         "# A mask's value is what is taken off the greatest speed, in percent; 0: no limit.\n" +
         filter_servers("speed", folder + "/speed_mask.yaml", 1, "100.0", "-1.0") +
         "lifecycle_manager_costmap_filters:\n"
         "  ros__parameters:\n"
         "    autostart: true\n"
         "    node_names:\n"
         "      - keepout_filter_mask_server\n"
         "      - keepout_costmap_filter_info_server\n"
         "      - speed_filter_mask_server\n"
         "      - speed_costmap_filter_info_server\n" +
         costmap_filters("global_costmap") + costmap_filters("local_costmap");
}

}  // namespace

Result<ExportFiles> write_nav2(const scene::Scene& scene, const ExportOptions& options) {
  MARKETGEN_CHECK(check_nav2_options(scene, options));
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  MARKETGEN_TRY(const catalog::Catalog catalog, catalog::load_catalog(data));
  const Nav2Map map = make_nav2_map(scene, catalog, options);
  const Waypoints waypoints = find_waypoints(scene, catalog, options);
  const navigation::OccupancyGrid& frame = map.frame;
  ExportFiles files;
  files.main = map_yaml(options.beside + "/" + nav2_map_image, frame, nav2_trinary);
  files.beside = {
      {nav2_map_image, picture_of(frame, map.cells, shade_of_cell)},
      {"keepout_mask.pgm",
       picture_of(
           frame, map.keepout, [](std::uint8_t keepout) { return shade_of_value(keepout * 100); })},
      {"keepout_mask.yaml", map_yaml("keepout_mask.pgm", frame, nav2_scale)},
      {"speed_mask.pgm",
       picture_of(
           frame,
           map.speed_percent,
           [](std::uint8_t percent) { return shade_of_value(percent == 0 ? 0 : 100 - percent); })},
      {"speed_mask.yaml", map_yaml("speed_mask.pgm", frame, nav2_scale)},
      {nav2_filters, filters_yaml(options.beside)},
      {nav2_waypoints, waypoints_yaml(waypoints, options)}};
  return files;
}

}  // namespace marketgen::exporters
