// Cameras: pinhole, pinhole with a lens, and orthographic for plans.
//
// A camera stands either by `from` and `at`, upright, or by a pose: a camera on a robot's wrist. It
// sees either by `fov_deg`, or by the intrinsics of a calibrated lens.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "geometry/pose.h"
#include "render/cameras/camera_model.h"
#include "scene/scene.h"

namespace marketgen::render {

struct Camera {
  std::string name;
  Vec3 from;                       // metres, store frame
  Vec3 at;                         // point it looks at
  double fov_deg = 60;             // vertical field of view; ignored when orthographic
  double ortho_height_m = 0;       // > 0: orthographic, this much of the world from top to bottom
  int width = 1280, height = 720;  // pixels
  // Instead of `from` and `at`. OpenCV's camera frame: x right, y down, z ahead.
  std::optional<Pose> world_from_camera = {};
  std::optional<Intrinsics> intrinsics = {};  // instead of `fov_deg`; not when orthographic
};

// A camera in any pose with a calibrated lens.
Camera posed_camera(std::string name,
                    const Pose& world_from_camera,
                    const Intrinsics& intrinsics,
                    int width,
                    int height);

// Its frame's axes in the store frame, unit vectors; without a pose the picture's upper edge is
// level, and north is up in views straight up or down.
struct CameraAxes {
  Vec3 right, down, ahead;
};
CameraAxes axes_of(const Camera& camera);
Vec3 place_of(const Camera& camera);  // metres, store frame
// In OpenCV's frame (x right, y down, z ahead), however the camera was given.
Pose opencv_pose_of(const Camera& camera);
// The same in OpenGL's frame (x right, y up, z back), as OpenGL, MuJoCo and Blender have it.
Pose opengl_pose_of(const Camera& camera);
// Precondition: not orthographic.
Intrinsics intrinsics_of(const Camera& camera);
// From points of the store to the picture points that show them.
class Projection {
 public:
  explicit Projection(const Camera& camera);
  // In the pixels of camera_model.h; nothing for what is behind the camera or outside what its lens
  // can see. Points beyond the picture's edges are projected too.
  std::optional<Vec2> operator()(Vec3 store_point) const;

 private:
  Vec3 place_;
  CameraAxes axes_;
  Intrinsics intrinsics_;
  double ortho_pixels_per_m_ = 0;  // > 0: orthographic
};

// The views every store has: top, entrance, aisle, checkout, and one per zone ("zone:dairy").
// Deterministic; each stands in free floor at eye height and sees goods.
std::vector<Camera> standard_cameras(const scene::Scene& scene, int width, int height);
Result<Camera> camera_named(const scene::Scene& scene,
                            std::string_view name,
                            int width,
                            int height);
constexpr double narrowest_view_deg = 1, widest_view_deg = 170;  // of a pinhole's field of view
// Errors: camera.degenerate (no direction, NaN, a rotation that is no unit quaternion, fov outside
// its range), camera.bad_lens, camera.bad_size (1..16384 a side, at most 64 megapixels).
Result<void> check_camera(const Camera& camera, const std::string& where);

}  // namespace marketgen::render
