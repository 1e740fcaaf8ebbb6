#include "physics/world.h"
#include "bench/bench.h"
#include "bench/sample_store.h"
#include "physics/settle.h"
#include "scene/scene_file.h"

namespace marketgen::bench {
namespace {

constexpr std::uint32_t awake = 20;
constexpr int steps = 1000;
constexpr double step_s = 0.002;

// The same goods, nothing else: what the bubble costs by itself.
Scene only(const Scene& scene, const std::vector<std::uint32_t>& products) {
  Scene bare = scene;
  bare.products.clear();
  for (const std::uint32_t product : products)
    bare.products.push_back(scene.products[product]);
  return bare;
}

// Products far apart, so that none wakes another.
std::vector<std::uint32_t> spread(const Scene& scene) {
  std::vector<std::uint32_t> rows;
  const auto all = static_cast<std::uint32_t>(scene.products.size());
  for (std::uint32_t i = 0; i < awake; ++i)
    rows.push_back(i * (all / awake));
  return rows;
}

// Median seconds of a step while all `products` are pushed to and fro, which keeps them awake.
Result<double> step_seconds(World& world, const std::vector<std::uint32_t>& products) {
  Result<void> failed;
  double force = 0.02;
  const double median = median_seconds(7, [&] {
    for (int i = 0; i < steps / 10; ++i) {
      for (const std::uint32_t product : products) {
        if (Result<void> pushed = world.push(product, {{0, 0, force}, {}}); !pushed.ok())
          failed = pushed;
      }
      force = -force;
      if (Result<void> stepped = world.step(10); !stepped.ok()) failed = stepped;
    }
  });
  if (!failed.ok()) return failed.error();
  return median / steps;
}

}  // namespace

Figures run_world(const Catalog& catalog) {
  const ScratchFolder scratch;
  MARKETGEN_TRY(const Created created,
                create_store(neighbourhood_store(scratch / "store", false), catalog));
  MARKETGEN_TRY(const Scene scene, open_scene(scratch / "store" / "scene.bin"));
  const std::vector<std::uint32_t> chosen = spread(scene);
  const Scene bare = only(scene, chosen);
  std::vector<std::uint32_t> in_bare;
  for (std::uint32_t i = 0; i < awake; ++i)
    in_bare.push_back(i);

  MARKETGEN_TRY(World world, World::create(scene, {}));
  MARKETGEN_TRY(World empty, World::create(bare, {}));
  MARKETGEN_TRY(const double in_store_s, step_seconds(world, chosen));
  MARKETGEN_TRY(const double in_empty_s, step_seconds(empty, in_bare));
  const double build_s = median_seconds(3, [&] { (void)World::create(scene, {}).ok(); });
  const WorldOptions sector{.region_m = region_around_aisle(scene, 200)};
  const double sector_s = median_seconds(3, [&] { (void)World::create(scene, sector).ok(); });

  const std::string machine = machine_name();
  const auto figure = [&](std::string name, double value, std::string unit) {
    return Figure{std::move(name), value, std::move(unit), 3, {}, {}, machine};
  };
  Figure step = figure("world_step_20_awake", 1e6 * in_store_s, "us");
  step.n = 7;
  step.rival = "the same 20 in a store without other goods";
  step.ratio = in_store_s / in_empty_s;
  return std::vector<Figure>{
      step,
      figure("world_times_real_time", step_s / in_store_s, "s/s"),
      figure("world_products", static_cast<double>(scene.products.size()), "products"),
      figure("world_build", build_s, "s"),
      figure("world_build_sector", sector_s, "s")};
}

}  // namespace marketgen::bench
