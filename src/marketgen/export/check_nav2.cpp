// Reads the maps back as Nav2 does and holds them against the layout: what is solid, what is free,
// what is outside.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "export/check_nav2.h"
#include "export/exporter.h"
#include "export/nav2_files.h"
#include "export/nav2_map.h"
#include "export/nav2_read.h"
#include "io/file.h"
#include "plan/bsp.h"
#include "scene/floor_obstacles.h"

namespace marketgen::exporters {
namespace {

// Cells whose centres lie in the rectangle.
struct CellRect {
  int c0, r0, c1, r1;  // inclusive
};
CellRect cells_in(const ReadMap& map, const RectMm& rect) {
  const auto first = [&](int mm, double origin) {
    return static_cast<int>(std::ceil((mm * 1e-3 - origin) / map.resolution_m - 0.5 - 1e-9));
  };
  const auto last = [&](int mm, double origin) {
    return static_cast<int>(std::floor((mm * 1e-3 - origin) / map.resolution_m - 0.5 + 1e-9));
  };
  return {std::max(0, first(rect.x0, map.origin[0])),
          std::max(0, first(rect.y0, map.origin[1])),
          std::min(map.columns - 1, last(rect.x1, map.origin[0])),
          std::min(map.rows - 1, last(rect.y1, map.origin[1]))};
}

Result<void> compare_frames(const ReadMap& map,
                            const RectMm& room,
                            const ExportOptions& options,
                            const std::string& where) {
  if (std::abs(map.resolution_m - options.resolution_m) > 5e-4 || map.origin[2] != 0)
    return mismatch(where, "it has other cells than were asked for");
  const double east = map.origin[0] + map.columns * map.resolution_m;
  const double north = map.origin[1] + map.rows * map.resolution_m;
  if (map.origin[0] > room.x0 * 1e-3 || map.origin[1] > room.y0 * 1e-3 || east < room.x1 * 1e-3 ||
      north < room.y1 * 1e-3)
    return mismatch(where, "it does not cover the room");
  return {};
}

// Whether all cells with centres in the rectangle are occupied; of none, yes.
bool is_solid(const ReadMap& map, const RectMm& rect) {
  const CellRect cells = cells_in(map, rect);
  for (int row = cells.r0; row <= cells.r1; ++row) {
    for (int column = cells.c0; column <= cells.c1; ++column) {
      if (map.values[map.index(column, row)] != nav2_occupied) return false;
    }
  }
  return true;
}

// Every fixture stands where it does in the layout: all cells well inside it and the one at its
// middle; of one thinner than two cells that one or the next.
Result<void> compare_fixtures(const ReadMap& map,
                              const std::vector<layout::Fixture>& standing,
                              const std::string& where) {
  const auto cell_mm = static_cast<int>(std::lround(map.resolution_m * 1000));
  for (const layout::Fixture& fixture : standing) {
    const RectMm rect = layout::footprint_of(fixture);
    const bool thin = std::min(rect.width(), rect.depth()) <= 2 * cell_mm;
    const auto solid_at = [&](int dx, int dy) {
      const std::size_t cell = map.cell_at((fixture.x_mm + dx) * 1e-3, (fixture.y_mm + dy) * 1e-3);
      return cell < map.values.size() && map.values[cell] == nav2_occupied;
    };
    const bool beside = thin && (solid_at(cell_mm, 0) || solid_at(-cell_mm, 0) ||
                                 solid_at(0, cell_mm) || solid_at(0, -cell_mm));
    if ((!solid_at(0, 0) && !beside) || (!thin && !is_solid(map, rect.grown(-cell_mm))))
      return mismatch(where, "fixture \"" + fixture.id + "\" does not stand on it as in the store");
  }
  return {};
}

// The same for all that stands, and the other way round: what is occupied in the room has something
// standing there, and nothing outside is free. A cell's width beside walls is not looked at.
Result<void> compare_floor(const ReadMap& map,
                           const PolygonMm& room,
                           const std::vector<RectMm>& obstacles,
                           const std::string& where) {
  const auto cell_mm = static_cast<int>(std::lround(map.resolution_m * 1000));
  std::vector<PolygonMm> below;
  for (const RectMm& rect : obstacles)
    below.push_back(polygon_of(rect));
  const std::vector<Covered> standing = covered_by(map, below);
  const navigation::OccupancyGrid away_from_walls =
      navigation::make_occupancy(room, {}, cell_mm, cell_mm);
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      const std::int8_t value = map.values[map.index(column, row)];
      const PointMm at = map.center(column, row);
      const RectMm bounds = away_from_walls.bounds;
      const bool well_inside =
          away_from_walls.free((at[0] - bounds.x0) / cell_mm, (at[1] - bounds.y0) / cell_mm) &&
          bounds.contains(at);
      const Covered there = standing[map.index(column, row)];
      if (well_inside &&
          (value == nav2_unknown || (value == nav2_occupied && there == Covered::none)))
        return mismatch(where, map.in_words(column, row) + " is floor, but not on it");
      if (there == Covered::wholly && value != nav2_occupied)
        return mismatch(where, map.in_words(column, row) + " is taken, but free on it");
      if (value == nav2_free && !well_inside && !contains(room, at))
        return mismatch(where, map.in_words(column, row) + " is free, but outside the room");
    }
  }
  return {};
}

Result<ReadMap> read_mask(const std::filesystem::path& file, const ReadMap& map) {
  MARKETGEN_TRY(ReadMap mask, read_nav2_map(file));
  if (mask.columns != map.columns || mask.rows != map.rows || mask.origin != map.origin ||
      mask.resolution_m != map.resolution_m)
    return mismatch(file.string(), "its cells are not those of the map");
  return mask;
}

}  // namespace

Result<ExportSummary> check_nav2(const scene::Scene& scene,
                                 const std::filesystem::path& file,
                                 const ExportOptions& options) {
  MARKETGEN_TRY(const std::filesystem::path image, image_named_in(file));
  const std::filesystem::path folder = image.parent_path();
  MARKETGEN_TRY(const ReadMap map, read_nav2_map(file));
  MARKETGEN_TRY(const ReadMap keepout, read_mask(folder / "keepout_mask.yaml", map));
  MARKETGEN_TRY(const ReadMap speed, read_mask(folder / "speed_mask.yaml", map));
  MARKETGEN_CHECK(check_filters(file, folder / nav2_filters));
  const std::filesystem::path ways = folder / nav2_waypoints;
  MARKETGEN_TRY(const ReadWaypoints waypoints, read_nav2_waypoints(ways));
  const PolygonMm room = plan::floor_of(scene.layout.shell);
  const std::vector<layout::Fixture> standing =
      scene::fixtures_below(scene, options.robot_height_m);
  MARKETGEN_CHECK(compare_frames(map, bounds_of(room), options, file.string()));
  MARKETGEN_CHECK(compare_fixtures(map, standing, image.string()));
  MARKETGEN_CHECK(compare_floor(map, room, nav2_obstacles(scene, options), image.string()));
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  MARKETGEN_TRY(const catalog::Catalog catalog, catalog::load_catalog(data));
  MARKETGEN_CHECK(
      compare_keepout(scene, catalog, keepout, (folder / "keepout_mask.yaml").string()));
  MARKETGEN_CHECK(
      compare_speed(scene, catalog, options, speed, (folder / "speed_mask.yaml").string()));
  if (std::abs(waypoints.robot_radius - options.robot_radius_m) > 1e-9)
    return mismatch(ways.string(), "it is for a robot of another radius");
  MARKETGEN_CHECK(check_ways(waypoints, map, keepout, ways.string()));
  MARKETGEN_CHECK(compare_places(scene, catalog, map, waypoints, ways.string()));

  ExportSummary summary;
  std::size_t open = 0, kept_out = 0;  // cells
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    if (map.values[i] != nav2_free) continue;
    ++open;
    kept_out += keepout.values[i] != 0 ? 1 : 0;
  }
  const double cell_m2 = map.resolution_m * map.resolution_m;
  summary.free_m2 = static_cast<double>(open) * cell_m2;
  summary.keepout_m2 = static_cast<double>(kept_out) * cell_m2;
  summary.fixtures = standing.size();
  summary.waypoints = waypoints.places.size();
  summary.in_words = fmt::format(
      "{} x {} cells, {:.1f} m2 free, {:.1f} m2 of them kept out of; {} fixtures, {} "
      "waypoints for {} categories, {} out of reach",
      map.columns,
      map.rows,
      summary.free_m2,
      summary.keepout_m2,
      summary.fixtures,
      summary.waypoints,
      waypoints.by_category.size(),
      waypoints.unreachable.size());
  return summary;
}

}  // namespace marketgen::exporters
