// Do the goods stand? A region of the store is let go in MuJoCo and watched.
#pragma once
#include <array>
#include <string>

#include "base/fields.h"
#include "base/result.h"
#include "scene/scene.h"

namespace marketgen::physics {

struct SettleOptions {
  std::array<double, 4> region_m{};  // x0, y0, x1, y1
  int max_products = 200;            // nearest to the region's centre first
  double settle_s = 1, watch_s = 3;  // drift is counted over both
};

struct SettleReport {
  int products = 0;
  double median_drift_m = 0, worst_drift_m = 0;
  std::string worst_product;
  double share_below_5_cm = 1;  // STB
  double compile_s = 0, simulate_s = 0;

  static constexpr auto fields = field_list(
      field("products", &SettleReport::products, "free products"),
      field("median_drift_m", &SettleReport::median_drift_m, "median"),
      field("worst_drift_m", &SettleReport::worst_drift_m, "largest"),
      field("worst_product", &SettleReport::worst_product, "its id"),
      field("share_below_5_cm", &SettleReport::share_below_5_cm, "share that moved less than 5 cm"),
      field("compile_s", &SettleReport::compile_s, "MuJoCo's compile time"),
      field("simulate_s", &SettleReport::simulate_s, "wall time of the simulation"));
};

// Builds a MuJoCo model of the region (everything else static) and steps it. Errors:
// physics.failed; no MuJoCo error ends the process.
Result<SettleReport> settle(const scene::Scene& scene, const SettleOptions& options);
// An aisle region with at least `products` products around it.
std::array<double, 4> region_around_aisle(const scene::Scene& scene, int products);

// The MuJoCo version in use, "4.0.1".
std::string physics_version();

}  // namespace marketgen::physics
