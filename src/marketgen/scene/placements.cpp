#include "scene/placements.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/row_arrays.h"
#include "scene/shelf_fill.h"

namespace marketgen {
namespace {

bool takes_no_more_room(const Product& candidate, const Product& place) {
  for (int axis = 0; axis < 3; ++axis) {
    if (candidate.size_mm[static_cast<std::size_t>(axis)] >
        place.size_mm[static_cast<std::size_t>(axis)])
      return false;
  }
  return true;
}

// A product of another subcategory that fits into the place of `row`, or `row` itself.
std::uint32_t stranger_for(std::uint32_t row, const Catalog& catalog, Stream& draw) {
  const Product& place = catalog.products[row];
  const auto start =
      static_cast<std::size_t>(draw.integer(0, static_cast<int>(catalog.products.size()) - 1));
  for (std::size_t i = 0; i < catalog.products.size(); ++i) {
    const std::size_t candidate = (start + i) % catalog.products.size();
    const Product& product = catalog.products[candidate];
    if (product.subcategory != place.subcategory && product.storage == place.storage &&
        takes_no_more_room(product, place)) {
      return static_cast<std::uint32_t>(candidate);
    }
  }
  return row;
}

struct Box {
  Vec3 low, high;
};

// Box of an item at any yaw: its footprint's circumscribed circle would be too wide, so the turned
// rectangle is used.
Box box_of(const Vec3& position, const Quaternion& rotation, const Product& product) {
  const Vec3 x = rotate(rotation, {product.width_m() / 2, 0, 0}),
             y = rotate(rotation, {0, product.depth_m() / 2, 0});
  const double half_x = std::abs(x.x) + std::abs(y.x), half_y = std::abs(x.y) + std::abs(y.y);
  return {{position.x - half_x, position.y - half_y, position.z},
          {position.x + half_x, position.y + half_y, position.z + product.height_m()}};
}

constexpr double touching_m = 1e-4;  // what only touches does not meet: poses are rounded to floats

bool meet_in_plan(const Box& a, const Box& b) {
  return a.low.x + touching_m < b.high.x && b.low.x + touching_m < a.high.x &&
         a.low.y + touching_m < b.high.y && b.low.y + touching_m < a.high.y;
}
bool meet(const Box& a, const Box& b) {
  return meet_in_plan(a, b) && a.low.z + touching_m < b.high.z && b.low.z + touching_m < a.high.z;
}

// Items in the way of one of `pinned`, and what stands on those: a block lists lower items first.
std::vector<std::uint8_t> items_in_the_way(const Scene& scene,
                                           const std::vector<Box>& pinned,
                                           const Catalog& catalog) {
  std::vector<std::uint8_t> drop(scene.products.size(), 0);
  for (const Facing& facing : scene.facings) {
    std::vector<Box> gone;
    for (std::uint32_t i = facing.first_product; i < facing.first_product + facing.product_count;
         ++i) {
      const Pose pose = world_from_product(scene.products[i]);
      const Box box = box_of(pose.position, pose.rotation, catalog.products[scene.products[i].sku]);
      const bool hit =
          std::any_of(pinned.begin(), pinned.end(), [&](const Box& b) { return meet(b, box); });
      const bool unsupported = std::any_of(gone.begin(), gone.end(), [&](const Box& b) {
        return b.low.z < box.low.z && meet_in_plan(b, box);
      });
      if (!hit && !unsupported) continue;
      drop[i] = 1;
      gone.push_back(box);
    }
  }
  return drop;
}

// Leaves out the items marked in `drop` and moves every block's range along.
void remove_items(Scene& scene, const std::vector<std::uint8_t>& drop) {
  std::vector<SceneProduct> kept;
  kept.reserve(scene.products.size());
  for (Facing& facing : scene.facings) {
    const auto first = static_cast<std::uint32_t>(kept.size());
    for (std::uint32_t i = facing.first_product; i < facing.first_product + facing.product_count;
         ++i) {
      if (drop[i] == 0) kept.push_back(scene.products[i]);
    }
    facing.first_product = first;
    facing.product_count = static_cast<std::uint32_t>(kept.size()) - first;
  }
  scene.products = std::move(kept);
}

}  // namespace

void misplace_items(Scene& scene, const Plan& plan, const Catalog& catalog, Seed seed) {
  for (const Facing& facing : scene.facings) {
    const Fixture& fixture = scene.layout.fixtures[scene.shelves[facing.shelf].fixture];
    const Zone* zone = find_zone(plan, fixture.zone);
    if (zone == nullptr || zone->stock.misplaced <= 0) continue;
    if (lies_in_a_heap(catalog.products[facing.sku])) continue;  // its neighbours lie against it
    const std::uint64_t shelf =
        facing.shelf - scene.fixtures[scene.shelves[facing.shelf].fixture].first_shelf;
    Stream draw = seed.child("misplaced", fixture.id)
                      .child("shelf", shelf)
                      .child("facing", facing.position)
                      .stream();
    // Straight: a round pack may stand turned by more than a box has room for.
    const Quaternion straight = world_from_shelf(scene, facing.shelf).rotation;
    for (std::uint32_t i = facing.first_product; i < facing.first_product + facing.product_count;
         ++i) {
      SceneProduct& item = scene.products[i];
      const bool on_top = i + 1 == facing.first_product + facing.product_count ||
                          scene.products[i + 1].position_m[2] <= item.position_m[2];
      if ((item.flags & product_front_row) == 0 || !on_top || !draw.chance(zone->stock.misplaced))
        continue;
      const std::uint32_t stranger = stranger_for(item.sku, catalog, draw);
      if (stranger == item.sku) continue;
      item.sku = stranger;
      item.rotation_wxyz = as_array(straight);
      item.flags |= product_misplaced;
    }
  }
}

Result<void> add_placements(Scene& scene, const Plan& plan, const Catalog& catalog) {
  if (plan.placements.empty()) return {};
  std::vector<SceneProduct> pinned;
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < plan.placements.size(); ++i) {
    const Placement& placement = plan.placements[i];
    const Product* product = catalog.product(placement.sku);
    if (product == nullptr) {
      std::vector<std::string_view> names;
      for (const Product& p : catalog.products)
        names.push_back(p.sku);
      return unknown_name("catalog.unknown_sku",
                          "plan:/placements/" + std::to_string(i) + "/sku",
                          "product",
                          placement.sku,
                          names);
    }
    const Vec3 position{placement.position_m[0], placement.position_m[1], placement.position_m[2]};
    const Quaternion rotation =
        rotation_about({0, 0, 1}, placement.yaw_deg * std::numbers::pi / 180);
    boxes.push_back(box_of(position, rotation, *product));
    pinned.push_back({static_cast<std::uint32_t>(product - catalog.products.data()),
                      no_facing,
                      {static_cast<float>(position.x),
                       static_cast<float>(position.y),
                       static_cast<float>(position.z)},
                      as_array(rotation),
                      product_front_row});
  }
  remove_items(scene, items_in_the_way(scene, boxes, catalog));
  scene.products.insert(scene.products.end(), pinned.begin(), pinned.end());
  return {};
}

}  // namespace marketgen
