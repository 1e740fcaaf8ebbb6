#include "export/nav2_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/box_extents.h"
#include "layout/route.h"
#include "layout/staff_floor.h"
#include "physics/world/shell_pieces.h"
#include "plan/bsp.h"
#include "plan/shell_measures.h"
#include "scene/floor_obstacles.h"
#include "scene/placements.h"

namespace marketgen::exporters {
namespace {

constexpr double min_resolution_m = 0.01, max_resolution_m = 0.25;
constexpr double min_radius_m = 0.05, max_radius_m = 2;
constexpr double min_height_m = 0.05, max_height_m = 10;
constexpr std::int64_t max_cells = 100'000'000;

// Share of its greatest speed that a robot may drive at. People come round the corner at doors, and
// stand at tills; in a narrow aisle a shopper and the robot cannot pass each other. Our own
// figures.
constexpr std::uint8_t door_percent = 50, checkout_percent = 50, narrow_percent = 70;

int to_mm(double metres) {
  return static_cast<int>(std::lround(metres * 1000));
}

Result<void> check_range(
    double value, double low, double high, const char* flag, const std::string& what) {
  if (value >= low && value <= high) return {};
  return Error{"usage.bad_flag",
               flag,
               fmt::format("{} m is no {}; expected {} to {} m", value, what, low, high)};
}

RectMm at_least_a_cell(RectMm rect, int cell_mm) {
  const int least = cell_mm + 2;  // a centre on the edge lies not inside
  const int x = std::max(0, (least - rect.width() + 1) / 2);
  const int y = std::max(0, (least - rect.depth() + 1) / 2);
  return {rect.x0 - x, rect.y0 - y, rect.x1 + x, rect.y1 + y};
}

// The floor below an item that stands in no block.
RectMm floor_below(const scene::Scene& scene, const scene::SceneProduct& item) {
  const catalog::Product& product = scene.catalog[item.sku];
  const Pose pose = scene::world_from_product(item);
  const Vec3 half{product.width_m() / 2, product.depth_m() / 2, product.height_m() / 2};
  const Vec3 middle = pose * Vec3{0, 0, half.z};
  const Vec3 reach = box_half_extents(pose.rotation, half);
  return {to_mm(middle.x - reach.x),
          to_mm(middle.y - reach.y),
          to_mm(middle.x + reach.x),
          to_mm(middle.y + reach.y)};
}

// The floor under a wall, pane or door, no thinner than a cell: slanted walls are not along x or y.
PolygonMm polygon_of_piece(const physics::ShellPiece& piece, int cell_mm) {
  const double least = (cell_mm / 2 + 1) * 1e-3;
  const double x = std::max(piece.half_size.x, least), y = std::max(piece.half_size.y, least);
  PolygonMm polygon;
  for (const auto& [sx, sy] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    const Vec3 corner = piece.pose * Vec3{sx * x, sy * y, 0};
    polygon.push_back({to_mm(corner.x), to_mm(corner.y)});
  }
  return polygon;
}

std::vector<PolygonMm> walls_below(const plan::Shell& shell, double height_m, int cell_mm) {
  std::vector<PolygonMm> walls;
  for (const physics::ShellPiece& piece : physics::shell_pieces(shell)) {
    const bool lintel = piece.pose.position.z - piece.half_size.z >= height_m;
    if (!lintel && piece.kind != physics::ShellPieceKind::column)
      walls.push_back(polygon_of_piece(piece, cell_mm));
  }
  return walls;
}

// Of the room with its walls all round, in whole cells from the floor's corner.
navigation::OccupancyGrid frame_of(const PolygonMm& floor, int cell_mm) {
  const int walls_mm = to_mm(plan::wall_thickness_m) + cell_mm;
  const int margin_mm = (walls_mm + cell_mm - 1) / cell_mm * cell_mm;
  const RectMm frame = bounds_of(floor).grown(margin_mm);
  return navigation::make_occupancy(polygon_of(frame), {}, 0, cell_mm);
}

struct SlowFloor {
  std::uint8_t percent;
  std::vector<PolygonMm> polygons;
};

// The slowest last, so that it holds where several meet.
std::vector<SlowFloor> slow_floors(const scene::Scene& scene,
                                   const catalog::Catalog& catalog,
                                   const ExportOptions& options) {
  const layout::Layout& layout = scene.layout;
  SlowFloor narrow{narrow_percent, {}}, checkouts{checkout_percent, {}}, doors{door_percent, {}};
  for (const layout::Aisle& aisle : layout.aisles) {
    SlowFloor& floor = aisle.kind == layout::AisleKind::checkout ? checkouts : narrow;
    if (is_slow_aisle(aisle, options)) floor.polygons.push_back(aisle.polygon_mm);
  }
  for (const layout::PayingPlace& paying : layout::paying_places(layout, catalog))
    checkouts.polygons.push_back(polygon_of(paying.floor));
  const layout::Floor floor = layout::make_floor(layout.shell);
  for (const layout::Doorway& door : floor.doorways) {
    const plan::OpeningKind kind = layout.shell.openings[door.opening].kind;
    if (kind == plan::OpeningKind::entrance || kind == plan::OpeningKind::exit)
      doors.polygons.push_back(polygon_of(door.approach));
  }
  return {narrow, checkouts, doors};
}

}  // namespace

bool is_slow_aisle(const layout::Aisle& aisle, const ExportOptions& options) {
  const int passing_mm = layout::person_width_mm + 2 * to_mm(options.robot_radius_m);
  return aisle.kind == layout::AisleKind::checkout || aisle.width_mm < passing_mm;
}

int nav2_cell_mm(const ExportOptions& options) {
  return to_mm(options.resolution_m);
}

Result<void> check_nav2_options(const scene::Scene& scene, const ExportOptions& options) {
  MARKETGEN_CHECK(check_range(
      options.resolution_m, min_resolution_m, max_resolution_m, "--resolution", "side of a cell"));
  MARKETGEN_CHECK(check_range(
      options.robot_radius_m, min_radius_m, max_radius_m, "--robot-radius", "radius of a robot"));
  MARKETGEN_CHECK(check_range(
      options.robot_height_m, min_height_m, max_height_m, "--robot-height", "height of a robot"));
  const RectMm bounds = bounds_of(plan::floor_of(scene.layout.shell)).grown(1000);
  const std::int64_t cell = nav2_cell_mm(options);
  const std::int64_t cells = bounds.area_mm2() / (cell * cell);
  if (cells <= max_cells) return {};
  return Error{"usage.bad_flag",
               "--resolution",
               fmt::format("{} m makes {} million cells of this store; at most {} million",
                           options.resolution_m,
                           cells / 1'000'000,
                           max_cells / 1'000'000)};
}

std::vector<RectMm> nav2_obstacles(const scene::Scene& scene, const ExportOptions& options) {
  std::vector<RectMm> obstacles;
  for (const layout::Fixture& fixture : scene::fixtures_below(scene, options.robot_height_m))
    obstacles.push_back(layout::footprint_of(fixture));
  for (const plan::Column& column : scene.layout.shell.columns)
    obstacles.push_back(plan::footprint_of(column));
  for (const scene::SceneProduct& item : scene.products) {
    if (item.facing == scene::no_facing && item.position_m[2] < options.robot_height_m)
      obstacles.push_back(floor_below(scene, item));
  }
  for (RectMm& rect : obstacles)
    rect = at_least_a_cell(rect, nav2_cell_mm(options));
  return obstacles;
}

Nav2Map make_nav2_map(const scene::Scene& scene,
                      const catalog::Catalog& catalog,
                      const ExportOptions& options) {
  const int cell_mm = nav2_cell_mm(options);
  const PolygonMm floor = plan::floor_of(scene.layout.shell);
  Nav2Map map;
  map.frame = frame_of(floor, cell_mm);
  const navigation::OccupancyGrid on_floor = with_blocked(map.frame, {floor});
  const navigation::OccupancyGrid solid =
      with_blocked(navigation::make_occupancy(
                       polygon_of(map.frame.bounds), nav2_obstacles(scene, options), 0, cell_mm),
                   walls_below(scene.layout.shell, options.robot_height_m, cell_mm));
  std::vector<PolygonMm> staff;
  for (const layout::StaffFloor& behind : layout::staff_floor(scene.layout, catalog))
    staff.push_back(behind.polygon_mm);
  const navigation::OccupancyGrid staff_floor = with_blocked(map.frame, staff);
  const std::size_t cells = map.frame.blocked.size();
  map.cells.resize(cells);
  map.keepout.resize(cells);
  map.speed_percent.assign(cells, 0);
  for (std::size_t i = 0; i < cells; ++i) {
    const bool inside = on_floor.blocked[i] != 0;
    map.cells[i] = solid.blocked[i] != 0 ? Nav2Cell::occupied
                   : inside              ? Nav2Cell::free
                                         : Nav2Cell::unknown;
    map.keepout[i] = !inside || staff_floor.blocked[i] != 0 ? 1 : 0;
  }
  for (const SlowFloor& slow : slow_floors(scene, catalog, options)) {
    const navigation::OccupancyGrid there = with_blocked(map.frame, slow.polygons);
    for (std::size_t i = 0; i < cells; ++i) {
      if (there.blocked[i] != 0 && on_floor.blocked[i] != 0) map.speed_percent[i] = slow.percent;
    }
  }
  return map;
}

}  // namespace marketgen::exporters
