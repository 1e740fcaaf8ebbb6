// marketgen pick: a robot takes one product off its shelf in physics; what became of it, and a
// strip of pictures.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/parallel.h"
#include "base/text.h"
#include "collect/collect_run.h"
#include "command.h"
#include "io/file.h"
#include "io/json.h"
#include "io/output.h"
#include "io/picture_file.h"
#include "number_flags.h"
#include "render/picture_grid.h"
#include "render/render.h"
#include "render/stage/robot_actor.h"
#include "robots/robot_row.h"
#include "say.h"

namespace marketgen::app {
namespace {

struct PickFlags {
  CommonFlags common;
  std::string folder, product, robot = "realman-rm75", output;
  int frames = 6, size_px = 400;
};

struct PickReport {
  std::string product, sku, robot, strategy;
  collect::CollectResult result;
  static constexpr auto fields =
      field_list(field("product", &PickReport::product, "item id"),
                 field("sku", &PickReport::sku, "SKU"),
                 field("robot", &PickReport::robot, "row in data/robots"),
                 field("strategy", &PickReport::strategy, "how it takes hold"),
                 field("result", &PickReport::result, "what became of it"));
};

// A moment of the run, to be drawn later.
struct Moment {
  collect::CollectPhase phase;
  std::vector<double> q;
  std::vector<std::pair<std::uint32_t, Pose>> moved;
};

// The item with this id; or every item of this SKU, front ones first.
Result<std::vector<std::uint32_t>> items_named(const scene::Scene& scene, const std::string& name) {
  std::vector<std::uint32_t> rows;
  std::vector<std::string_view> skus;
  for (const catalog::Product& product : scene.catalog)
    skus.push_back(product.sku);
  for (std::uint32_t row = 0; row < scene.products.size(); ++row) {
    if (scene.catalog[scene.products[row].sku].sku == name) rows.push_back(row);
    if (name.find('/') != std::string::npos && scene::product_id(scene, row) == name)
      return std::vector{row};
  }
  if (rows.empty())
    return Error{
        "collect.no_product",
        name,
        fmt::format("the store has no item with this id and none of this SKU{}; `marketgen "
                    "query STORE products` lists them",
                    did_you_mean(name, skus))};
  std::stable_partition(rows.begin(), rows.end(), [&](std::uint32_t row) {
    return (scene.products[row].flags & scene::product_front_row) != 0;
  });
  return rows;
}

// The first of the items for which there is a plan.
Result<collect::CollectPlan> plan_first(const scene::Scene& scene,
                                        const std::vector<std::uint32_t>& rows,
                                        const robots::Robot& robot,
                                        const std::filesystem::path& data,
                                        Seed seed) {
  MARKETGEN_TRY(const std::string row, collect::gripper_row(robot));
  MARKETGEN_TRY(const robots::GraspTool tool, robots::load_grasp_tool(data, row));
  constexpr std::size_t max_tried = 24;
  Error first;
  for (std::size_t i = 0; i < std::min(rows.size(), max_tried); ++i) {
    auto plan = collect::plan_collect(scene, rows[i], robot, tool, seed);
    if (plan.ok()) return plan;
    if (i == 0) first = plan.error();
  }
  return first;
}

scene::Scene scene_at_moment(const scene::Scene& scene, const Moment& moment) {
  scene::Scene now = scene;
  for (const auto& [row, pose] : moment.moved)
    scene::place(now.products[row], pose);
  return now;
}

// From the side of the arm, a little above the product.
render::Camera camera_beside(const scene::Scene& scene,
                             const collect::CollectPlan& plan,
                             int size_px) {
  const Pose product = scene::world_from_product(scene.products[plan.product]);
  const Vec3 out = rotate(product.rotation, {0, -1, 0}), side{out.y, -out.x, 0};
  const Vec3 at = product.position + out * 0.30 + Vec3{0, 0, 0.02};
  return {"beside", at + out * 0.75 + side * 1.05 + Vec3{0, 0, 0.35}, at, 50, 0, size_px, size_px};
}

Result<Image> draw_moment(const PickFlags& flags,
                          const scene::Scene& scene,
                          const robots::Robot& robot,
                          const collect::CollectPlan& plan,
                          const Moment& moment) {
  const scene::Scene now = scene_at_moment(scene, moment);
  MARKETGEN_TRY(const std::unique_ptr<render::Renderer> renderer, render::Renderer::create(now));
  MARKETGEN_TRY(const render::Actor actor,
                render::robot_actor(robot, moment.q, plan.world_from_base));
  MARKETGEN_CHECK(renderer->set_actors({actor}));
  render::RenderOptions options;
  options.quality = render::Quality::best;
  MARKETGEN_TRY(render::Frame frame,
                renderer->render(camera_beside(scene, plan, flags.size_px), options));
  return std::move(frame.color);
}

Result<void> write_strip(const PickFlags& flags,
                         const scene::Scene& scene,
                         const robots::Robot& robot,
                         const collect::CollectPlan& plan,
                         const std::vector<Moment>& moments,
                         io::Outputs& outputs) {
  const auto count = std::min(static_cast<std::size_t>(flags.frames), moments.size());
  MARKETGEN_TRY(const Image strip, render::picture_grid(count, flags.size_px, [&](std::size_t i) {
                  const std::size_t at = count < 2 ? 0 : i * (moments.size() - 1) / (count - 1);
                  return draw_moment(flags, scene, robot, plan, moments[at]);
                }));
  MARKETGEN_CHECK(
      outputs.put(flags.output, [&](const auto& file) { return io::write_picture(file, strip); }));
  MARKETGEN_CHECK(outputs.commit());
  if (!flags.common.quiet) say("picture     {}\n", flags.output);
  return {};
}

void print_report(const PickReport& report) {
  const collect::CollectResult& r = report.result;
  say("{}  {}  by {}, {} grasp\n",
      r.held ? "held" : "lost",
      report.product,
      report.robot,
      report.strategy);
  say("raised {:.0f} mm, slipped {:.1f} mm, pressed with {:.0f} N; neighbours: {} moved, {} "
      "toppled; {:.1f} s\n",
      r.raised_m * 1e3,
      r.slip_m * 1e3,
      r.squeeze_n,
      r.neighbours_moved,
      r.neighbours_toppled,
      r.time_s);
}

Result<void> pick(const PickFlags& flags) {
  const ThreadLimit limit(flags.common.threads);
  MARKETGEN_CHECK(io::check_picture_ending(flags.output, "-o"));
  io::Outputs outputs;
  MARKETGEN_CHECK(outputs.add({{"--output", flags.output}}));
  MARKETGEN_TRY(const scene::Scene scene, scene_in_skin(flags.folder, ""));
  MARKETGEN_TRY(const std::vector<std::uint32_t> rows, items_named(scene, flags.product));
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  MARKETGEN_TRY(const robots::Robot robot, robots::load_robot(data, flags.robot));
  MARKETGEN_TRY(const catalog::Catalog catalog, load_rows());
  MARKETGEN_TRY(const collect::CollectPlan plan,
                plan_first(scene, rows, robot, data, Seed(flags.common.seed)));
  std::vector<Moment> moments;
  const collect::CollectWatch watch = [&](const physics::World& world,
                                          const physics::RobotActor& actor,
                                          collect::CollectPhase phase) {
    Moment moment{phase, actor.position(world), {}};
    for (const std::uint32_t row : world.moved_products())
      moment.moved.emplace_back(row, world.product_pose(row));
    moments.push_back(std::move(moment));
    return Result<void>{};
  };
  PickReport report{scene::product_id(scene, plan.product),
                    scene.catalog[scene.products[plan.product].sku].sku,
                    robot.name,
                    std::string(name_of(plan.grasp.strategy)),
                    {}};
  MARKETGEN_TRY(report.result, collect::run_collect(scene, robot, plan, catalog.frictions, watch));
  if (flags.common.json)
    fmt::print("{}", io::write_json(report));
  else if (!flags.common.quiet)
    print_report(report);
  return flags.output.empty() ? Result<void>{}
                              : write_strip(flags, scene, robot, plan, moments, outputs);
}

}  // namespace

Run add_pick(CLI::App& app) {
  auto flags = std::make_shared<PickFlags>();
  CLI::App* command =
      app.add_subcommand("pick", "Let a robot take one product off its shelf, in physics");
  command->add_option("folder", flags->folder, "store folder")->type_name("STORE")->required();
  command->add_option("product", flags->product, "item id, or a SKU: its first item within reach")
      ->type_name("PRODUCT")
      ->required();
  command->add_option("--robot", flags->robot, "row in data/robots")
      ->type_name("ROBOT")
      ->capture_default_str();
  add_output(*command, "-o,--output", flags->output, "PNG or JPEG file for a strip of pictures");
  command->add_option("--frames", flags->frames, "pictures in the strip")
      ->check(whole_number(1, 64))
      ->capture_default_str();
  command->add_option("--size", flags->size_px, "pixels of each, a side")
      ->check(whole_number(64, 1024))
      ->capture_default_str();
  add_common_flags(*command, flags->common, Takes::seed_and_json);
  command->footer(
      "Example:  marketgen pick shop canned-tuna-chunks-150g --robot realman-rm75 -o pick.png");
  return [flags] {
    const auto done = pick(*flags);
    return done.ok() ? 0 : fail(done.error());
  };
}

}  // namespace marketgen::app
