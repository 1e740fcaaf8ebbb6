#include "audit/metrics.h"

#include <algorithm>
#include <array>

#include "audit/traffic.h"
#include "layout/makes.h"
#include "scene/price_tags.h"

namespace marketgen::audit {
namespace {

// Stretches that stocked fixtures take of a line across the store, sorted. `across_x`: the line
// runs east at y = `at`; otherwise it runs north at x = `at`.
std::vector<std::array<int, 2>> stocked_stretches(const scene::Scene& scene,
                                                  bool across_x,
                                                  int at) {
  std::vector<std::array<int, 2>> stretches;
  for (std::size_t i = 0; i < scene.fixtures.size(); ++i) {
    if (scene.fixtures[i].shelf_count == 0) continue;
    const RectMm r = layout::footprint_of(scene.layout.fixtures[i]);
    const bool crossed = across_x ? r.y0 <= at && at <= r.y1 : r.x0 <= at && at <= r.x1;
    if (crossed) stretches.push_back(across_x ? std::array{r.x0, r.x1} : std::array{r.y0, r.y1});
  }
  std::sort(stretches.begin(), stretches.end());
  return stretches;
}

// Gaps between them that a person walks through.
int walkable_gaps(const std::vector<std::array<int, 2>>& stretches) {
  constexpr int min_mm = 600;
  int number = 0, reached = stretches.empty() ? 0 : stretches.front()[1];
  for (const auto& [from, to] : stretches) {
    if (from - reached >= min_mm) ++number;
    reached = std::max(reached, to);
  }
  return number;
}

// Of the blocks whose fixtures count.
void count_tags(const scene::Scene& scene, const std::vector<bool>& fixtures, StockCount& count) {
  std::vector<std::uint8_t> tags(scene.facings.size(), 0);
  std::vector<bool> wrong_price(tags.size(), false), wrong_product(tags.size(), false);
  for (const scene::PriceLabel& label : scene.price_labels) {
    ++tags[label.facing];
    const scene::TagFault fault = scene::fault_of(scene, label);
    if (fault == scene::TagFault::wrong_price) wrong_price[label.facing] = true;
    if (fault == scene::TagFault::wrong_product) wrong_product[label.facing] = true;
  }
  for (std::size_t row = 0; row < tags.size(); ++row) {
    const scene::SceneShelf& shelf = scene.shelves[scene.facings[row].shelf];
    if (!fixtures[shelf.fixture] || shelf.price_rail == 0) continue;
    ++count.tagged_blocks;
    count.no_tag += tags[row] == 0 ? 1 : 0;
    count.two_tags += tags[row] > 1 ? 1 : 0;
    count.wrong_price += wrong_price[row] && tags[row] == 1 ? 1 : 0;
    count.wrong_product += wrong_product[row] ? 1 : 0;
  }
}

}  // namespace

StockCount stock_on(const scene::Scene& scene, const std::vector<bool>& fixtures) {
  StockCount count;
  const auto counts = [&](const scene::SceneShelf& shelf) { return fixtures[shelf.fixture]; };
  const auto shelf_of = [&](const scene::Facing& facing) -> const scene::SceneShelf& {
    return scene.shelves[facing.shelf];
  };
  for (const scene::SceneShelf& shelf : scene.shelves)
    if (counts(shelf)) count.front_m += shelf.width_m;
  for (const scene::Facing& facing : scene.facings) {
    if (!counts(shelf_of(facing))) continue;
    ++count.blocks;
    count.empty_blocks += facing.product_count == 0 ? 1 : 0;
    count.stocked_m += facing.product_count > 0 ? facing.width_m : 0;
  }
  for (const scene::SceneProduct& product : scene.products) {
    if (!counts(shelf_of(scene.facings[product.facing]))) continue;
    ++count.items;
    count.misplaced += (product.flags & scene::product_misplaced) != 0 ? 1 : 0;
  }
  count_tags(scene, fixtures, count);
  return count;
}

double shelf_fill(const scene::Scene& scene) {
  double available = 0, occupied = 0;
  for (const scene::SceneShelf& shelf : scene.shelves)
    available += shelf.width_m;
  for (const scene::Facing& facing : scene.facings)
    occupied += facing.product_count > 0 ? facing.width_m : 0;
  return available > 0 ? occupied / available : 0;
}

double selling_area_m2(const scene::Scene& scene) {
  static constexpr std::array<std::string_view, 5> not_selling = {
      "backroom", "checkout", "self_checkout", "customer_service", "cafe"};
  double area = area_m2(plan::floor_of(scene.layout.shell));
  for (const layout::LayoutZone& zone : scene.layout.zones) {
    if (std::find(not_selling.begin(), not_selling.end(), zone.type) != not_selling.end())
      area -= zone.area_m2;
  }
  constexpr double nothing_m2 = 0.01;  // zones that fill the floor leave what rounding does
  return area > nothing_m2 ? area : 0;
}

int shopping_aisles(const scene::Scene& scene) {
  int most = 0;
  for (const layout::Fixture& fixture : scene.layout.fixtures) {
    if (fixture.sides != 2 && !layout::counts_as(scene.layout, fixture, "gondola")) continue;
    const bool fronts_face_north = fixture.yaw_deg % 180 == 0;
    const bool across_x = !fronts_face_north;  // the line runs across the aisles
    const int at = across_x ? fixture.y_mm : fixture.x_mm;
    most = std::max(most, walkable_gaps(stocked_stretches(scene, across_x, at)));
  }
  return most;
}

}  // namespace marketgen::audit
