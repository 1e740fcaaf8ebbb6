#include <nanobind/ndarray.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>

#include "binding.h"
#include "frame_handle.h"
#include "io/exr.h"
#include "io/picture_file.h"
#include "io/png.h"

namespace marketgen::python {
namespace {

template <class T>
using Array = nb::ndarray<nb::numpy, T, nb::c_contig>;

// A plane of the picture with `channels` numbers a pixel; the frame lives as long as the array.
template <class T>
Array<T> plane(FrameHandle& handle, std::vector<T>& numbers, std::size_t channels) {
  const auto height = static_cast<std::size_t>(handle.frame.color.height);
  const auto width = static_cast<std::size_t>(handle.frame.color.width);
  const std::size_t shape[3] = {height, width, channels};
  return Array<T>(numbers.data(), channels == 1 ? 2 : 3, shape, nb::handle());
}

void save(const FrameHandle& handle, const std::filesystem::path& to) {
  const render::Frame& frame = handle.frame;
  const std::string path = to.string();
  if (!path.ends_with(".exr")) return check_or_raise(io::write_picture(path, frame.color));
  if (frame.radiance.empty())
    raise({"usage.bad_flag", path, "linear light (EXR) is what mode=\"path\" draws"});
  check_or_raise(io::write_exr(path, {frame.color.width, frame.color.height, frame.radiance}));
}

std::string written(const FrameHandle& handle) {
  return "<marketgen.Frame " + std::to_string(handle.frame.color.width) + " x " +
         std::to_string(handle.frame.color.height) + ">";
}

}  // namespace

void add_frames(nb::module_& module) {
  constexpr auto inside = nb::rv_policy::reference_internal;
  nb::class_<FrameHandle>(module, "Frame", "One picture and its planes, (height, width[, 3]).")
      .def_prop_ro(
          "rgb",
          [](FrameHandle& h) { return plane(h, h.frame.color.pixels, 3); },
          inside,
          "uint8 sRGB, tone mapped.")
      .def_prop_ro(
          "depth",
          [](FrameHandle& h) { return plane(h, h.frame.depth_m, 1); },
          inside,
          "float32 metres along the optical axis; 0 where nothing was hit.")
      .def_prop_ro(
          "instance",
          [](FrameHandle& h) { return plane(h, h.frame.instance, 1); },
          inside,
          "uint32 object numbers: those of annotations' `id`.")
      .def_prop_ro(
          "normals",
          [](FrameHandle& h) { return plane(h, h.frame.normals, 3); },
          inside,
          "float32 unit vectors in the store's frame.")
      .def_prop_ro(
          "matter",
          [](FrameHandle& h) { return plane(h, h.frame.matter, 1); },
          inside,
          "uint8: what a depth sensor meets there (docs/cameras.md).")
      .def_prop_ro(
          "radiance",
          [inside](FrameHandle& h) -> nb::object {
            if (h.frame.radiance.empty()) return nb::none();
            return nb::cast(plane(h, h.frame.radiance, 3), inside, nb::find(h));
          },
          "float32 linear Rec. 709 light in cd/m2; None unless mode=\"path\".")
      .def(
          "_repr_png_",
          [](const FrameHandle& h) {
            const std::string png = value_or_raise(io::encode_png(h.frame.color));
            return nb::bytes(png.data(), png.size());
          },
          "How notebooks show it: the colours as a PNG.")
      .def("__repr__", &written)
      .def(
          "save", &save, nb::arg("path"), "Writes a PNG or a JPEG, or an EXR of the linear light.");
}

}  // namespace marketgen::python
