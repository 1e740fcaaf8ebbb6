#include "render/camera.h"

#include <cmath>

#include "base/text.h"

namespace marketgen {
namespace {

constexpr int largest_side_px = 16384;
constexpr std::int64_t most_pixels = 64'000'000;
constexpr double narrowest_deg = 1, widest_deg = 170;
constexpr double farthest_m = 1e6;

bool is_place(Vec3 p) {
  return std::fabs(p.x) < farthest_m && std::fabs(p.y) < farthest_m &&
         std::fabs(p.z) < farthest_m;  // false for NaN
}

}  // namespace

Result<void> check_camera(const Camera& camera, const std::string& where) {
  if (camera.width < 1 || camera.height < 1 || camera.width > largest_side_px ||
      camera.height > largest_side_px || std::int64_t{camera.width} * camera.height > most_pixels) {
    return Error{
        "camera.bad_size",
        where,
        "a picture of " + std::to_string(camera.width) + " x " + std::to_string(camera.height) +
            " pixels cannot be made; sides go from 1 to 16384, with at most 64 megapixels"};
  }
  if (!is_place(camera.from) || !is_place(camera.at)) {
    return Error{"camera.degenerate", where, "its place or its target is not a finite point"};
  }
  if (length(camera.at - camera.from) < 1e-6) {
    return Error{
        "camera.degenerate", where, "it looks at the point where it stands; move the target"};
  }
  const bool orthographic = camera.ortho_height_m > 0;
  if (std::isnan(camera.ortho_height_m) || camera.ortho_height_m < 0 ||
      camera.ortho_height_m > farthest_m) {
    return Error{
        "camera.degenerate", where, "its orthographic height must be positive, or 0 for a pinhole"};
  }
  if (!orthographic && !(camera.fov_deg >= narrowest_deg && camera.fov_deg <= widest_deg)) {
    return Error{
        "camera.degenerate", where, "its field of view must lie between 1 and 170 degrees"};
  }
  return {};
}

Result<Camera> camera_named(const Scene& scene, std::string_view name, int width, int height) {
  const std::vector<Camera> cameras = standard_cameras(scene, width, height);
  std::vector<std::string_view> known;
  for (const Camera& camera : cameras)
    known.push_back(camera.name);
  for (Camera camera : cameras) {
    camera.width = width;  // as asked for: whoever draws checks it
    camera.height = height;
    if (camera.name == name) return camera;
  }
  return Error{"camera.unknown",
               "--camera",
               "this store has no camera \"" + std::string(name) + "\"" +
                   did_you_mean(name, known) +
                   "; it has top, entrance, aisle, checkout and one per zone (zone:<id>)"};
}

}  // namespace marketgen
