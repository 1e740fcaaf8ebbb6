// Reads the maps back as Nav2 does and holds them against the layout: what is solid, what is free,
// what is outside, and whether a robot gets from the entrance to every waypoint.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <set>

#include "export/exporter.h"
#include "export/nav2_files.h"
#include "export/nav2_map.h"
#include "export/nav2_read.h"
#include "io/file.h"
#include "plan/bsp.h"
#include "scene/bays.h"
#include "scene/floor_obstacles.h"

namespace marketgen::exporters {
namespace {

constexpr std::int8_t unknown = -1, free_cell = 0, occupied = 100;

PointMm point_of(const ReadMap& map, int column, int row) {
  return {static_cast<int>(std::lround(map.x_of(column) * 1000)),
          static_cast<int>(std::lround(map.y_of(row) * 1000))};
}

std::size_t index(const ReadMap& map, int column, int row) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(map.columns) +
         static_cast<std::size_t>(column);
}

std::string place_of(const ReadMap& map, int column, int row) {
  return fmt::format("the cell at {:.3f}, {:.3f} m", map.x_of(column), map.y_of(row));
}

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
      if (map.values[index(map, column, row)] != occupied) return false;
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
      return cell < map.values.size() && map.values[cell] == occupied;
    };
    const bool beside = thin && (solid_at(cell_mm, 0) || solid_at(-cell_mm, 0) ||
                                 solid_at(0, cell_mm) || solid_at(0, -cell_mm));
    if ((!solid_at(0, 0) && !beside) || (!thin && !is_solid(map, rect.grown(-cell_mm))))
      return mismatch(where, "fixture \"" + fixture.id + "\" does not stand on it as in the store");
  }
  return {};
}

// The other way round: what is occupied in the room has something standing there, what is free has
// not, and nothing outside is free. A cell's width beside edges is not looked at.
Result<void> compare_floor(const ReadMap& map,
                           const PolygonMm& room,
                           const std::vector<RectMm>& obstacles,
                           const std::string& where) {
  const auto cell_mm = static_cast<int>(std::lround(map.resolution_m * 1000));
  std::vector<std::uint8_t> may_be_solid(map.values.size(), 0);
  for (const RectMm& rect : obstacles) {
    const CellRect cells = cells_in(map, rect.grown(cell_mm));
    for (int row = cells.r0; row <= cells.r1; ++row) {
      for (int column = cells.c0; column <= cells.c1; ++column)
        may_be_solid[index(map, column, row)] = 1;
    }
  }
  navigation::OccupancyGrid away_from_walls =
      navigation::make_occupancy(room, {}, cell_mm, cell_mm);
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      const std::int8_t value = map.values[index(map, column, row)];
      const PointMm at = point_of(map, column, row);
      const RectMm bounds = away_from_walls.bounds;
      const bool well_inside =
          away_from_walls.free((at[0] - bounds.x0) / cell_mm, (at[1] - bounds.y0) / cell_mm) &&
          bounds.contains(at);
      const bool nothing_there = may_be_solid[index(map, column, row)] == 0;
      if (well_inside && (value == unknown || (value == occupied && nothing_there)))
        return mismatch(where, place_of(map, column, row) + " is floor, but not on it");
      if (value == free_cell && !well_inside && !contains(room, at))
        return mismatch(where, place_of(map, column, row) + " is free, but outside the room");
    }
  }
  return {};
}

// Cells whose middle the robot's may be at: nothing occupied or unknown nearer than its radius, and
// no keepout.
std::vector<std::uint8_t> room_for_robot(const ReadMap& map,
                                         const ReadMap& keepout,
                                         double radius_m) {
  navigation::OccupancyGrid solid;
  solid.columns = map.columns, solid.rows = map.rows;
  for (const std::int8_t value : map.values)
    solid.blocked.push_back(value == occupied ? 1 : 0);
  solid.cell_mm = static_cast<int>(std::lround(map.resolution_m * 1000));
  const std::vector<float> clearance = navigation::clearance_field(solid);
  std::vector<std::uint8_t> room(map.values.size(), 0);
  for (std::size_t i = 0; i < room.size(); ++i)
    room[i] =
        map.values[i] == free_cell && keepout.values[i] == 0 && clearance[i] >= radius_m * 1000 - 1
            ? 1
            : 0;
  return room;
}

// What hangs together with the cell by steps over cells' sides.
std::vector<std::uint8_t> reached_from(const ReadMap& map,
                                       const std::vector<std::uint8_t>& room,
                                       std::size_t start) {
  std::vector<std::uint8_t> reached(room.size(), 0);
  std::deque<std::size_t> open{start};
  reached[start] = 1;
  const auto columns = static_cast<std::size_t>(map.columns);
  const auto visit = [&](std::size_t cell) {
    if (room[cell] == 0 || reached[cell] != 0) return;
    reached[cell] = 1;
    open.push_back(cell);
  };
  while (!open.empty()) {
    const std::size_t cell = open.front();
    open.pop_front();
    if (cell % columns > 0) visit(cell - 1);
    if (cell % columns + 1 < columns) visit(cell + 1);
    if (cell >= columns) visit(cell - columns);
    if (cell + columns < room.size()) visit(cell + columns);
  }
  return reached;
}

Result<void> check_ways(const ReadWaypoints& waypoints,
                        const ReadMap& map,
                        const std::vector<std::uint8_t>& room,
                        const std::string& where) {
  std::vector<std::uint8_t> reached;
  for (const ReadWaypoint& place : waypoints.places) {
    const std::size_t cell = map.cell_at(place.x, place.y);
    if (cell >= room.size() || room[cell] == 0)
      return mismatch(where, "the robot has no room at \"" + place.name + "\"");
    if (reached.empty()) reached = reached_from(map, room, cell);  // doors come first
    if (reached[cell] == 0)
      return mismatch(
          where,
          "no way leads from \"" + waypoints.places.front().name + "\" to \"" + place.name + "\"");
  }
  return {};
}

// Each bay has a place or is named as one without; categories name places that sell them.
Result<void> compare_bays(const scene::Scene& scene,
                          const ReadWaypoints& waypoints,
                          const std::string& where) {
  std::set<std::string> named(waypoints.unreachable.begin(), waypoints.unreachable.end());
  std::map<std::string, const ReadWaypoint*> places;
  for (const ReadWaypoint& place : waypoints.places) {
    if (!places.emplace(place.name, &place).second || !named.insert(place.name).second)
      return mismatch(where, "\"" + place.name + "\" occurs twice");
  }
  for (const scene::BayRef& bay : scene::bays_of(scene)) {
    const std::string name =
        fmt::format("{}/side-{}", scene.layout.fixtures[bay.fixture].id, bay.side);
    if (!named.contains(name)) return mismatch(where, "\"" + name + "\" is missing");
  }
  for (const auto& [category, names] : waypoints.by_category) {
    for (const std::string& name : names) {
      const auto place = places.find(name);
      if (place == places.end() || std::ranges::count(place->second->categories, category) != 1)
        return mismatch(where, "\"" + name + "\" has nothing of category \"" + category + "\"");
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
  MARKETGEN_CHECK(io::read_file(folder / nav2_filters));
  const std::filesystem::path ways = folder / nav2_waypoints;
  MARKETGEN_TRY(const ReadWaypoints waypoints, read_nav2_waypoints(ways));
  const PolygonMm room = plan::floor_of(scene.layout.shell);
  const std::vector<layout::Fixture> standing =
      scene::fixtures_below(scene, options.robot_height_m);
  MARKETGEN_CHECK(compare_frames(map, bounds_of(room), options, file.string()));
  MARKETGEN_CHECK(compare_fixtures(map, standing, image.string()));
  MARKETGEN_CHECK(compare_floor(map, room, nav2_obstacles(scene, options), image.string()));
  if (std::abs(waypoints.robot_radius - options.robot_radius_m) > 1e-9)
    return mismatch(ways.string(), "it is for a robot of another radius");
  MARKETGEN_CHECK(compare_bays(scene, waypoints, ways.string()));
  const std::vector<std::uint8_t> space = room_for_robot(map, keepout, options.robot_radius_m);
  MARKETGEN_CHECK(check_ways(waypoints, map, space, ways.string()));

  ExportSummary summary;
  const double cell_m2 = map.resolution_m * map.resolution_m;
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    if (map.values[i] != free_cell) continue;
    summary.free_m2 += cell_m2;
    summary.keepout_m2 += keepout.values[i] != 0 ? cell_m2 : 0;
  }
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
