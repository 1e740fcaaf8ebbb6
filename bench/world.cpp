// The physics bubble in a whole store, beside the same bubble in an empty room.
#include "physics/world.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <chrono>
#include <fstream>

#include "bench/bench.h"
#include "bench/sample_store.h"
#include "physics/settle.h"
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

WorldOptions with_arm(const Scene& scene, const Catalog& catalog) {
  WorldOptions options;
  options.frictions = catalog.frictions;
  const PolygonMm& aisle = scene.layout.aisles.front().polygon_mm;
  double x = 0, y = 0;  // middle of its corners
  for (const auto& corner : aisle)
    x += corner[0] / 1000.0 / double(aisle.size()), y += corner[1] / 1000.0 / double(aisle.size());
  options.add_actors = [=](mjSpec& spec) { return add_arm(spec, x, y); };
  return options;
}

// Products far apart that stand by themselves, so that none wakes another.
std::vector<std::uint32_t> spread(const Scene& scene) {
  std::vector<std::uint32_t> rows;
  const auto all = static_cast<std::uint32_t>(scene.products.size());
  for (std::uint32_t i = 0; i < awake; ++i) {
    std::uint32_t row = i * (all / awake);
    while (row + 1 < all && scene.catalog[scene.products[row].sku].category == "produce")
      ++row;
    rows.push_back(row);
  }
  return rows;
}

// The same goods on the floor of the same room with nothing else in it.
Scene empty_room(const Scene& scene, const std::vector<std::uint32_t>& products) {
  Scene bare = scene;
  bare.fixtures.clear(), bare.parts.clear(), bare.joints.clear(), bare.shelves.clear();
  bare.facings.clear(), bare.products.clear();
  float x = 1;
  for (const std::uint32_t product : products) {
    SceneProduct item = scene.products[product];
    item.facing = no_facing;
    item.position_m = {x, 1, 0};
    x += 0.8F;
    bare.products.push_back(item);
  }
  return bare;
}

// Seconds a step, once for each round, while `products` are kept awake and the arm moves.
Result<double> round_seconds(World& world, const std::vector<std::uint32_t>& products, int round) {
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

double resident_mb() {
  std::ifstream file("/proc/self/statm");
  double total = 0, resident = 0;
  file >> total >> resident;
  return resident * 4096 / 1e6;
}

}  // namespace

Figures run_world(const Catalog& catalog) {
  const ScratchFolder scratch;
  MARKETGEN_TRY(const Created created,
                create_store(neighbourhood_store(scratch / "store", false), catalog));
  MARKETGEN_TRY(const Scene scene, open_scene(scratch / "store" / "scene.bin"));
  const std::vector<std::uint32_t> chosen = spread(scene);
  const Scene bare = empty_room(scene, chosen);
  std::vector<std::uint32_t> in_bare;
  for (std::uint32_t i = 0; i < awake; ++i)
    in_bare.push_back(i);
  const WorldOptions options = with_arm(scene, catalog);

  const double before_mb = resident_mb();
  MARKETGEN_TRY(World world, World::create(scene, options));
  const double world_mb = resident_mb() - before_mb;
  MARKETGEN_TRY(World empty, World::create(bare, options));
  std::vector<double> in_store_s, in_empty_s;
  for (int round = 0; round < rounds; ++round) {  // in turn: both meet the same noise
    MARKETGEN_TRY(const double store_s, round_seconds(world, chosen, round));
    MARKETGEN_TRY(const double empty_s, round_seconds(empty, in_bare, round));
    in_store_s.push_back(store_s), in_empty_s.push_back(empty_s);
  }
  const int really_awake = world.counts().in_pool;
  const double build_s = median_seconds(3, [&] { (void)World::create(scene, options).ok(); });
  WorldOptions sector = options;
  sector.region_m = region_around_aisle(scene, 2000);
  const double sector_s = median_seconds(3, [&] { (void)World::create(scene, sector).ok(); });

  const std::string machine = machine_name();
  const auto figure = [&](std::string name, double value, std::string unit, int n) {
    return Figure{std::move(name), value, std::move(unit), n, {}, {}, machine};
  };
  const double store_s = median(in_store_s), empty_s = median(in_empty_s);
  Figure step = figure("world_step_arm_20_awake", 1e6 * store_s, "us", rounds);
  step.rival = "the same arm and goods in an empty room";
  step.ratio = store_s / empty_s;
  return std::vector<Figure>{
      step,
      figure("world_times_real_time", step_s / store_s, "s/s", rounds),
      figure("world_awake", really_awake, "products", 1),
      figure("world_products", static_cast<double>(scene.products.size()), "products", 1),
      figure("world_build", build_s, "s", 3),
      figure("world_build_sector", sector_s, "s", 3),
      figure("world_memory", world_mb, "MB", 1)};
}

}  // namespace marketgen::bench
