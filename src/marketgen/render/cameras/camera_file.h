// A camera as a JSON file, market-camera/1: what a calibration or another simulator says of it.
#pragma once
#include <array>
#include <string>

#include "base/fields.h"
#include "base/result.h"
#include "render/cameras/camera.h"

namespace marketgen::render {

// In the frames and pixels of camera_model.h: those of OpenCV.
struct CameraFile {
  std::string schema = "market-camera/1";
  std::string name;
  int width = 0, height = 0;              // pixels
  double fx = 0, fy = 0, cx = 0, cy = 0;  // pixels; 0 when orthographic
  std::array<double, 5> distortion{};     // k1, k2, p1, p2, k3
  double ortho_height_m = 0;              // > 0: orthographic
  std::array<double, 3> position_m{};     // world_from_camera
  std::array<double, 4> rotation_wxyz{1, 0, 0, 0};

  static constexpr auto fields = field_list(
      field("schema", &CameraFile::schema, "schema tag", constant("market-camera/1")),
      field("name", &CameraFile::name, "of the view"),
      field("width", &CameraFile::width, "of the picture, pixels", required()),
      field("height", &CameraFile::height, "of the picture, pixels", required()),
      field("fx", &CameraFile::fx, "focal length across, pixels; 0 when orthographic"),
      field("fy", &CameraFile::fy, "focal length down, pixels; 0 when orthographic"),
      field("cx", &CameraFile::cx, "principal point; the centre of the top left pixel is (0, 0)"),
      field("cy", &CameraFile::cy, "principal point; the centre of the top left pixel is (0, 0)"),
      field("distortion", &CameraFile::distortion, "k1, k2, p1, p2, k3 as OpenCV has them"),
      field("ortho_height_m",
            &CameraFile::ortho_height_m,
            "above 0: orthographic, this much of the world from top to bottom"),
      field("position_m", &CameraFile::position_m, "in the store frame", required()),
      field("rotation_wxyz",
            &CameraFile::rotation_wxyz,
            "world_from_camera, a unit quaternion; camera frame x right, y down, z ahead",
            required()));
};

CameraFile camera_file_of(const Camera& camera);
// Errors, at `where`: those of check_camera().
Result<Camera> camera_of(const CameraFile& file, const std::string& where);

}  // namespace marketgen::render
