#include "audit/metrics.h"

#include <algorithm>
#include <array>

#include "audit/traffic.h"

namespace marketgen {
namespace {

// Fixtures whose footprint touches the rectangle.
int fixtures_beside(const Layout& layout, const RectMm& strip) {
  int number = 0;
  for (const Fixture& f : layout.fixtures) {
    if (f.levels >= 2 && f.endcap_of.empty() && overlap(footprint_of(f), strip)) ++number;
  }
  return number;
}

}  // namespace

double shelf_fill(const Scene& scene) {
  double available = 0, occupied = 0;
  for (const SceneShelf& shelf : scene.shelves) available += shelf.width_m;
  for (const Facing& facing : scene.facings) occupied += facing.product_count > 0 ? facing.width_m : 0;
  return available > 0 ? occupied / available : 0;
}

double selling_area_m2(const Scene& scene) {
  static constexpr std::array<std::string_view, 5> not_selling = {"backroom", "checkout", "self_checkout", "customer_service", "cafe"};
  double area = area_m2(floor_of(scene.layout.shell));
  for (const LayoutZone& zone : scene.layout.zones) {
    if (std::find(not_selling.begin(), not_selling.end(), zone.type) != not_selling.end()) area -= zone.area_m2;
  }
  return area;
}

int shopping_aisles(const Scene& scene) {
  constexpr int touch_mm = 100;
  int number = 0;
  for (const Aisle& aisle : scene.layout.aisles) {
    if (aisle.kind != AisleKind::secondary && aisle.kind != AisleKind::main) continue;
    const RectMm box = bounds_of(aisle.polygon_mm);
    const bool runs_north = box.depth() >= box.width();
    const RectMm one = runs_north ? RectMm{box.x0 - touch_mm, box.y0, box.x0, box.y1} : RectMm{box.x0, box.y0 - touch_mm, box.x1, box.y0};
    const RectMm other = runs_north ? RectMm{box.x1, box.y0, box.x1 + touch_mm, box.y1} : RectMm{box.x0, box.y1, box.x1, box.y1 + touch_mm};
    if (fixtures_beside(scene.layout, one) > 0 && fixtures_beside(scene.layout, other) > 0) ++number;
  }
  return number;
}

}  // namespace marketgen
