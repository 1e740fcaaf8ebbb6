#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "export/check_nav2.h"
#include "export/exporter.h"
#include "export/nav2_map.h"
#include "layout/floor.h"
#include "layout/route.h"
#include "layout/staff_floor.h"
#include "plan/bsp.h"

namespace marketgen::exporters {
namespace {

// Of the cell's four corners and its middle, how many lie in the polygon.
Covered cover_of_cell(const ReadMap& map, int column, int row, const PolygonMm& polygon) {
  const PointMm at = map.center(column, row);
  const auto half = static_cast<int>(std::lround(map.resolution_m * 500));
  int inside = 0;
  for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, 0}})
    inside += contains(polygon, {at[0] + x * half, at[1] + y * half}) ? 1 : 0;
  return inside == 5 ? Covered::wholly : inside > 0 ? Covered::partly : Covered::none;
}

// The first cell in which `fault` sees one; null is none.
template <class Fault>
Result<void> every_cell(const ReadMap& map, const std::string& where, Fault fault) {
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      const char* seen = fault(map.index(column, row));
      if (seen != nullptr) return mismatch(where, map.in_words(column, row) + seen);
    }
  }
  return {};
}

}  // namespace

std::vector<Covered> covered_by(const ReadMap& map, const std::vector<PolygonMm>& polygons) {
  std::vector<Covered> covered(map.values.size(), Covered::none);
  const auto place = [&](int mm, double origin) {
    return static_cast<int>(std::floor((mm * 1e-3 - origin) / map.resolution_m));
  };
  for (const PolygonMm& polygon : polygons) {
    const RectMm bounds = bounds_of(polygon);
    const int east = std::min(map.columns - 1, place(bounds.x1, map.origin[0]) + 1);
    const int north = std::min(map.rows - 1, place(bounds.y1, map.origin[1]) + 1);
    for (int row = std::max(0, place(bounds.y0, map.origin[1]) - 1); row <= north; ++row) {
      for (int column = std::max(0, place(bounds.x0, map.origin[0]) - 1); column <= east;
           ++column) {
        Covered& cell = covered[map.index(column, row)];
        cell = std::max(cell, cover_of_cell(map, column, row, polygon));
      }
    }
  }
  return covered;
}

Result<void> compare_keepout(const scene::Scene& scene,
                             const catalog::Catalog& catalog,
                             const ReadMap& keepout,
                             const std::string& where) {
  std::vector<PolygonMm> staff;
  for (const layout::StaffFloor& floor : layout::staff_floor(scene.layout, catalog))
    staff.push_back(floor.polygon_mm);
  const std::vector<Covered> room = covered_by(keepout, {plan::floor_of(scene.layout.shell)});
  const std::vector<Covered> behind = covered_by(keepout, staff);
  return every_cell(keepout, where, [&](std::size_t cell) -> const char* {
    const bool out = room[cell] == Covered::none || behind[cell] == Covered::wholly;
    const bool in = room[cell] == Covered::wholly && behind[cell] == Covered::none;
    if (out && keepout.values[cell] != 100) return " is not for robots, but open to them";
    if (in && keepout.values[cell] != 0) return " is shoppers' floor, but kept out of";
    return nullptr;
  });
}

Result<void> compare_speed(const scene::Scene& scene,
                           const catalog::Catalog& catalog,
                           const ExportOptions& options,
                           const ReadMap& speed,
                           const std::string& where) {
  const layout::Floor floor = layout::make_floor(scene.layout.shell);
  std::vector<PolygonMm> busy, aisles;
  for (const layout::Doorway& door : floor.doorways) {
    const plan::OpeningKind kind = scene.layout.shell.openings[door.opening].kind;
    if (kind == plan::OpeningKind::entrance || kind == plan::OpeningKind::exit)
      busy.push_back(polygon_of(door.approach));
  }
  for (const layout::PayingPlace& paying : layout::paying_places(scene.layout, catalog))
    busy.push_back(polygon_of(paying.floor));
  for (const layout::Aisle& aisle : scene.layout.aisles) {
    if (is_slow_aisle(aisle, options)) aisles.push_back(aisle.polygon_mm);
  }
  const std::vector<Covered> room = covered_by(speed, {floor.outline});
  const std::vector<Covered> slow = covered_by(speed, busy), narrow = covered_by(speed, aisles);
  return every_cell(speed, where, [&](std::size_t cell) -> const char* {
    const std::int8_t limit = speed.values[cell];
    const bool must = room[cell] == Covered::wholly && slow[cell] == Covered::wholly;
    const bool may = slow[cell] != Covered::none || narrow[cell] != Covered::none;
    if (limit < 0 || limit >= 100 || (limit > 0 && room[cell] == Covered::none))
      return " has no speed that a robot can drive at";
    if (must && limit == 0) return " is where people pass, but has no limit";
    if (!may && limit > 0) return " is open floor, but has a limit";
    return nullptr;
  });
}

Result<void> check_filters(const std::filesystem::path& map, const std::filesystem::path& filters) {
  MARKETGEN_TRY(const std::vector<std::string> masks, masks_named_in(filters));
  const std::filesystem::path folder = filters.parent_path();
  for (const char* name : {"keepout_mask.yaml", "speed_mask.yaml"}) {
    const bool named = std::ranges::any_of(masks, [&](const std::string& mask) {
      return (map.parent_path() / mask).lexically_normal() == (folder / name).lexically_normal();
    });
    if (!named) return mismatch(filters.string(), std::string("no server loads ") + name);
  }
  return {};
}

}  // namespace marketgen::exporters
