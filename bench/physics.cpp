#include "bench/bench.h"
#include "bench/sample_store.h"
#include "physics/settle/settle.h"
#include "scene/scene_file.h"

namespace marketgen::bench {

Figures run_physics(const catalog::Catalog& catalog) {
  const ScratchFolder scratch;
  MARKETGEN_TRY(const store::Created created,
                store::create_store(neighbourhood_store(scratch / "store", false), catalog));
  MARKETGEN_TRY(const scene::Scene scene, scene::open_scene(scratch / "store" / "scene.bin"));
  constexpr int products = 200;
  physics::SettleOptions options;
  options.region_m = physics::region_around_aisle(scene, products);
  options.max_products = products;
  MARKETGEN_TRY(const physics::SettleReport report, physics::settle(scene, options));
  const std::string machine = machine_name();
  const double simulated_s = options.settle_s + options.watch_s;
  return std::vector<Figure>{{"settle_200_worst_drift_mm",
                              1000 * report.worst_drift_m,
                              "mm",
                              1,
                              std::nullopt,
                              std::nullopt,
                              machine},
                             {"settle_200_share_below_5_cm",
                              report.share_below_5_cm,
                              "share",
                              1,
                              std::nullopt,
                              std::nullopt,
                              machine},
                             {"settle_200_wall_over_simulated",
                              report.simulate_s / simulated_s,
                              "s/s",
                              1,
                              std::nullopt,
                              std::nullopt,
                              machine}};
}

}  // namespace marketgen::bench
