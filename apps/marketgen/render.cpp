// marketgen render: a picture of a store, with robots in it if wanted; depth, segmentation, object
// numbers and normals beside it.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/parallel.h"
#include "base/text.h"
#include "command.h"
#include "io/exr.h"
#include "io/file.h"
#include "io/json.h"
#include "io/png.h"
#include "motion/standing_robot.h"
#include "render/picture_objects.h"
#include "render/render.h"
#include "render/robot_actor.h"

namespace marketgen::app {
namespace {

struct RenderFlags {
  CommonFlags common;
  std::string folder, output, camera, from, at,
      size = "1280x720", mode = "sensor", quality = "balanced", depth, segmentation, object_ids,
      legend, normals, skin, denoise = "auto";
  std::vector<std::string> robots;
  double fov_deg = 60, time_s = 0, exposure_stops = 0;
  int samples = 0;
  bool list = false;
};

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

Result<std::pair<int, int>> parse_pixels(const std::string& text) {
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

Result<Camera> camera_of(const RenderFlags& flags, const Scene& scene) {
  MARKETGEN_TRY(const auto pixels, parse_pixels(flags.size));
  const auto [width, height] = pixels;
  if (flags.from.empty() != flags.at.empty())
    return Error{"usage.bad_flag", "--from", "give both --from and --at"};
  if (flags.from.empty()) {
    MARKETGEN_TRY(
        const Camera named,
        camera_named(scene, flags.camera.empty() ? "entrance" : flags.camera, width, height));
    MARKETGEN_CHECK(check_camera(named, "--size"));
    return named;
  }
  if (!flags.camera.empty())
    return Error{"usage.bad_flag", "--camera", "give a camera's name or --from and --at, not both"};
  Camera camera;
  camera.name = "custom";
  MARKETGEN_TRY(camera.from, parse_point(flags.from, "--from"));
  MARKETGEN_TRY(camera.at, parse_point(flags.at, "--at"));
  camera.fov_deg = flags.fov_deg;
  camera.width = width;
  camera.height = height;
  MARKETGEN_CHECK(check_camera(camera, "render"));
  return camera;
}

Result<std::vector<Actor>> actors_of(const RenderFlags& flags, const Scene& scene) {
  std::vector<PlacedRobot> placed;
  for (const std::string& text : flags.robots) {
    const std::string where = "--robot " + text;
    MARKETGEN_TRY(const std::filesystem::path data, data_folder());
    MARKETGEN_TRY(const RobotSpec spec, parse_robot_spec(text, where));
    MARKETGEN_TRY(PlacedRobot robot, place_robot(data, spec, where));
    placed.push_back(std::move(robot));
  }
  MARKETGEN_CHECK(check_standing(scene, placed));
  std::vector<Actor> actors;
  for (const PlacedRobot& robot : placed) {
    MARKETGEN_TRY(Actor actor, robot_actor(robot.robot, robot.q, robot.world_from_base));
    actors.push_back(std::move(actor));
  }
  return actors;
}

// "panda", and "panda-2" for the second of them.
std::vector<std::string> names_of_actors(const std::vector<Actor>& actors) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < actors.size(); ++i) {
    const auto same = [&](const Actor& other) { return other.name == actors[i].name; };
    const auto before =
        std::count_if(actors.begin(), actors.begin() + static_cast<std::ptrdiff_t>(i), same);
    names.push_back(before == 0 ? actors[i].name
                                : fmt::format("{}-{}", actors[i].name, before + 1));
  }
  return names;
}

Result<void> write_depth(const std::string& path, const Frame& frame) {
  std::vector<std::uint16_t> millimetres(frame.depth_m.size());
  constexpr float most_mm = 65535;
  for (std::size_t i = 0; i < millimetres.size(); ++i) {
    millimetres[i] =
        static_cast<std::uint16_t>(std::min(frame.depth_m[i] * 1000.0F + 0.5F, most_mm));
  }
  return write_png16(path, frame.color.width, frame.color.height, millimetres);
}

bool wants_exr(const RenderFlags& flags) {
  return lower_ascii(std::filesystem::path(flags.output).extension().string()) == ".exr";
}

Result<void> write_picture(const RenderFlags& flags, const Frame& frame) {
  if (!wants_exr(flags)) return write_png(flags.output, frame.color);
  return write_exr(flags.output, {frame.color.width, frame.color.height, frame.radiance});
}

Result<void> write_planes(const RenderFlags& flags, const Frame& frame) {
  const int width = frame.color.width, height = frame.color.height;
  if (!flags.depth.empty()) MARKETGEN_CHECK(write_depth(flags.depth, frame));
  if (!flags.segmentation.empty())
    MARKETGEN_CHECK(write_png(flags.segmentation, draw_instances(frame, width, height)));
  if (!flags.object_ids.empty())
    MARKETGEN_CHECK(write_png(flags.object_ids, draw_object_ids(frame)));
  if (!flags.normals.empty())
    MARKETGEN_CHECK(write_png(flags.normals, draw_normals(frame, width, height)));
  return {};
}

Result<void> render(const RenderFlags& flags) {
  const ThreadLimit limit(flags.common.threads);
  MARKETGEN_TRY(const Scene scene, scene_in_skin(flags.folder, flags.skin));
  if (flags.list) {
    for (const Camera& camera : standard_cameras(scene, 16, 9))
      fmt::print("{}\n", camera.name);
    return {};
  }
  if (flags.output.empty())
    return Error{"usage.bad_flag", "-o", "say where the picture goes: -o picture.png"};
  if (wants_exr(flags) && flags.mode != "path")
    return Error{"usage.bad_flag", "-o", "linear light (EXR) is what --mode path draws"};
  MARKETGEN_TRY(const Camera camera, camera_of(flags, scene));
  MARKETGEN_TRY(const std::vector<Actor> actors, actors_of(flags, scene));
  RenderOptions options;
  options.mode = value_named<RenderMode>(flags.mode).value_or(RenderMode::sensor);
  options.quality = value_named<Quality>(flags.quality).value_or(Quality::balanced);
  options.samples = flags.samples;
  options.time_s = flags.time_s;
  options.denoiser = value_named<Denoiser>(flags.denoise).value_or(Denoiser::automatic);
  options.exposure_stops = flags.exposure_stops;
  options.hide_ceiling = camera.ortho_height_m > 0;
  Progress& progress = progress_for(flags.common);
  MARKETGEN_TRY(const std::unique_ptr<Renderer> renderer, Renderer::create(scene, progress));
  MARKETGEN_CHECK(renderer->set_actors(actors));
  MARKETGEN_TRY(const Frame frame, renderer->render(camera, options, progress));
  MARKETGEN_CHECK(write_picture(flags, frame));
  MARKETGEN_CHECK(write_planes(flags, frame));
  if (!flags.legend.empty())
    MARKETGEN_CHECK(
        write_file(flags.legend, write_json(legend_of(frame, scene, names_of_actors(actors)))));
  if (!flags.common.quiet) fmt::print("picture     {}\n", flags.output);
  return {};
}

}  // namespace

Run add_render(CLI::App& app) {
  auto flags = std::make_shared<RenderFlags>();
  CLI::App* command = app.add_subcommand("render", "Draw a picture of a store");
  command->add_option("folder", flags->folder, "store folder")->required();
  command->add_option(
      "-o,--output", flags->output, "PNG file to write; EXR (--mode path): linear light in cd/m2");
  command->add_option(
      "--camera", flags->camera, "standard view: top, entrance, aisle, checkout, zone:<id>");
  command->add_flag("--list-cameras", flags->list, "print the standard views and stop");
  command->add_option("--from", flags->from, "stand at x,y,z (metres)");
  command->add_option("--at", flags->at, "look at x,y,z (metres)");
  command->add_option("--fov-deg", flags->fov_deg, "vertical field of view")->capture_default_str();
  command->add_option("--size", flags->size, "picture size in pixels")->capture_default_str();
  command->add_option("--mode", flags->mode, "sensor: seconds; path: full light transport")
      ->check(CLI::IsMember({"sensor", "path"}))
      ->capture_default_str();
  command->add_option("--quality", flags->quality, "fast, balanced or best")
      ->check(CLI::IsMember({"fast", "balanced", "best"}))
      ->capture_default_str();
  command->add_option("--spp", flags->samples, "samples a pixel; 0 = what the quality says")
      ->check(CLI::Range(0, 65536));
  command->add_option("--time", flags->time_s, "path mode: stop after this many seconds")
      ->check(CLI::Range(0.0, 1e6));
  command->add_option("--denoise", flags->denoise, "path mode: auto, own, neural or none")
      ->check(CLI::IsMember({"auto", "own", "neural", "none"}))
      ->capture_default_str();
  command
      ->add_option(
          "--exposure", flags->exposure_stops, "path mode: stops brighter (+) or darker (-)")
      ->check(CLI::Range(-10.0, 10.0));
  command->add_option("--skin", flags->skin, "draw the store in the look of this style");
  command
      ->add_option("--robot",
                   flags->robots,
                   "put a robot into the picture (repeatable): "
                   "ROW@X,Y[,HEADING_DEG][,z=M][,posture=NAME][,JOINT=VALUE][,SLOT=TOOL]")
      ->allow_extra_args(false);
  command->add_option("--depth", flags->depth, "also write depth, 16-bit PNG in millimetres");
  command->add_option("--segmentation", flags->segmentation, "also write a colour per object");
  command->add_option(
      "--object-ids", flags->object_ids, "also write object numbers: red + 256 green + 65536 blue");
  command->add_option("--legend", flags->legend, "also write what each object number is, as JSON");
  command->add_option("--normals", flags->normals, "also write normals");
  add_common_flags(*command, flags->common, Takes::nothing);
  command->footer(
      "Example:  marketgen render shop --camera aisle -o aisle.png --depth aisle-depth.png\n"
      "          marketgen render shop --camera aisle --mode path -o aisle.exr\n"
      "          marketgen render shop --camera aisle -o robot.png "
      "--robot realman-rm65@4.2,3.1,90,posture=stow,lift=0.3");
  return [flags] {
    const auto done = render(*flags);
    return done.ok() ? 0 : fail(done.error());
  };
}

}  // namespace marketgen::app
