// The physics bubble in a whole store, beside the same bubble in an empty room.
#include "physics/world/world.h"

#include <malloc.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <optional>

#include "bench/bench.h"
#include "bench/sample_store.h"
#include "physics/settle/settle.h"
#include "scene/placements.h"
#include "scene/scene_file.h"

namespace marketgen::bench {
namespace {

constexpr std::uint32_t awake = 20;
constexpr int rounds = 7, steps = 500, keep_awake_steps = 10;
constexpr double step_s = 0.002;
constexpr int links = 7;
constexpr double arm_z_m = 0.1, link_m = 0.12;

// An arm of seven driven joints that stands by itself and moves the whole time.
Result<void> add_arm(mjSpec& spec, double x_m, double y_m) {
  mjsBody* parent = mjs_findBody(&spec, "world");
  for (int i = 0; i < links; ++i) {
    mjsBody* link = mjs_addBody(parent, nullptr);
    link->pos[0] = i == 0 ? x_m : 0, link->pos[1] = i == 0 ? y_m : 0;
    link->pos[2] = i == 0 ? arm_z_m : link_m;
    mjsJoint* joint = mjs_addJoint(link, nullptr);
    const std::string name = "arm-" + std::to_string(i);
    mjs_setName(joint->element, name.c_str());
    joint->type = mjJNT_HINGE;
    joint->axis[0] = i % 2, joint->axis[1] = 0, joint->axis[2] = (i + 1) % 2;
    joint->damping[0] = 1;
    mjsGeom* geom = mjs_addGeom(link, nullptr);
    geom->type = mjGEOM_CAPSULE;
    geom->size[0] = 0.03, geom->size[1] = link_m / 2 - 0.03;
    geom->pos[2] = link_m / 2;
    mjsActuator* motor = mjs_addActuator(&spec, nullptr);
    mjs_setName(motor->element, name.c_str());
    mjs_setString(motor->target, name.c_str());
    motor->trntype = mjTRN_JOINT;
    parent = link;
  }
  return {};
}

physics::WorldOptions with_arm(const scene::Scene& scene, const catalog::Catalog& catalog) {
  physics::WorldOptions options;
  options.frictions = catalog.frictions;
  const PolygonMm& aisle = scene.layout.aisles.front().polygon_mm;
  double x = 0, y = 0;  // middle of its corners
  for (const auto& corner : aisle)
    x += corner[0] / 1000.0 / double(aisle.size()), y += corner[1] / 1000.0 / double(aisle.size());
  options.add_actors = [=](mjSpec& spec) { return add_arm(spec, x, y); };
  return options;
}

// Products far apart that stand by themselves, so that none wakes another. Of the region alone when
// there is one.
std::vector<std::uint32_t> spread(const scene::Scene& scene,
                                  const std::optional<std::array<double, 4>>& region_m) {
  std::vector<std::uint32_t> there;
  for (std::uint32_t row = 0; row < scene.products.size(); ++row) {
    const scene::SceneProduct& item = scene.products[row];
    const double x = item.position_m[0], y = item.position_m[1];
    const bool in = !region_m || (x > (*region_m)[0] && x < (*region_m)[2] && y > (*region_m)[1] &&
                                  y < (*region_m)[3]);
    if (in && scene.catalog[item.sku].category != "produce") there.push_back(row);
  }
  std::vector<std::uint32_t> rows;
  for (std::uint32_t i = 0; i < awake; ++i)
    rows.push_back(there[i * there.size() / awake]);
  return rows;
}

// The same goods in the same room with nothing else in it, each on a board of its own.
scene::Scene empty_room(const scene::Scene& scene, const std::vector<std::uint32_t>& products) {
  constexpr float board_m = 0.3F, board_half_m = 0.01F, apart_m = 0.8F;
  scene::Scene bare = scene;
  bare.fixtures.assign(1, {}), bare.parts.clear(), bare.joints.clear(), bare.shelves.clear();
  bare.facings.clear(), bare.products.clear();
  float x = 1;
  for (const std::uint32_t product : products) {
    scene::ScenePart board;
    board.position_m = {x, 1, 1 - board_half_m};
    board.half_size_m = {board_m, board_m, board_half_m};
    bare.parts.push_back(board);
    scene::SceneProduct item = scene.products[product];
    item.facing = scene::no_facing;
    item.position_m = {x, 1, 1};
    x += apart_m;
    bare.products.push_back(item);
  }
  bare.fixtures[0].part_count = awake;
  return bare;
}

// Seconds a step, once for each round, while `products` are kept awake and the arm moves.
Result<double> round_seconds(physics::World& world,
                             const std::vector<std::uint32_t>& products,
                             int round) {
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < steps; i += keep_awake_steps) {
    for (const std::uint32_t product : products)
      MARKETGEN_CHECK(world.push(product, {}));
    for (int joint = 0; joint < links; ++joint)
      MARKETGEN_CHECK(world.set_control(joint, ((i / 100 + round + joint) % 2 == 0) ? 0.5 : -0.5));
    MARKETGEN_CHECK(world.step(keep_awake_steps));
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / steps;
}

struct StepTimes {
  double in_store_s = 0, in_empty_s = 0;  // medians over the rounds
  int awake = 0;
};

// In turn, so that both meet the same noise.
Result<StepTimes> steps_beside_empty_room(const scene::Scene& scene,
                                          const physics::WorldOptions& options) {
  const std::vector<std::uint32_t> chosen = spread(scene, options.region_m);
  const scene::Scene bare = empty_room(scene, chosen);
  std::vector<std::uint32_t> in_bare(awake);
  std::iota(in_bare.begin(), in_bare.end(), 0U);
  physics::WorldOptions everywhere = options;
  everywhere.region_m = {};
  MARKETGEN_TRY(physics::World world, physics::World::create(scene, options));
  MARKETGEN_TRY(physics::World empty, physics::World::create(bare, everywhere));
  std::vector<double> in_store_s, in_empty_s;
  for (int round = 0; round < rounds; ++round) {
    MARKETGEN_TRY(const double store_s, round_seconds(world, chosen, round));
    MARKETGEN_TRY(const double empty_s, round_seconds(empty, in_bare, round));
    in_store_s.push_back(store_s), in_empty_s.push_back(empty_s);
  }
  return StepTimes{median(in_store_s), median(in_empty_s), world.counts().in_pool};
}

Figure step_figure(std::string name, const StepTimes& times) {
  return {std::move(name),
          1e6 * times.in_store_s,
          "us",
          rounds,
          "the same arm and goods, each on a board, in an empty room",
          times.in_store_s / times.in_empty_s,
          machine_name()};
}

}  // namespace

Figures run_world(const catalog::Catalog& catalog) {
  const ScratchFolder scratch;
  MARKETGEN_TRY(const store::Created created,
                store::create_store(neighbourhood_store(scratch / "store", false), catalog));
  MARKETGEN_TRY(const scene::Scene scene, scene::open_scene(scratch / "store" / "scene.bin"));
  const physics::WorldOptions options = with_arm(scene, catalog);
  physics::WorldOptions sector = options;
  sector.region_m = physics::region_around_aisle(scene, 2000);

  malloc_trim(0);  // what earlier benchmarks have freed would be used again
  const double before_mb = resident_mb();
  double world_mb = 0;
  {
    MARKETGEN_TRY(const physics::World world, physics::World::create(scene, options));
    world_mb = resident_mb() - before_mb;
  }
  MARKETGEN_TRY(const StepTimes whole, steps_beside_empty_room(scene, options));
  MARKETGEN_TRY(const StepTimes part, steps_beside_empty_room(scene, sector));
  const double build_s =
      median_seconds(3, [&] { (void)physics::World::create(scene, options).ok(); });
  const double sector_s =
      median_seconds(3, [&] { (void)physics::World::create(scene, sector).ok(); });

  const std::string machine = machine_name();
  const auto figure = [&](std::string name, double value, std::string unit, int n) {
    return Figure{std::move(name), value, std::move(unit), n, {}, {}, machine};
  };
  return std::vector<Figure>{
      step_figure("world_step_arm_20_awake", whole),
      step_figure("world_step_sector_arm_20_awake", part),
      figure("world_times_real_time", step_s / whole.in_store_s, "s/s", rounds),
      figure("world_awake", whole.awake, "products", 1),
      figure("world_products", static_cast<double>(scene.products.size()), "products", 1),
      figure("world_build", build_s, "s", 3),
      figure("world_build_sector", sector_s, "s", 3),
      figure("world_memory", world_mb, "MB", 1)};
}

}  // namespace marketgen::bench
