#include "render/cameras/camera_file.h"

namespace marketgen::render {

CameraFile camera_file_of(const Camera& camera) {
  CameraFile file;
  file.name = camera.name;
  file.width = camera.width;
  file.height = camera.height;
  file.ortho_height_m = camera.ortho_height_m;
  const Pose pose = opencv_pose_of(camera);
  file.position_m = {pose.position.x, pose.position.y, pose.position.z};
  file.rotation_wxyz = {pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z};
  if (camera.ortho_height_m > 0) return file;
  const Intrinsics k = intrinsics_of(camera);
  file.fx = k.fx, file.fy = k.fy, file.cx = k.cx, file.cy = k.cy;
  file.distortion = {
      k.distortion.k1, k.distortion.k2, k.distortion.p1, k.distortion.p2, k.distortion.k3};
  return file;
}

Result<Camera> camera_of(const CameraFile& file, const std::string& where) {
  const auto& [x, y, z] = file.position_m;
  const auto& [qw, qx, qy, qz] = file.rotation_wxyz;
  const auto& [k1, k2, p1, p2, k3] = file.distortion;
  Camera camera = posed_camera(file.name,
                               {{x, y, z}, {qw, qx, qy, qz}},
                               {file.fx, file.fy, file.cx, file.cy, {k1, k2, p1, p2, k3}},
                               file.width,
                               file.height);
  if (file.ortho_height_m > 0) {
    camera.ortho_height_m = file.ortho_height_m;
    camera.intrinsics.reset();
  }
  MARKETGEN_CHECK(check_camera(camera, where));
  return camera;
}

}  // namespace marketgen::render
