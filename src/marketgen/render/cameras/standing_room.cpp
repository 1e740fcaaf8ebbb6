#include "render/cameras/standing_room.h"

#include "render/stage/room.h"

#include <cmath>

namespace marketgen::render::raytrace {
namespace {

constexpr int cell_mm = 100;
constexpr int clearance_mm = 300;    // half a person with a camera
constexpr int eye_height_mm = 1500;  // lower fixtures do not block the view
constexpr double step_m = 0.05;

navigation::OccupancyGrid occupancy(const scene::Scene& scene, int clearance, int higher_than_mm) {
  const plan::Shell& shell = scene.layout.shell;
  std::vector<RectMm> obstacles;
  for (const layout::Fixture& fixture : scene.layout.fixtures) {
    if (fixture.height_mm > higher_than_mm) obstacles.push_back(layout::footprint_of(fixture));
  }
  for (const plan::Column& column : shell.columns)
    obstacles.push_back(plan::footprint_of(column));
  return navigation::make_occupancy(plan::floor_of(shell), obstacles, clearance, cell_mm);
}

bool free_at(const navigation::OccupancyGrid& grid, Vec3 point) {
  const PointMm p = floor_mm(point);
  const auto index = [&](int mm, int start) {
    return static_cast<int>(std::floor(static_cast<double>(mm - start) / grid.cell_mm));
  };
  return grid.free(index(p[0], grid.bounds.x0), index(p[1], grid.bounds.y0));
}

double way(const navigation::OccupancyGrid& grid, Vec3 from, Vec3 direction, double limit) {
  double reached = 0;
  while (reached + step_m <= limit && free_at(grid, from + direction * (reached + step_m)))
    reached += step_m;
  return reached;
}

}  // namespace

StandingRoom::StandingRoom(const scene::Scene& scene)
    : floor_(occupancy(scene, clearance_mm, 0)), tall_(occupancy(scene, 0, eye_height_mm)) {
  const navigation::Components components = navigation::find_components(floor_);
  label_ = components.label;
  main_ = components.largest();
}

bool StandingRoom::is_main(std::size_t cell) const {
  return main_ != 0 && label_[cell] == main_;
}

Vec3 StandingRoom::nearest(Vec3 point) const {
  const PointMm wanted = floor_mm(point);
  double least = 1e18;
  Vec3 best = point;
  for (int row = 0; row < floor_.rows; ++row) {
    for (int column = 0; column < floor_.columns; ++column) {
      if (!is_main(floor_.index(column, row))) continue;
      const PointMm p = floor_.center(column, row);
      const double dx = p[0] - wanted[0], dy = p[1] - wanted[1];
      const double distance2 = dx * dx + dy * dy;
      if (distance2 < least) {
        least = distance2;
        best = {p[0] * 1e-3, p[1] * 1e-3, point.z};
      }
    }
  }
  return best;
}

bool StandingRoom::is_free(Vec3 point) const {
  return free_at(floor_, point);
}

double StandingRoom::free_way(Vec3 from, Vec3 direction, double limit) const {
  return way(floor_, from, direction, limit);
}

double StandingRoom::sight(Vec3 from, Vec3 direction, double limit) const {
  return way(tall_, from, direction, limit);
}

}  // namespace marketgen::render::raytrace
