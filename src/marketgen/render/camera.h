// Cameras: pinhole, and orthographic for plans.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "geometry/vector.h"
#include "scene/scene.h"

namespace marketgen {

struct Camera {
  std::string name;
  Vec3 from;                       // metres, store frame
  Vec3 at;                         // point it looks at
  double fov_deg = 60;             // vertical field of view; ignored when orthographic
  double ortho_height_m = 0;       // > 0: orthographic, this much of the world from top to bottom
  int width = 1280, height = 720;  // pixels
};

// The views every store has: top, entrance, aisle, checkout, and one per zone ("zone:dairy").
// Deterministic; each stands in free floor at eye height and sees goods.
std::vector<Camera> standard_cameras(const Scene& scene, int width, int height);
Result<Camera> camera_named(const Scene& scene, std::string_view name, int width, int height);
// Errors: camera.degenerate (no direction, NaN, fov outside 1..170), camera.bad_size (1..16384 a
// side, at most 64 megapixels).
Result<void> check_camera(const Camera& camera, const std::string& where);

}  // namespace marketgen
