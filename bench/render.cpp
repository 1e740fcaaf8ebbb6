#include "render/render.h"
#include "bench/bench.h"
#include "bench/sample_store.h"
#include "io/file.h"
#include "render/robot_actor.h"
#include "robots/placed_robot.h"
#include "scene/scene_file.h"

namespace marketgen::bench {
namespace {

constexpr int robot_runs = 15;

Figure seconds_figure(const std::string& name, double seconds, int runs) {
  return {name, seconds, "s", runs, std::nullopt, std::nullopt, machine_name()};
}

// A dual-arm robot in the room: put into it, moved, and drawn in the aisle's view.
Figures with_robot(Renderer& renderer, const Camera& camera) {
  MARKETGEN_TRY(const std::filesystem::path data, data_folder());
  RobotSpec spec;
  spec.row = "realman-rm65";
  spec.position = camera.at;
  spec.position.z = 0;
  MARKETGEN_TRY(const PlacedRobot placed, place_robot(data, spec, spec.row));
  MARKETGEN_TRY(const Actor actor, robot_actor(placed.robot, placed.q, placed.world_from_base));
  const double set_s = median_seconds(robot_runs, [&] { (void)renderer.set_actors({actor}).ok(); });
  const std::vector<Pose> poses = world_link_poses(placed.robot, placed.q, placed.world_from_base);
  const double move_s =
      median_seconds(robot_runs, [&] { (void)renderer.move_actor(0, poses).ok(); });
  constexpr int pictures = 5;
  const double picture_s =
      median_seconds(pictures, [&] { (void)renderer.render(camera, {}).ok(); });
  return std::vector<Figure>{
      seconds_figure("robot_set_s", set_s, robot_runs),
      seconds_figure("robot_move_s", move_s, robot_runs),
      seconds_figure("render_640x480_balanced_robot_s", picture_s, pictures)};
}

}  // namespace

Figures run_render(const Catalog& catalog) {
  const ScratchFolder scratch;
  MARKETGEN_TRY(const Created created,
                create_store(neighbourhood_store(scratch / "store", false), catalog));
  MARKETGEN_TRY(const Scene scene, open_scene(scratch / "store" / "scene.bin"));
  const double create_s = median_seconds(3, [&] { (void)Renderer::create(scene).ok(); });
  MARKETGEN_TRY(const std::unique_ptr<Renderer> renderer, Renderer::create(scene));

  std::vector<Figure> figures{
      {"renderer_create_s", create_s, "s", 3, std::nullopt, std::nullopt, machine_name()}};
  for (const Quality quality : {Quality::fast, Quality::balanced, Quality::best}) {
    MARKETGEN_TRY(const Camera camera, camera_named(scene, "aisle", 640, 480));
    RenderOptions options;
    options.quality = quality;
    constexpr int runs = 5;
    const double seconds =
        median_seconds(runs, [&] { (void)renderer->render(camera, options).ok(); });
    figures.push_back({"render_640x480_" + std::string(name_of(quality)) + "_s",
                       seconds,
                       "s",
                       runs,
                       std::nullopt,
                       std::nullopt,
                       machine_name()});
  }
  MARKETGEN_TRY(const Camera camera, camera_named(scene, "aisle", 640, 480));
  MARKETGEN_TRY(const std::vector<Figure> robot, with_robot(*renderer, camera));
  figures.insert(figures.end(), robot.begin(), robot.end());
  return figures;
}

}  // namespace marketgen::bench
