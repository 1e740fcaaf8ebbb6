#include "render/cameras/camera.h"

#include <cmath>

#include <fmt/format.h>

#include "base/text.h"
#include "geometry/rotation_axes.h"

namespace marketgen::render {
namespace {

constexpr int largest_side_px = 16384;
constexpr std::int64_t max_pixels = 64'000'000;
constexpr double farthest_m = 1e6;

bool is_place(Vec3 p) {
  return std::fabs(p.x) < farthest_m && std::fabs(p.y) < farthest_m &&
         std::fabs(p.z) < farthest_m;  // false for NaN
}

bool is_unit(const Quaternion& q) {
  return std::fabs(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z - 1) < 1e-6;
}

Result<void> check_size(const Camera& camera, const std::string& where) {
  if (camera.width < 1 || camera.height < 1 || camera.width > largest_side_px ||
      camera.height > largest_side_px || std::int64_t{camera.width} * camera.height > max_pixels) {
    return Error{
        "camera.bad_size",
        where,
        "a picture of " + std::to_string(camera.width) + " x " + std::to_string(camera.height) +
            " pixels cannot be made; sides go from 1 to 16384, with at most 64 megapixels"};
  }
  return {};
}

Result<void> check_place(const Camera& camera, const std::string& where) {
  if (camera.world_from_camera) {
    if (!is_place(camera.world_from_camera->position))
      return Error{"camera.degenerate", where, "its place is not a finite point"};
    if (!is_unit(camera.world_from_camera->rotation))
      return Error{"camera.degenerate",
                   where,
                   "its rotation is no unit quaternion (w, x, y, z); divide it by its length"};
    return {};
  }
  if (!is_place(camera.from) || !is_place(camera.at))
    return Error{"camera.degenerate", where, "its place or its target is not a finite point"};
  if (length(camera.at - camera.from) < 1e-6) {
    return Error{
        "camera.degenerate", where, "it looks at the point where it stands; move the target"};
  }
  return {};
}

}  // namespace

Camera posed_camera(std::string name,
                    const Pose& world_from_camera,
                    const Intrinsics& intrinsics,
                    int width,
                    int height) {
  Camera camera;
  camera.name = std::move(name);
  camera.world_from_camera = world_from_camera;
  camera.intrinsics = intrinsics;
  camera.width = width;
  camera.height = height;
  return camera;
}

Vec3 place_of(const Camera& camera) {
  return camera.world_from_camera ? camera.world_from_camera->position : camera.from;
}

CameraAxes axes_of(const Camera& camera) {
  if (camera.world_from_camera) {
    const Quaternion& turn = camera.world_from_camera->rotation;
    return {rotate(turn, {1, 0, 0}), rotate(turn, {0, 1, 0}), rotate(turn, {0, 0, 1})};
  }
  const Vec3 ahead = normalized(camera.at - camera.from);
  const Vec3 upward = std::fabs(ahead.z) > 0.9999 ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  const Vec3 right = normalized(cross(ahead, upward));
  return {right, cross(ahead, right), ahead};
}

Pose opencv_pose_of(const Camera& camera) {
  if (camera.world_from_camera) return *camera.world_from_camera;
  const CameraAxes axes = axes_of(camera);
  return {camera.from, rotation_with_axes(axes.down, axes.ahead)};
}

Pose opengl_pose_of(const Camera& camera) {
  const Pose half_turn_about_x{{}, {0, 1, 0, 0}};
  return opencv_pose_of(camera) * half_turn_about_x;
}

Intrinsics intrinsics_of(const Camera& camera) {
  return camera.intrinsics.value_or(centred_pinhole(camera.width, camera.height, camera.fov_deg));
}

Projection::Projection(const Camera& camera) : place_(place_of(camera)), axes_(axes_of(camera)) {
  intrinsics_ = intrinsics_of(camera);
  if (camera.ortho_height_m <= 0) return;
  ortho_pixels_per_m_ = camera.height / camera.ortho_height_m;
  intrinsics_.cx = (camera.width - 1) / 2.0;
  intrinsics_.cy = (camera.height - 1) / 2.0;
}

std::optional<Vec2> Projection::operator()(Vec3 store_point) const {
  const Vec3 off = store_point - place_;
  const Vec3 p{dot(axes_.right, off), dot(axes_.down, off), dot(axes_.ahead, off)};
  if (ortho_pixels_per_m_ == 0) return project(intrinsics_, p);
  if (!(p.z > 0)) return std::nullopt;
  return Vec2{intrinsics_.cx + p.x * ortho_pixels_per_m_,
              intrinsics_.cy + p.y * ortho_pixels_per_m_};
}

Result<void> check_camera(const Camera& camera, const std::string& where) {
  MARKETGEN_CHECK(check_size(camera, where));
  MARKETGEN_CHECK(check_place(camera, where));
  const bool orthographic = camera.ortho_height_m > 0;
  if (std::isnan(camera.ortho_height_m) || camera.ortho_height_m < 0 ||
      camera.ortho_height_m > farthest_m) {
    return Error{
        "camera.degenerate", where, "its orthographic height must be positive, or 0 for a pinhole"};
  }
  if (camera.intrinsics) {
    if (orthographic)
      return Error{
          "camera.degenerate", where, "an orthographic view has no lens; leave its intrinsics out"};
    return check_lens(*camera.intrinsics, camera.width, camera.height, where);
  }
  if (!orthographic && !(camera.fov_deg >= narrowest_view_deg && camera.fov_deg <= widest_view_deg))
    return Error{"camera.degenerate",
                 where,
                 fmt::format("its field of view must lie between {:g} and {:g} degrees",
                             narrowest_view_deg,
                             widest_view_deg)};
  return {};
}

Result<Camera> camera_named(const scene::Scene& scene,
                            std::string_view name,
                            int width,
                            int height) {
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

}  // namespace marketgen::render
