#include "render/fixture_picture.h"

#include <algorithm>
#include <cmath>

#include "geometry/mesh.h"
#include "render/render.h"

namespace marketgen::render {
namespace {

constexpr double fixture_fov_deg = 36;
constexpr double margin = 1.06;
constexpr double pi = 3.14159265358979323846;

// Corners of every part's box, in the store frame.
std::vector<Vec3> corners_of(const scene::Scene& scene) {
  std::vector<Vec3> corners;
  for (const scene::ScenePart& part : scene.parts) {
    const Pose world =
        scene::world_from_fixture(scene, part.fixture) * scene::fixture_from_part(part);
    for (int corner = 0; corner < 8; ++corner) {
      const auto along = [&](int axis) {
        const auto half = double(part.half_size_m[static_cast<std::size_t>(axis)]);
        return (corner >> axis & 1) != 0 ? half : -half;
      };
      corners.push_back(world * Vec3{along(0), along(1), along(2)});
    }
  }
  return corners;
}

Vec3 middle_of(const std::vector<Vec3>& points) {
  Bounds3 bounds;
  for (const Vec3& point : points)
    bounds.include(to_float(point));
  return to_double(bounds.center());
}

// As near as the view allows with every point in it.
Camera camera_for(const std::vector<Vec3>& points, int size_px) {
  const Vec3 at = middle_of(points);
  const Vec3 back = normalized(Vec3{0.5, -1.0, 0.42});  // from the right, above the front
  const Vec3 right = normalized(cross(Vec3{0, 0, 1}, back)), up = cross(back, right);
  const double slope = std::tan(fixture_fov_deg / 2 * pi / 180) / margin;
  double distance = 0;
  for (const Vec3& point : points) {
    const Vec3 d = point - at;
    const double aside = std::max(std::abs(dot(d, right)), std::abs(dot(d, up)));
    distance = std::max(distance, dot(d, back) + aside / slope);
  }
  return {"fixture", at + back * distance, at, fixture_fov_deg, 0, size_px, size_px};
}

}  // namespace

Result<Image> draw_fixture(const scene::Scene& stage, int size_px) {
  const Camera camera = camera_for(corners_of(stage), size_px);
  MARKETGEN_CHECK(check_camera(camera, "fixture"));
  MARKETGEN_TRY(const std::unique_ptr<Renderer> renderer, Renderer::create(stage));
  RenderOptions options;
  options.quality = Quality::best;
  options.hide_ceiling = true;
  MARKETGEN_TRY(Frame frame, renderer->render(camera, options));
  return std::move(frame.color);
}

}  // namespace marketgen::render
