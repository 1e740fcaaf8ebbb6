#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <set>

#include "export/check_nav2.h"
#include "export/exporter.h"
#include "layout/route.h"
#include "navigation/occupancy.h"
#include "scene/bays.h"
#include "scene/placements.h"
#include "scene/standing_place.h"

namespace marketgen::exporters {
namespace {

constexpr double min_facing = 0.7;  // cosine: a place may be a little to one side of a narrow shelf

// Cells whose middle the robot's may be at: nothing occupied nearer than its radius, and no
// keepout.
std::vector<std::uint8_t> room_for_robot(const ReadMap& map,
                                         const ReadMap& keepout,
                                         double radius_m) {
  navigation::OccupancyGrid solid;
  solid.columns = map.columns, solid.rows = map.rows;
  for (const std::int8_t value : map.values)
    solid.blocked.push_back(value == nav2_occupied ? 1 : 0);
  solid.cell_mm = static_cast<int>(std::lround(map.resolution_m * 1000));
  const std::vector<float> clearance = navigation::clearance_field(solid);
  std::vector<std::uint8_t> room(map.values.size(), 0);
  for (std::size_t i = 0; i < room.size(); ++i)
    room[i] =
        map.values[i] == nav2_free && keepout.values[i] == 0 && clearance[i] >= radius_m * 1000 - 1
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

using Places = std::map<std::string, const ReadWaypoint*>;

// Places by their names, each of which occurs once.
Result<Places> places_by_name(const ReadWaypoints& waypoints, const std::string& where) {
  std::set<std::string> named(waypoints.unreachable.begin(), waypoints.unreachable.end());
  Places places;
  for (const ReadWaypoint& place : waypoints.places) {
    if (!named.insert(place.name).second)
      return mismatch(where, "\"" + place.name + "\" occurs twice");
    places.emplace(place.name, &place);
  }
  return places;
}

std::string name_of_bay(const scene::Scene& scene, std::uint32_t fixture, int side) {
  return fmt::format("{}/side-{}", scene.layout.fixtures[fixture].id, side);
}

// What each place should be, by its name.
std::map<std::string, std::string> wanted_places(const scene::Scene& scene,
                                                 const catalog::Catalog& catalog) {
  std::map<std::string, std::string> kinds;
  for (const plan::Opening& opening : scene.layout.shell.openings) {
    if (opening.kind == plan::OpeningKind::entrance || opening.kind == plan::OpeningKind::exit)
      kinds[opening.id] = name_of(opening.kind);
  }
  for (const layout::PayingPlace& paying : layout::paying_places(scene.layout, catalog))
    kinds[paying.fixture + "/till"] = "checkout";
  for (const scene::BayRef& bay : scene::bays_of(scene))
    kinds[name_of_bay(scene, bay.fixture, bay.side)] = "shelf";
  return kinds;
}

// Near enough to the fixture for an arm, and turned to it.
bool looks_at(const ReadWaypoint& place, const RectMm& rect, double resolution_m) {
  const double dx = std::clamp(place.x, rect.x0 * 1e-3, rect.x1 * 1e-3) - place.x;
  const double dy = std::clamp(place.y, rect.y0 * 1e-3, rect.y1 * 1e-3) - place.y;
  const double distance = std::hypot(dx, dy);
  const double reach = (scene::standing_mm + scene::standing_reach_mm) * 1e-3 + resolution_m;
  const double ahead = dx * std::cos(place.yaw) + dy * std::sin(place.yaw);
  return distance > 0 && distance <= reach && ahead >= min_facing * distance;
}

// Categories of what stands in the blocks of each bay, by the bay's name.
std::map<std::string, std::set<std::string>> goods_by_bay(const scene::Scene& scene) {
  std::map<std::string, std::set<std::string>> goods;
  for (const scene::SceneProduct& item : scene.products) {
    if (item.facing == scene::no_facing) continue;
    const scene::Facing& facing = scene.facings[item.facing];
    const scene::SceneShelf& shelf = scene.shelves[facing.shelf];
    goods[name_of_bay(scene, shelf.fixture, shelf.side)].insert(scene.catalog[facing.sku].category);
  }
  return goods;
}

Result<void> compare_categories(const scene::Scene& scene,
                                const Places& places,
                                const ReadWaypoints& waypoints,
                                const std::string& where) {
  auto goods = goods_by_bay(scene);
  std::map<std::string, std::set<std::string>> wanted;  // places by category
  for (const auto& [name, place] : places) {
    if (place->kind != "shelf") continue;
    const std::set<std::string> sold(place->categories.begin(), place->categories.end());
    if (sold != goods[name])
      return mismatch(where, "\"" + name + "\" sells other categories than stand there");
    for (const std::string& category : sold)
      wanted[category].insert(name);
  }
  std::map<std::string, std::set<std::string>> named;
  for (const auto& [category, names] : waypoints.by_category) {
    named[category] = {names.begin(), names.end()};
    if (named[category] != wanted[category] || names.size() != named[category].size())
      return mismatch(where, "category \"" + category + "\" names other places than sell it");
  }
  for (const auto& [category, names] : wanted) {
    if (!named.contains(category))
      return mismatch(where, "category \"" + category + "\" is missing");
  }
  return {};
}

}  // namespace

Result<void> check_ways(const ReadWaypoints& waypoints,
                        const ReadMap& map,
                        const ReadMap& keepout,
                        const std::string& where) {
  const std::vector<std::uint8_t> room = room_for_robot(map, keepout, waypoints.robot_radius);
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

Result<void> compare_places(const scene::Scene& scene,
                            const catalog::Catalog& catalog,
                            const ReadMap& map,
                            const ReadWaypoints& waypoints,
                            const std::string& where) {
  MARKETGEN_TRY(const Places places, places_by_name(waypoints, where));
  for (const auto& [name, kind] : wanted_places(scene, catalog)) {
    const auto found = places.find(name);
    if (found == places.end()) {
      if (std::ranges::count(waypoints.unreachable, name) == 0)
        return mismatch(where, "\"" + name + "\" is missing");
      continue;
    }
    if (found->second->kind != kind)
      return mismatch(where, "\"" + name + "\" is no \"" + found->second->kind + "\"");
  }
  for (const auto& [name, place] : places) {
    if (place->kind != "shelf") continue;
    const layout::Fixture* fixture = layout::find_fixture(scene.layout, place->fixture);
    if (fixture == nullptr || !name.starts_with(fixture->id + "/side-"))
      return mismatch(where, "\"" + name + "\" belongs to no fixture of the store");
    if (!looks_at(*place, layout::footprint_of(*fixture), map.resolution_m))
      return mismatch(where, "at \"" + name + "\" the robot does not look at its shelf");
  }
  return compare_categories(scene, places, waypoints, where);
}

}  // namespace marketgen::exporters
