#include <algorithm>

#include "physics/settle/settle.h"

namespace marketgen::physics {
namespace {

constexpr double shelf_depth_m = 0.6;  // goods this far behind an aisle's edge still face it

using Region = std::array<double, 4>;

Region grown(const Region& r, double by) {
  return {r[0] - by, r[1] - by, r[2] + by, r[3] + by};
}

Region region_of(const RectMm& rect) {
  return {rect.x0 * 1e-3, rect.y0 * 1e-3, rect.x1 * 1e-3, rect.y1 * 1e-3};
}

std::int64_t products_in(const scene::Scene& scene, const Region& r) {
  return std::ranges::count_if(scene.products, [&](const scene::SceneProduct& item) {
    const Vec3 p = scene::world_from_product(item).position;
    return p.x >= r[0] && p.x <= r[2] && p.y >= r[1] && p.y <= r[3];
  });
}

}  // namespace

Region region_around_aisle(const scene::Scene& scene, int products) {
  const plan::Shell& shell = scene.layout.shell;
  const Region store{0, 0, shell.width_mm * 1e-3, shell.depth_mm * 1e-3};
  Region best = store;
  std::int64_t most = -1;
  for (const layout::Aisle& aisle : scene.layout.aisles) {
    const Region region = grown(region_of(bounds_of(aisle.polygon_mm)), shelf_depth_m);
    const std::int64_t found = products_in(scene, region);
    if (found > most) best = region, most = found;
  }
  return most >= products ? best : store;
}

}  // namespace marketgen::physics
