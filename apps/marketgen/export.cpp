// marketgen export: a store in another program's format.
#include "export/export.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/parallel.h"
#include "base/text.h"
#include "camera_flags.h"
#include "collect/standing_robot.h"
#include "command.h"
#include "io/json.h"
#include "io/output.h"
#include "named_flag.h"
#include "say.h"

namespace marketgen::app {
namespace {

struct ExportFlags {
  CommonFlags common;
  std::string folder, format, output, free_region, skin;
  std::vector<std::string> robots;
  bool check = false, instanced = false, still = false, primitives = false;
  std::optional<double> resolution, robot_radius, robot_height, camera_spacing, camera_distance;
  std::vector<double> camera_heights;
  std::optional<std::string> size;
};

// A flag that says something of some formats alone is a slip beside others.
struct FormatFlag {
  const char* flag;
  bool given;
  std::vector<std::string_view> formats;
};

Result<void> check_formats(const ExportFlags& flags) {
  const auto& known = exporters::export_formats();
  if (std::ranges::none_of(known, [&](const auto& format) { return format.name == flags.format; }))
    return {};  // what is wrong then is the format
  const FormatFlag special[] = {
      {"--free-region", !flags.free_region.empty(), {"mjcf", "usd", "sdf"}},
      {"--instanced", flags.instanced, {"glb"}},
      {"--still-fixtures", flags.still, {"mjcf", "usd", "urdf", "sdf"}},
      {"--primitives", flags.primitives, {"mjcf"}},
      {"--robot", !flags.robots.empty(), {"mjcf"}},
      {"--resolution", flags.resolution.has_value(), {"nav2"}},
      {"--robot-radius", flags.robot_radius.has_value(), {"nav2", "coco"}},
      {"--robot-height", flags.robot_height.has_value(), {"nav2", "coco"}},
      {"--camera-spacing", flags.camera_spacing.has_value(), {"coco"}},
      {"--camera-distance", flags.camera_distance.has_value(), {"coco"}},
      {"--camera-height", !flags.camera_heights.empty(), {"coco"}},
      {"--size", flags.size.has_value(), {"coco"}}};
  for (const FormatFlag& flag : special) {
    if (flag.given && std::ranges::find(flag.formats, flags.format) == flag.formats.end())
      return Error{"usage.bad_flag",
                   flag.flag,
                   fmt::format("it is for --format {} only", fmt::join(flag.formats, ", "))};
  }
  return {};
}

Result<void> set_cameras(exporters::ExportOptions& options, const ExportFlags& flags) {
  options.camera_spacing_m = flags.camera_spacing.value_or(options.camera_spacing_m);
  options.camera_distance_m = flags.camera_distance.value_or(options.camera_distance_m);
  if (!flags.camera_heights.empty()) options.camera_heights_m = flags.camera_heights;
  if (!flags.size) return {};
  MARKETGEN_TRY(const auto pixels, picture_size(*flags.size));
  options.picture_px = {pixels.first, pixels.second};
  return {};
}

Result<std::array<double, 4>> parse_region(const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  std::array<double, 4> region{};
  bool good = parts.size() == 4;
  for (std::size_t i = 0; good && i < 4; ++i) {
    const auto [end, failed] =
        std::from_chars(parts[i].data(), parts[i].data() + parts[i].size(), region[i]);
    good = failed == std::errc() && end == parts[i].data() + parts[i].size() &&
           std::isfinite(region[i]);
  }
  if (!good || region[0] >= region[2] || region[1] >= region[3]) {
    return Error{
        "usage.bad_flag",
        "--free-region",
        fmt::format("\"{}\" is not a region; write x0,y0,x1,y1 in metres, west,south,east,north",
                    text)};
  }
  return region;
}

Result<void> run_export(const ExportFlags& flags) {
  const ThreadLimit limit(flags.common.threads);
  io::Outputs outputs;
  MARKETGEN_CHECK(check_formats(flags));
  MARKETGEN_CHECK(outputs.add({{"--output", flags.output}}));
  MARKETGEN_TRY(const scene::Scene scene, scene_in_skin(flags.folder, flags.skin));
  exporters::ExportOptions options;
  options.instanced = flags.instanced;
  options.still_fixtures = flags.still;
  options.looks = !flags.primitives;
  options.resolution_m = flags.resolution.value_or(options.resolution_m);
  options.robot_radius_m = flags.robot_radius.value_or(options.robot_radius_m);
  options.robot_height_m = flags.robot_height.value_or(options.robot_height_m);
  MARKETGEN_CHECK(set_cameras(options, flags));
  options.progress = &progress_for(flags.common);
  MARKETGEN_TRY(options.robots, collect::standing_robots(scene, flags.robots, "--robot "));
  if (!flags.free_region.empty()) {
    MARKETGEN_TRY(const auto region, parse_region(flags.free_region));
    options.free_region_m = region;
  }
  MARKETGEN_CHECK(exporters::export_scene(scene, flags.format, flags.output, options));
  if (!flags.check) {
    if (!flags.common.quiet) say("file        {}\n", flags.output);
    return {};
  }
  MARKETGEN_TRY(const exporters::ExportSummary summary,
                exporters::check_export(scene, flags.format, flags.output, options));
  if (flags.common.json)
    fmt::print("{}", io::write_json(summary));
  else
    say("file        {}\nread back   {}\n", flags.output, summary.in_words);
  return {};
}

// Of formats with fixtures and goods as bodies.
void add_model_flags(CLI::App& command, ExportFlags& flags) {
  command
      .add_option("--free-region",
                  flags.free_region,
                  "mjcf, usd, sdf: products in x0,y0,x1,y1 become free bodies")
      ->type_name("REGION");
  command.add_flag(
      "--instanced",
      flags.instanced,
      "glb: a node a SKU with EXT_mesh_gpu_instancing, which few viewers read; smaller "
      "and faster where they do");
  command.add_flag("--still-fixtures",
                   flags.still,
                   "mjcf, usd, urdf, sdf: doors, lids and drawers of fixtures do not move");
  command.add_flag(
      "--primitives",
      flags.primitives,
      "mjcf: contact primitives alone, in one file; no meshes and no pictures beside it");
  command
      .add_option(
          "--robot",
          flags.robots,
          "mjcf: put a robot in (repeatable): ROW@X,Y[,HEADING_DEG][,...] as `render` takes it")
      ->type_name("ROBOT")
      ->allow_extra_args(false);
}

// Of the robot that is to drive there.
void add_robot_size_flags(CLI::App& command, ExportFlags& flags) {
  command.add_option("--resolution",
                     flags.resolution,
                     "nav2: side of a map's cell in metres, 0.01 to 0.25 (0.05)");
  command.add_option("--robot-radius",
                     flags.robot_radius,
                     "nav2, coco: metres from the robot's middle that it keeps free (0.42)");
  command.add_option("--robot-height",
                     flags.robot_height,
                     "nav2, coco: metres over the floor; it passes under what hangs higher (2)");
}

// Of pictures along the shelves.
void add_camera_flags(CLI::App& command, ExportFlags& flags) {
  command.add_option("--camera-spacing",
                     flags.camera_spacing,
                     "coco: metres along the shelves from picture to picture, 0.05 to 10 (0.5)");
  command.add_option("--camera-distance",
                     flags.camera_distance,
                     "coco: metres before the shelves, or the nearest that the aisle allows (1)");
  command
      .add_option("--camera-height",
                  flags.camera_heights,
                  "coco: metres over the floor of a camera (repeatable; 0.6 and 1.5)")
      ->allow_extra_args(false);
  command.add_option("--size", flags.size, "coco: picture size in pixels (1280x720)")
      ->type_name("SIZE");
}

}  // namespace

Run add_export(CLI::App& app) {
  auto flags = std::make_shared<ExportFlags>();
  CLI::App* command = app.add_subcommand("export", "Write a store in another program's format");
  std::string formats;
  std::vector<std::string_view> names;
  for (const exporters::ExportFormat& format : exporters::export_formats()) {
    formats += fmt::format("\n  {:<10} {}", format.name, format.description);
    names.push_back(format.name);
  }
  command->add_option("folder", flags->folder, "store folder")->type_name("STORE")->required();
  command->add_option("--format", flags->format, "format, see below")
      ->type_name(choice_of(names))
      ->required();
  add_output(*command, "-o,--output", flags->output, "file to write")->required();
  add_model_flags(*command, *flags);
  add_robot_size_flags(*command, *flags);
  add_camera_flags(*command, *flags);
  command->add_option("--skin", flags->skin, "export the store in the look of this style")
      ->type_name("STYLE");
  command->add_flag("--check", flags->check, "read the file back and compare it with the store");
  add_common_flags(*command, flags->common, Takes::json);
  command->footer("Formats:" + formats +
                  "\nExample:  marketgen export shop --format glb -o shop.glb --check"
                  "\n          marketgen export shop --format mjcf -o shop.xml --robot "
                  "realman-rm75@4.2,3.1,90"
                  "\n          marketgen export shop --format usd -o shop.usda --check"
                  "\n          marketgen export shop --format urdf -o shop.urdf --check"
                  "\n          marketgen export shop --format sdf -o shop.sdf --check"
                  "\n          marketgen export shop --format nav2 -o shop.yaml --check"
                  "\n          marketgen export shop --format planogram -o planogram.csv --check"
                  "\n          marketgen export shop --format coco -o shelves.json --check");
  return [flags] {
    const auto done = run_export(*flags);
    return done.ok() ? 0 : fail(done.error());
  };
}

}  // namespace marketgen::app
