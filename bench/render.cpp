#include "render/render.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "bench/bench.h"
#include "bench/sample_store.h"
#include "io/file.h"
#include "render/stage/robot_actor.h"
#include "robots/placed_robot.h"
#include "scene/scene_file.h"

namespace marketgen::bench {
namespace {

constexpr int robot_runs = 15, picture_runs = 15;

Figure seconds_figure(const std::string& name, double seconds, int runs) {
  return {name, seconds, "s", runs, std::nullopt, std::nullopt, machine_name()};
}

// A dual-arm robot in the room: put into it, moved, and drawn in the aisle's view.
Figures with_robot(render::Renderer& renderer, const render::Camera& camera) {
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  robots::RobotSpec spec;
  spec.row = "realman-rm65";
  spec.position = camera.at;
  spec.position.z = 0;
  MARKETGEN_TRY(const robots::PlacedRobot placed, robots::place_robot(data, spec, spec.row));
  MARKETGEN_TRY(const render::Actor actor,
                render::robot_actor(placed.robot, placed.q, placed.world_from_base));
  const double set_s = median_seconds(robot_runs, [&] { (void)renderer.set_actors({actor}).ok(); });
  const std::vector<Pose> poses =
      render::world_link_poses(placed.robot, placed.q, placed.world_from_base);
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

// 64 cameras of 128 x 128 pixels side by side, colour and depth, as a batch of small worlds would
// ask for: images per second.
Figures small_cameras(render::Renderer& renderer, const scene::Scene& scene) {
  constexpr int side = 128;
  constexpr std::size_t count = 64, pixels = side * side;
  std::vector<std::uint8_t> rgb(3 * pixels * count);
  std::vector<float> depth(pixels * count);
  MARKETGEN_TRY(render::Camera camera, render::camera_named(scene, "aisle", side, side));
  std::vector<render::Shot> shots;
  for (std::size_t i = 0; i < count; ++i) {
    // Turned about on the spot: shelves, floor and the way down the aisle.
    render::Camera turned = camera;
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / count;
    turned.at = camera.from + Vec3{std::cos(angle), std::sin(angle), -0.3};
    shots.push_back(
        {&renderer, turned, {.rgb = &rgb[3 * pixels * i], .depth_m = &depth[pixels * i]}});
  }
  render::RenderOptions options;
  options.quality = render::Quality::fast;
  constexpr int runs = 9;
  const double seconds =
      median_seconds(runs, [&] { (void)render::render_batch(shots, options).ok(); });
  return std::vector<Figure>{{"render_64x128_fast_rgbd",
                              static_cast<double>(count) / seconds,
                              "images/s",
                              runs,
                              std::nullopt,
                              std::nullopt,
                              machine_name()}};
}

// 50 products moved at each picture, as those that a robot and its basket carry.
Figures with_moved_products(render::Renderer& renderer, const scene::Scene& scene) {
  std::vector<render::MovedProduct> moved;
  for (std::uint32_t i = 0; i < 50 && i < scene.products.size(); ++i)
    moved.push_back(
        {i * 7 % static_cast<std::uint32_t>(scene.products.size()), {{2 + 0.01 * i, 2, 1}, {}}});
  constexpr int runs = 15;
  (void)renderer.move_things(moved, {}).ok();
  const double follow_s = median_seconds(runs, [&] {
    for (render::MovedProduct& m : moved)
      m.world_from_product.position.z += 0.001;
    (void)renderer.move_things(moved, {}).ok();
  });
  const double change_s = median_seconds(runs, [&] {
    std::swap(moved.front(), moved.back());
    (void)renderer.move_things(moved, {}).ok();
  });
  MARKETGEN_CHECK(renderer.move_things({}, {}));
  return std::vector<Figure>{seconds_figure("move_50_products_s", follow_s, runs),
                             seconds_figure("move_50_other_products_s", change_s, runs)};
}

// From a store on disk to its first picture; all but the first time the baked light is there.
void draw_first_picture(const std::filesystem::path& store) {
  const Result<scene::Scene> scene = scene::open_scene(store / "scene.bin");
  if (!scene.ok()) return;
  const auto renderer = render::Renderer::create(*scene, silent_progress(), {.keep_light = true});
  const Result<render::Camera> camera = render::camera_named(*scene, "aisle", 640, 480);
  if (renderer.ok() && camera.ok())
    (void)(*renderer)->render(*camera, {.quality = render::Quality::fast}).ok();
}

struct StoreFrames {
  double seconds = 0;
  std::size_t products = 0;
};

// A fast picture of a store's aisle.
Result<StoreFrames> aisle_of(const store::CreateOptions& options, const catalog::Catalog& catalog) {
  MARKETGEN_TRY(const store::Created created, store::create_store(options, catalog));
  MARKETGEN_TRY(const scene::Scene scene, scene::open_scene(options.folder / "scene.bin"));
  MARKETGEN_TRY(const std::unique_ptr<render::Renderer> renderer, render::Renderer::create(scene));
  MARKETGEN_TRY(const render::Camera camera, render::camera_named(scene, "aisle", 640, 480));
  render::RenderOptions fast;
  fast.quality = render::Quality::fast;
  const double seconds =
      median_seconds(picture_runs, [&] { (void)renderer->render(camera, fast).ok(); });
  return StoreFrames{seconds, scene.products.size()};
}

// What ten times the goods cost: the same view of an aisle in a small and in a large store.
Figures with_more_products(const ScratchFolder& scratch, const catalog::Catalog& catalog) {
  store::CreateOptions small = neighbourhood_store(scratch / "small", false);
  small.brief.prompt =
      "A 16 x 11 m neighbourhood supermarket with produce by the entrance, dairy along the back "
      "wall and a checkout";
  store::CreateOptions large = large_store(scratch / "large");
  large.brief.prompt =
      "A 44 x 27 m supermarket with produce by the entrance, dairy along the back wall and six "
      "checkouts";
  MARKETGEN_TRY(const StoreFrames few, aisle_of(small, catalog));
  MARKETGEN_TRY(const StoreFrames many, aisle_of(large, catalog));
  return std::vector<Figure>{{"render_640x480_fast_many_products_s",
                              many.seconds,
                              "s",
                              picture_runs,
                              fmt::format("{} products instead of {}", few.products, many.products),
                              many.seconds / few.seconds,
                              machine_name()}};
}

}  // namespace

Figures run_render(const catalog::Catalog& catalog) {
  const ScratchFolder scratch;
  MARKETGEN_TRY(const store::Created created,
                store::create_store(neighbourhood_store(scratch / "store", false), catalog));
  MARKETGEN_TRY(const scene::Scene scene, scene::open_scene(scratch / "store" / "scene.bin"));
  const double create_s = median_seconds(3, [&] { (void)render::Renderer::create(scene).ok(); });
  MARKETGEN_TRY(const std::unique_ptr<render::Renderer> renderer, render::Renderer::create(scene));

  const double first_s = median_seconds(5, [&] { draw_first_picture(scratch / "store"); });
  std::vector<Figure> figures{seconds_figure("renderer_create_s", create_s, 3),
                              seconds_figure("first_picture_s", first_s, 5)};
  for (const render::Quality quality :
       {render::Quality::fast, render::Quality::balanced, render::Quality::best}) {
    MARKETGEN_TRY(const render::Camera camera, render::camera_named(scene, "aisle", 640, 480));
    render::RenderOptions options;
    options.quality = quality;
    const double seconds =
        median_seconds(picture_runs, [&] { (void)renderer->render(camera, options).ok(); });
    figures.push_back({"render_640x480_" + std::string(name_of(quality)) + "_s",
                       seconds,
                       "s",
                       picture_runs,
                       std::nullopt,
                       std::nullopt,
                       machine_name()});
  }
  MARKETGEN_TRY(const render::Camera camera, render::camera_named(scene, "aisle", 640, 480));
  MARKETGEN_TRY(const std::vector<Figure> robot, with_robot(*renderer, camera));
  figures.insert(figures.end(), robot.begin(), robot.end());
  MARKETGEN_TRY(const std::vector<Figure> small, small_cameras(*renderer, scene));
  figures.insert(figures.end(), small.begin(), small.end());
  MARKETGEN_TRY(const std::vector<Figure> moved, with_moved_products(*renderer, scene));
  figures.insert(figures.end(), moved.begin(), moved.end());
  MARKETGEN_TRY(const std::vector<Figure> more, with_more_products(scratch, catalog));
  figures.insert(figures.end(), more.begin(), more.end());
  return figures;
}

}  // namespace marketgen::bench
