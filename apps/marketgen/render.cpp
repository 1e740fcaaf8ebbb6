// marketgen render: a picture of a store, with robots in it if wanted, as a perfect or a noisy
// sensor sees it; depth, segmentation, object numbers, normals and annotations beside it.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/parallel.h"
#include "base/text.h"
#include "camera_flags.h"
#include "collect/standing_robot.h"
#include "collect/store_people.h"
#include "command.h"
#include "io/exr.h"
#include "io/json.h"
#include "io/npy.h"
#include "io/output.h"
#include "io/picture_file.h"
#include "io/png.h"
#include "number_flags.h"
#include "render/annotations.h"
#include "render/channel_pictures.h"
#include "render/depth_mm.h"
#include "render/render.h"
#include "render/sensor/color_noise.h"
#include "render/sensor/depth_noise.h"
#include "render/stage/person_actor.h"
#include "render/stage/robot_actor.h"
#include "say.h"

namespace marketgen::app {
namespace {

struct RenderFlags {
  CommonFlags common;
  CameraFlags camera;
  std::string folder, output, mode = "sensor", quality = "balanced", depth, segmentation,
                              object_ids, annotations, categories, normals, channels, noise, skin,
                              denoise = "auto";
  std::vector<std::string> robots;
  std::uint64_t frame_number = 0;
  double time_s = 0, exposure_stops = 0, people_at_s = 0;
  int samples = 0, people = 0;
  bool list = false;
};

Result<void> write_depth(const std::filesystem::path& path, const render::Frame& frame) {
  if (path.extension() == ".npy")
    return io::write_npy(path, frame.depth_m, {frame.color.height, frame.color.width});
  return io::write_png16(
      path, frame.color.width, frame.color.height, render::depth_in_mm(frame.depth_m));
}

Result<render::NoisyPlanes> noisy_planes(const RenderFlags& flags,
                                         const render::Frame& frame,
                                         const render::Camera& camera) {
  const render::NoiseSource source{flags.common.seed, flags.frame_number};
  MARKETGEN_TRY(std::vector<float> depth_m,
                render::noisy_depth(frame, camera, render::StereoCamera{}, source));
  return render::NoisyPlanes{
      render::noisy_color(frame.color, camera, render::ColorSensor{}, source), std::move(depth_m)};
}

Result<void> write_channels(const RenderFlags& flags,
                            const scene::Scene& scene,
                            const render::Frame& frame,
                            const render::Camera& camera,
                            const render::PictureAnnotations& annotations,
                            io::Outputs& outputs) {
  MARKETGEN_TRY(const render::NoisyPlanes noisy, noisy_planes(flags, frame, camera));
  const auto put = [&](const std::string& name, const Image& image) {
    return outputs.put(std::filesystem::path(flags.channels) / (name + ".png"),
                       [&](const auto& file) { return io::write_png(file, image); });
  };
  const auto channels = render::channel_pictures(frame, scene, annotations, noisy);
  for (const render::ChannelPicture& channel : channels)
    MARKETGEN_CHECK(put(channel.name, channel.image));
  return put("sheet", render::channel_sheet(channels));
}

bool wants_exr(const RenderFlags& flags) {
  return lower_ascii(std::filesystem::path(flags.output).extension().string()) == ".exr";
}

Result<void> put_picture(const RenderFlags& flags,
                         const render::Frame& frame,
                         io::Outputs& outputs) {
  return outputs.put(flags.output, [&](const std::filesystem::path& file) {
    if (!wants_exr(flags)) return io::write_picture(file, frame.color);
    return io::write_exr(file, {frame.color.width, frame.color.height, frame.radiance});
  });
}

// Before the work: every name says a format that its file can have. Numbers would not survive JPEG.
Result<void> check_endings(const RenderFlags& flags) {
  MARKETGEN_CHECK(io::check_ending(flags.output, {".png", ".jpg", ".jpeg", ".exr"}, "-o"));
  MARKETGEN_CHECK(io::check_ending(flags.depth, {".png", ".npy"}, "--depth"));
  MARKETGEN_CHECK(io::check_ending(flags.segmentation, {".png"}, "--segmentation"));
  MARKETGEN_CHECK(io::check_ending(flags.object_ids, {".png"}, "--object-ids"));
  MARKETGEN_CHECK(io::check_ending(flags.normals, {".png"}, "--normals"));
  MARKETGEN_CHECK(io::check_ending(flags.categories, {".png"}, "--categories"));
  return io::check_ending(flags.annotations, {".json"}, "--annotations");
}

Result<void> put_planes(const RenderFlags& flags,
                        const render::Frame& frame,
                        io::Outputs& outputs) {
  const int width = frame.color.width, height = frame.color.height;
  const auto put = [&](const std::string& name, const auto& draw) -> Result<void> {
    if (name.empty()) return {};
    return outputs.put(name, [&](const auto& file) { return io::write_png(file, draw()); });
  };
  if (!flags.depth.empty())
    MARKETGEN_CHECK(
        outputs.put(flags.depth, [&](const auto& file) { return write_depth(file, frame); }));
  MARKETGEN_CHECK(
      put(flags.segmentation, [&] { return render::draw_instances(frame, width, height); }));
  MARKETGEN_CHECK(put(flags.object_ids, [&] { return render::draw_object_ids(frame); }));
  return put(flags.normals, [&] { return render::draw_normals(frame, width, height); });
}

// Everything that will be written, before any work.
Result<void> probe(const RenderFlags& flags, io::Outputs& outputs) {
  MARKETGEN_CHECK(outputs.add({{"--output", flags.output},
                               {"--depth", flags.depth},
                               {"--segmentation", flags.segmentation},
                               {"--object-ids", flags.object_ids},
                               {"--annotations", flags.annotations},
                               {"--categories", flags.categories},
                               {"--normals", flags.normals}}));
  return flags.channels.empty() ? Result<void>{} : outputs.add_folder(flags.channels);
}

render::RenderOptions options_of(const RenderFlags& flags, const render::Camera& camera) {
  render::RenderOptions options;
  options.mode = value_named<render::RenderMode>(flags.mode).value_or(render::RenderMode::sensor);
  options.quality = value_named<render::Quality>(flags.quality).value_or(render::Quality::balanced);
  options.samples = flags.samples;
  options.time_s = flags.time_s;
  options.denoiser =
      value_named<render::Denoiser>(flags.denoise).value_or(render::Denoiser::automatic);
  options.exposure_stops = flags.exposure_stops;
  options.hide_ceiling = camera.ortho_height_m > 0;
  return options;
}

// The picture, its planes and its annotations.
Result<void> write_all(const RenderFlags& flags,
                       const scene::Scene& scene,
                       const render::Camera& camera,
                       const render::Renderer& renderer,
                       const std::vector<render::Actor>& actors,
                       render::Frame frame,
                       io::Outputs& outputs) {
  const std::vector<render::PictureActor> named = render::picture_actors(actors);
  if (!flags.categories.empty()) {
    const render::PictureCategories categories(scene, render::categories_of(named));
    MARKETGEN_CHECK(outputs.put(flags.categories, [&](const auto& file) {
      return io::write_png16(
          file, frame.color.width, frame.color.height, render::category_ids(frame, categories));
    }));
  }
  if (!flags.annotations.empty() || !flags.channels.empty()) {
    const render::PictureAnnotations annotations =
        render::annotate(frame, camera, scene, renderer, named);
    if (!flags.annotations.empty())
      MARKETGEN_CHECK(outputs.put(flags.annotations, io::write_json(annotations)));
    if (!flags.channels.empty())
      MARKETGEN_CHECK(write_channels(flags, scene, frame, camera, annotations, outputs));
  }
  if (!flags.noise.empty()) {
    MARKETGEN_TRY(render::NoisyPlanes noisy, noisy_planes(flags, frame, camera));
    frame.color = std::move(noisy.color);
    frame.depth_m = std::move(noisy.depth_m);
  }
  MARKETGEN_CHECK(put_picture(flags, frame, outputs));
  MARKETGEN_CHECK(put_planes(flags, frame, outputs));
  return outputs.commit();
}

// Robots, then people.
Result<std::vector<render::Actor>> actors_of(const RenderFlags& flags, const scene::Scene& scene) {
  MARKETGEN_TRY(const std::vector<robots::PlacedRobot> robots,
                collect::standing_robots(scene, flags.robots, "--robot "));
  MARKETGEN_TRY(std::vector<render::Actor> actors, render::robot_actors(robots));
  MARKETGEN_TRY(const collect::StorePeople people,
                collect::StorePeople::make(scene, flags.people, collect::people_seed(scene)));
  for (render::Actor& person : render::person_actors(people.at(flags.people_at_s),
                                                     render::detail_of_company(people.count())))
    actors.push_back(std::move(person));
  return actors;
}

Result<void> render(const RenderFlags& flags) {
  const ThreadLimit limit(flags.common.threads);
  MARKETGEN_TRY(const scene::Scene scene, scene_in_skin(flags.folder, flags.skin));
  if (flags.list) {
    for (const render::Camera& camera : render::standard_cameras(scene, 16, 9))
      say("{}\n", camera.name);
    return {};
  }
  if (flags.output.empty())
    return Error{"usage.bad_flag", "-o", "say where the picture goes: -o picture.png"};
  MARKETGEN_CHECK(check_endings(flags));
  if (wants_exr(flags) && flags.mode != "path")
    return Error{"usage.bad_flag", "-o", "linear light (EXR) is what --mode path draws"};
  io::Outputs outputs;
  MARKETGEN_CHECK(probe(flags, outputs));
  MARKETGEN_TRY(const render::Camera camera, camera_of(flags.camera, scene));
  if ((!flags.noise.empty() || !flags.channels.empty()) && camera.ortho_height_m > 0)
    return Error{"usage.bad_flag",
                 flags.noise.empty() ? "--channels" : "--noise",
                 "views from above are orthographic and have no sensor; take another camera"};
  MARKETGEN_TRY(const std::vector<render::Actor> actors, actors_of(flags, scene));
  Progress& progress = progress_for(flags.common);
  MARKETGEN_TRY(const std::unique_ptr<render::Renderer> renderer,
                render::Renderer::create(scene, progress, {.keep_light = true}));
  MARKETGEN_CHECK(renderer->set_actors(actors));
  MARKETGEN_TRY(render::Frame frame, renderer->render(camera, options_of(flags, camera), progress));
  MARKETGEN_CHECK(write_all(flags, scene, camera, *renderer, actors, std::move(frame), outputs));
  if (!flags.common.quiet) say("picture     {}\n", flags.output);
  return {};
}

void add_drawing_flags(CLI::App& command, RenderFlags& flags) {
  command
      .add_option("--mode",
                  flags.mode,
                  "sensor: a tenth of a second, without noise; path: full light transport")
      ->check(CLI::IsMember({"sensor", "path"}))
      ->capture_default_str();
  command.add_option("--quality", flags.quality, "fast, balanced or best")
      ->check(CLI::IsMember({"fast", "balanced", "best"}))
      ->capture_default_str();
  command.add_option("--spp", flags.samples, "samples a pixel; 0 = what the quality says")
      ->check(whole_number(0, 65536));
  command.add_option("--time", flags.time_s, "path mode: stop after this many seconds")
      ->check(real_number(0, 1e6));
  command.add_option("--denoise", flags.denoise, "path mode: auto, own, neural or none")
      ->check(CLI::IsMember({"auto", "own", "neural", "none"}))
      ->capture_default_str();
  command
      .add_option("--exposure", flags.exposure_stops, "path mode: stops brighter (+) or darker (-)")
      ->check(real_number(-10, 10));
}

// What is written beside the picture.
void add_plane_flags(CLI::App& command, RenderFlags& flags) {
  add_output(command,
             "--depth",
             flags.depth,
             "also write depth: F.png in whole millimetres, 16 bits; F.npy in metres, float32");
  add_output(command, "--segmentation", flags.segmentation, "also write a colour per object");
  add_output(command,
             "--object-ids",
             flags.object_ids,
             "also write object numbers: red + 256 green + 65536 blue");
  add_output(
      command,
      "--annotations",
      flags.annotations,
      "also write what is to be seen: boxes, masks, poses, the camera, as JSON (docs/cameras.md)");
  add_output(command, "--categories", flags.categories, "also write category numbers, 16-bit PNG");
  add_output(command, "--normals", flags.normals, "also write normals");
  add_output(command,
             "--channels",
             flags.channels,
             "also write every channel as a picture, into this folder");
  command
      .add_option("--noise",
                  flags.noise,
                  "colour and --depth as this sensor records them; drawn from --seed and --frame")
      ->check(CLI::IsMember({"d435"}));
  command.add_option("--frame", flags.frame_number, "number of the picture, for --noise")
      ->check(whole_number(0, any_seed))
      ->capture_default_str();
}

}  // namespace

Run add_render(CLI::App& app) {
  auto flags = std::make_shared<RenderFlags>();
  CLI::App* command = app.add_subcommand("render", "Draw a picture of a store");
  command->add_option("folder", flags->folder, "store folder")->type_name("STORE")->required();
  add_output(*command,
             "-o,--output",
             flags->output,
             "PNG or JPEG file; EXR (--mode path): linear light in cd/m2");
  add_camera_flags(*command, flags->camera);
  command->add_flag("--list-cameras", flags->list, "print the standard views and stop");
  add_drawing_flags(*command, *flags);
  command->add_option("--skin", flags->skin, "draw the store in the look of this style")
      ->type_name("STYLE");
  command
      ->add_option("--robot",
                   flags->robots,
                   "put a robot into the picture (repeatable): "
                   "ROW@X,Y[,HEADING_DEG][,z=M][,posture=NAME][,JOINT=VALUE][,SLOT=TOOL]")
      ->type_name("ROBOT")
      ->allow_extra_args(false);
  command
      ->add_option("--people",
                   flags->people,
                   "put so many shoppers and staff into the picture (docs/people.md)")
      ->check(whole_number(0, collect::max_people));
  command->add_option("--people-at", flags->people_at_s, "seconds after they began their rounds")
      ->check(real_number(0, 1e6));
  add_plane_flags(*command, *flags);
  add_common_flags(*command, flags->common, Takes::seed);
  command->footer(
      "Example:  marketgen render shop --camera aisle -o aisle.png --depth aisle-depth.png\n"
      "          marketgen render shop --camera aisle --mode path -o aisle.exr\n"
      "          marketgen render shop --camera aisle -o robot.png "
      "--robot realman-rm65@4.2,3.1,90,posture=stow,lift=0.3\n"
      "          marketgen render shop --camera aisle --mode path -o shoppers.png --people 8");
  return [flags] {
    const auto done = render(*flags);
    return done.ok() ? 0 : fail(done.error());
  };
}

}  // namespace marketgen::app
