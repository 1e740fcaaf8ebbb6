#include "export/coco_cameras.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "export/robot_floor.h"
#include "navigation/occupancy.h"
#include "scene/bays.h"

namespace marketgen::exporters {
namespace {

constexpr double shelf_view_deg = 60;  // vertical; 1.15 m of shelf from 1 m away
constexpr double min_distance_m = 0.5, farther_m = 0.5;
constexpr double same_direction = 0.99;  // cosine

// One side of one module as the robot passes it: its front edge between two places along `right`.
struct BayFace {
  std::string zone, run;
  int side = 0;
  Vec3 right, ahead;                    // of who looks at it; level unit vectors
  double left_m = 0, right_m = 0;       // along `right`
  double front_m = 0, footprint_m = 0;  // along `ahead`: foremost edge of shelves, of the module
};

BayFace face_of(const scene::Scene& scene, const scene::BayRef& bay) {
  const layout::Fixture& fixture = scene.layout.fixtures[bay.fixture];
  BayFace face;
  face.zone = bay.zone, face.run = bay.run.empty() ? fixture.id : bay.run, face.side = bay.side;
  face.left_m = face.front_m = face.footprint_m = std::numeric_limits<double>::infinity();
  face.right_m = -face.left_m;
  const Quaternion turned = scene::world_from_shelf(scene, bay.shelves.front()).rotation;
  face.right = normalized(rotate(turned, {1, 0, 0}));
  face.ahead = {-face.right.y, face.right.x, 0};
  for (const std::uint32_t row : bay.shelves) {
    const Vec3 middle = scene::world_from_shelf(scene, row).position;
    const double at = dot(middle, face.right), half = scene.shelves[row].width_m / 2.0;
    face.left_m = std::min(face.left_m, at - half);
    face.right_m = std::max(face.right_m, at + half);
    face.front_m = std::min(face.front_m, dot(middle, face.ahead));
  }
  const RectMm rect = layout::footprint_of(fixture);
  for (const int x : {rect.x0, rect.x1}) {
    for (const int y : {rect.y0, rect.y1})
      face.footprint_m = std::min(face.footprint_m, dot({x * 1e-3, y * 1e-3, 0}, face.ahead));
  }
  return face;
}

bool goes_on(const BayFace& a, const BayFace& b) {
  return a.zone == b.zone && a.run == b.run && a.side == b.side &&
         dot(a.ahead, b.ahead) > same_direction;
}

// Sides of runs, each with its modules from the left.
std::vector<std::vector<BayFace>> run_faces(const scene::Scene& scene) {
  std::vector<std::vector<BayFace>> runs;
  for (const scene::BayRef& bay : scene::bays_of(scene)) {
    BayFace face = face_of(scene, bay);
    const auto own =
        std::ranges::find_if(runs, [&](const auto& run) { return goes_on(run.front(), face); });
    if (own == runs.end())
      runs.push_back({std::move(face)});
    else
      own->push_back(std::move(face));
  }
  for (auto& run : runs)
    std::ranges::stable_sort(run, {}, &BayFace::left_m);
  return runs;
}

// The module that lies before a place along the run, or is nearest to it.
const BayFace& face_at(const std::vector<BayFace>& run, double along_m) {
  return *std::ranges::min_element(run, {}, [&](const BayFace& face) {
    return std::max({face.left_m - along_m, along_m - face.right_m, 0.0});
  });
}

bool is_free(const navigation::OccupancyGrid& floor, Vec3 at) {
  const auto cell = [&](double metres, int from_mm) {
    return static_cast<int>(std::floor((metres * 1000 - from_mm) / floor.cell_mm));
  };
  return floor.free(cell(at.x, floor.bounds.x0), cell(at.y, floor.bounds.y0));
}

struct AuditFloor {
  navigation::OccupancyGrid robot;  // where its middle gets to
  navigation::OccupancyGrid open;   // where nothing stands

  double step_m() const { return open.cell_mm * 1e-3; }

  // How far from the edge of a module's shelves the floor before it is open, up to `limit_m`.
  double open_to(const BayFace& face, Vec3 edge, double limit_m) const {
    double open_m = std::max(0.0, face.front_m - face.footprint_m) + step_m();
    while (open_m <= limit_m && is_free(open, edge - face.ahead * open_m))
      open_m += step_m();
    return open_m - step_m();
  }

  // How far before the shelves the robot stands: what is nearest to the distance that is wanted,
  // with nothing between.
  std::optional<double> distance_before(const BayFace& face, Vec3 edge, double wanted_m) const {
    const double limit_m = open_to(face, edge, wanted_m + farther_m);
    const double reach_m = std::max(farther_m, wanted_m - min_distance_m);
    for (int i = 0; i * step_m() <= reach_m; ++i) {
      for (const double distance_m : {wanted_m - i * step_m(), wanted_m + i * step_m()}) {
        const bool in_range = distance_m >= min_distance_m && distance_m <= limit_m;
        if (in_range && is_free(robot, edge - face.ahead * distance_m)) return distance_m;
      }
    }
    return std::nullopt;
  }
};

render::Camera level_camera(const std::string& name,
                            Vec3 from,
                            Vec3 ahead,
                            const std::array<int, 2>& size_px) {
  render::Camera camera{
      name, from, from + ahead, shelf_view_deg, 0, size_px[0], size_px[1], {}, {}};
  return render::posed_camera(
      name, render::opencv_pose_of(camera), render::intrinsics_of(camera), size_px[0], size_px[1]);
}

void add_run(ShelfShots& into,
             const std::vector<BayFace>& run,
             const AuditFloor& floor,
             const ExportOptions& options) {
  const double left_m = run.front().left_m;
  double right_m = left_m;
  for (const BayFace& face : run)
    right_m = std::max(right_m, face.right_m);
  const int stops = std::max(
      1, static_cast<int>(std::ceil((right_m - left_m) / options.camera_spacing_m - 1e-6)));
  for (int stop = 0; stop < stops; ++stop) {
    const double along_m = left_m + (right_m - left_m) * (stop + 0.5) / stops;
    const BayFace& face = face_at(run, along_m);
    const Vec3 edge = face.right * along_m + face.ahead * face.front_m;
    const auto distance_m = floor.distance_before(face, edge, options.camera_distance_m);
    if (!distance_m) {
      ++into.stops_without_room;
      continue;
    }
    const Vec3 at = edge - face.ahead * *distance_m;
    for (const double height_m : options.camera_heights_m) {
      const std::string name =
          fmt::format("{}/side-{}/stop-{}/{:.2f}m", face.run, face.side, stop + 1, height_m);
      into.shots.push_back(
          {face.zone,
           face.run,
           face.side,
           *distance_m,
           level_camera(name, {at.x, at.y, height_m}, face.ahead, options.picture_px)});
    }
  }
}

Result<void> check_metres(double value,
                          std::array<double, 2> range,
                          const char* flag,
                          const char* what) {
  if (value >= range[0] && value <= range[1]) return {};
  return Error{"usage.bad_flag",
               flag,
               fmt::format("{} is no {}; expected {} to {} m", value, what, range[0], range[1])};
}

}  // namespace

Result<void> check_coco_options(const ExportOptions& options) {
  MARKETGEN_CHECK(check_metres(
      options.camera_spacing_m, {0.05, 10}, "--camera-spacing", "way between two pictures"));
  MARKETGEN_CHECK(check_metres(
      options.camera_distance_m, {0.5, 5}, "--camera-distance", "distance of a camera"));
  if (options.camera_heights_m.empty())
    return Error{"usage.bad_flag", "--camera-height", "there is no camera; name a height"};
  for (const double height_m : options.camera_heights_m)
    MARKETGEN_CHECK(check_metres(height_m, {0.05, 3}, "--camera-height", "height of a camera"));
  const render::Camera camera{"size",
                              {},
                              {1, 0, 0},
                              shelf_view_deg,
                              0,
                              options.picture_px[0],
                              options.picture_px[1],
                              {},
                              {}};
  return render::check_camera(camera, "--size");
}

ShelfShots shelf_shots(const scene::Scene& scene,
                       const catalog::Catalog& catalog,
                       const ExportOptions& options) {
  const AuditFloor floor{robot_floor(scene, catalog, options), open_floor(scene, options)};
  ShelfShots shots;
  for (const std::vector<BayFace>& run : run_faces(scene))
    add_run(shots, run, floor, options);
  return shots;
}

}  // namespace marketgen::exporters
