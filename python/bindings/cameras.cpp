#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/string.h>

#include "binding.h"
#include "io/json.h"
#include "render/annotations.h"
#include "render/cameras/camera_file.h"

namespace marketgen::python {
namespace {

using Point = std::array<double, 3>;

render::Camera look_at(const Point& from, const Point& at, double fov_deg, int width, int height) {
  render::Camera camera;
  camera.name = "camera";
  camera.from = {from[0], from[1], from[2]};
  camera.at = {at[0], at[1], at[2]};
  camera.fov_deg = fov_deg;
  camera.width = width;
  camera.height = height;
  check_or_raise(render::check_camera(camera, "camera"));
  return camera;
}

render::Camera camera_from_json(const std::string& text) {
  const render::CameraFile file = value_or_raise(io::read_json<render::CameraFile>(text, "camera"));
  return value_or_raise(render::camera_of(file, "camera"));
}

template <std::size_t rows>
using Square = nb::ndarray<nb::numpy, double, nb::shape<rows, rows>>;

template <std::size_t rows>
Square<rows> array_of(const std::array<std::array<double, rows>, rows>& matrix) {
  auto* kept = new std::array<std::array<double, rows>, rows>(matrix);
  const nb::capsule owner(kept, [](void* p) noexcept {
    delete static_cast<std::array<std::array<double, rows>, rows>*>(p);
  });
  return Square<rows>(kept->data(), {rows, rows}, owner);
}

}  // namespace

void add_cameras(nb::module_& module) {
  nb::class_<render::Camera>(
      module, "Camera", "A pinhole camera, with a lens or without; or a plan view.")
      .def_static("look_at",
                  &look_at,
                  nb::arg("position"),
                  nb::arg("target"),
                  nb::arg("fov_deg") = 60.0,
                  nb::arg("width") = 640,
                  nb::arg("height") = 480,
                  "Upright at `position`, looking at `target`: metres in the store's frame.\n"
                  "`fov_deg` is vertical. Raises Error camera.*.")
      .def_static("_from_json", &camera_from_json)
      .def("_to_json",
           [](const render::Camera& c) { return io::write_json(render::camera_file_of(c)); })
      .def_ro("name", &render::Camera::name)
      .def_ro("width", &render::Camera::width, "Pixels.")
      .def_ro("height", &render::Camera::height, "Pixels.")
      .def_prop_ro(
          "intrinsic_cv",
          [](const render::Camera& c) { return array_of<3>(render::matrices_of(c).k); },
          nb::rv_policy::automatic,
          "(3, 3) float64: OpenCV's camera matrix in pixels; zeros when orthographic.")
      .def_prop_ro(
          "extrinsic_cv",
          [](const render::Camera& c) {
            return array_of<4>(render::matrices_of(c).opencv_from_world);
          },
          nb::rv_policy::automatic,
          "(4, 4) float64: camera (x right, y down, z ahead) from the store's frame.")
      .def_prop_ro(
          "cam2world_gl",
          [](const render::Camera& c) {
            return array_of<4>(render::matrices_of(c).world_from_opengl);
          },
          nb::rv_policy::automatic,
          "(4, 4) float64: the store's frame from the camera (x right, y up, z back).");
}

}  // namespace marketgen::python
