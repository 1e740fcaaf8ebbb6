#include "camera_flags.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>

#include "base/text.h"
#include "io/file.h"
#include "io/json.h"
#include "number_flags.h"
#include "render/cameras/camera_file.h"
#include "render/cameras/viewpoint.h"

namespace marketgen::app {
namespace {

std::optional<double> number_in(const std::string& text) {
  double value = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failed != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

Result<Vec3> parse_point(const std::string& text, const std::string& flag) {
  const std::vector<std::string> parts = split(text, ',');
  double values[3] = {};
  bool good = parts.size() == 3;
  for (std::size_t i = 0; good && i < 3; ++i) {
    const auto value = number_in(parts[i]);
    good = value.has_value() && std::isfinite(*value);
    values[i] = value.value_or(0);
  }
  if (!good)
    return Error{
        "usage.bad_flag", flag, fmt::format("\"{}\" is not a point; write x,y,z in metres", text)};
  return Vec3{values[0], values[1], values[2]};
}

Result<render::Camera> camera_from_file(const CameraFlags& flags) {
  if (!flags.name.empty() || !flags.from.empty() || !flags.at.empty())
    return Error{"usage.bad_flag",
                 "--camera-file",
                 "the file says where the camera stands; leave out --camera, --from and --at"};
  MARKETGEN_TRY(const std::string text, io::read_file(flags.file));
  MARKETGEN_TRY(const render::CameraFile file, io::read_json<render::CameraFile>(text, flags.file));
  return render::camera_of(file, flags.file);
}

Result<render::Camera> named_camera(const CameraFlags& flags,
                                    const scene::Scene& scene,
                                    std::pair<int, int> pixels) {
  const auto [width, height] = pixels;
  MARKETGEN_TRY(
      const render::Camera named,
      render::camera_named(scene, flags.name.empty() ? "entrance" : flags.name, width, height));
  MARKETGEN_CHECK(render::check_camera(named, "--size"));
  return named;
}

}  // namespace

Result<std::pair<int, int>> picture_size(const std::string& text) {
  const std::vector<std::string> parts = split(lower_ascii(text), 'x');
  const auto width = number_in(parts[0]), height = number_in(parts.size() == 2 ? parts[1] : "");
  if (!width || !height || *width != std::floor(*width) || *height != std::floor(*height) ||
      std::abs(*width) > 1e6 || std::abs(*height) > 1e6) {
    return Error{"camera.bad_size",
                 "--size",
                 fmt::format("\"{}\" is not a picture size; write 1280x720", text)};
  }
  return std::pair(static_cast<int>(*width), static_cast<int>(*height));
}

void add_camera_flags(CLI::App& command, CameraFlags& flags) {
  command
      .add_option(
          "--camera", flags.name, "standard view: top, entrance, aisle, checkout, zone:<id>")
      ->type_name("CAMERA");
  command
      .add_option("--camera-file",
                  flags.file,
                  "a camera in any pose with its lens, market-camera/1 (docs/cameras.md)")
      ->type_name("FILE");
  command.add_option("--from", flags.from, "stand at x,y,z (metres)")->type_name("POINT");
  command.add_option("--at", flags.at, "look at x,y,z (metres)")->type_name("POINT");
  command
      .add_option("--fov-deg",
                  flags.fov_deg,
                  "vertical field of view, with --from and --at; 60 when not given")
      ->check(real_number(render::narrowest_view_deg, render::widest_view_deg));
  command.add_option("--size", flags.size, "picture size in pixels")
      ->type_name("SIZE")
      ->capture_default_str();
}

Result<render::Camera> camera_of(const CameraFlags& flags, const scene::Scene& scene) {
  if (flags.fov_deg && flags.from.empty())
    return Error{"usage.bad_flag",
                 "--fov-deg",
                 "cameras with a name or a file have their own; give --from and --at with it"};
  if (!flags.file.empty()) {
    MARKETGEN_TRY(const render::Camera camera, camera_from_file(flags));
    MARKETGEN_CHECK(render::check_viewpoint(scene, camera, flags.file));
    return camera;
  }
  MARKETGEN_TRY(const auto pixels, picture_size(flags.size));
  if (flags.from.empty() != flags.at.empty())
    return Error{"usage.bad_flag", "--from", "give both --from and --at"};
  if (flags.from.empty()) return named_camera(flags, scene, pixels);
  if (!flags.name.empty())
    return Error{"usage.bad_flag", "--camera", "give a camera's name or --from and --at, not both"};
  render::Camera camera;
  camera.name = "custom";
  MARKETGEN_TRY(camera.from, parse_point(flags.from, "--from"));
  MARKETGEN_TRY(camera.at, parse_point(flags.at, "--at"));
  camera.fov_deg = flags.fov_deg.value_or(60);
  camera.width = pixels.first;
  camera.height = pixels.second;
  MARKETGEN_CHECK(render::check_camera(camera, "render"));
  MARKETGEN_CHECK(render::check_viewpoint(scene, camera, "--from"));
  return camera;
}

}  // namespace marketgen::app
