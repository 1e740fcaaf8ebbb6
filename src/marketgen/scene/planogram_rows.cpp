#include "scene/planogram_rows.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "scene/bays.h"

namespace marketgen::scene {
namespace {

int to_mm(double metres) {
  return static_cast<int>(std::lround(metres * 1000));
}

// Quarter turns about Z from the fixture's frame to the direction that the shelf faces.
int quarter_turns(const SceneShelf& shelf) {
  const auto [w, x, y, z] = shelf.rotation_wxyz;
  const Vec3 along = rotate({w, x, y, z}, {1, 0, 0});
  if (std::abs(along.x) >= std::abs(along.y)) return along.x >= 0 ? 0 : 2;
  return along.y >= 0 ? 1 : 3;
}

// The bay's frame in the store's, and how wide its front is.
struct BayFront {
  Pose world_from_bay;
  double width_m = 0;
};

BayFront bay_front(const Scene& scene, const SceneShelf& shelf) {
  const layout::Fixture& fixture = scene.layout.fixtures[shelf.fixture];
  const int turns = quarter_turns(shelf);
  double width = fixture.width_mm * 1e-3, depth = fixture.depth_mm * 1e-3;
  if (turns % 2 != 0) std::swap(width, depth);
  Pose world_from_fixture = scene::world_from_fixture(scene, shelf.fixture);
  world_from_fixture.position.z = 0;  // the floor, for what hangs on a wall, too
  const Pose turned{{}, yaw_from_quarter_turns(turns)};
  return {world_from_fixture * turned * Pose{{-width / 2, -depth / 2, 0}, {}}, width};
}

PackFace face_seen(const Scene& scene, const Facing& facing) {
  const SceneShelf& shelf = scene.shelves[facing.shelf];
  if (shelf.use == assets::ShelfUse::heap) return PackFace::loose;
  if (facing.product_count == 0) return PackFace::front;  // as it will be filled
  const Quaternion world_from_item =
      world_from_product(scene.products[facing.first_product]).rotation;
  const Quaternion world_from_shelf = scene::world_from_shelf(scene, facing.shelf).rotation;
  // The direction to the shopper, as the pack has it: its printed front is at -Y.
  const Vec3 seen = rotate(inverse(world_from_item) * world_from_shelf, {0, -1, 0});
  const double x = std::abs(seen.x), y = std::abs(seen.y), z = std::abs(seen.z);
  if (y >= x && y >= z) return seen.y <= 0 ? PackFace::front : PackFace::back;
  if (x >= z) return PackFace::side;
  return seen.z >= 0 ? PackFace::top : PackFace::bottom;
}

// Numbers of bays along their sides of runs, from 1, by the first shelf's fixture and side.
std::map<std::pair<std::uint32_t, int>, int> bay_numbers(const Scene& scene) {
  std::map<std::pair<std::uint32_t, int>, int> numbers;
  const std::vector<BayRef> bays = bays_of(scene);
  int number = 0;
  for (std::size_t i = 0; i < bays.size(); ++i) {
    const bool goes_on = i > 0 && bays[i].zone == bays[i - 1].zone &&
                         bays[i].run == bays[i - 1].run && bays[i].side == bays[i - 1].side;
    number = goes_on ? number + 1 : 1;
    numbers[{bays[i].fixture, bays[i].side}] = number;
  }
  return numbers;
}

void add_place(PlanogramRow& row, const Scene& scene, const Facing& facing) {
  const SceneShelf& shelf = scene.shelves[facing.shelf];
  const BayFront front = bay_front(scene, shelf);
  const Pose bay_from_shelf = inverse(front.world_from_bay) * world_from_shelf(scene, facing.shelf);
  const Vec3 at = bay_from_shelf * Vec3{facing.x_m - shelf.width_m / 2.0, 0, 0};
  row.bay_width_mm = to_mm(front.width_m);
  row.shelf_height_mm = to_mm(bay_from_shelf.position.z);
  row.bay_x_mm = to_mm(at.x), row.bay_y_mm = to_mm(at.y), row.bay_z_mm = to_mm(at.z);
  row.block_width_mm = to_mm(facing.width_m);
}

void add_product(PlanogramRow& row, const catalog::Product& product) {
  row.sku = product.sku, row.ean = product.ean, row.price = product.price;
  row.name = product.variant.empty() ? product.name : product.name + " " + product.variant;
  row.brand = product.brand;
  row.category = product.category, row.subcategory = product.subcategory;
  row.width_mm = product.size_mm[0], row.depth_mm = product.size_mm[1];
  row.height_mm = product.size_mm[2];
}

void add_counts(PlanogramRow& row, const Scene& scene, const Facing& facing) {
  row.facings = facing.facings, row.depth_count = facing.rows_deep, row.stack = facing.stack;
  row.units = static_cast<int>(facing.product_count);
  // A settled heap has no rows to count: it holds at least what lies there.
  row.capacity = std::max(row.units, row.facings * row.depth_count * row.stack);
  for (std::uint32_t i = 0; i < facing.product_count; ++i)
    row.misplaced += scene.products[facing.first_product + i].sku != facing.sku ? 1 : 0;
}

}  // namespace

double shelf_left_m(const Scene& scene, std::uint32_t shelf) {
  const BayFront front = bay_front(scene, scene.shelves[shelf]);
  const Pose bay_from_shelf = inverse(front.world_from_bay) * world_from_shelf(scene, shelf);
  return (bay_from_shelf * Vec3{-scene.shelves[shelf].width_m / 2.0, 0, 0}).x;
}

std::vector<PlanogramRow> planogram_rows(const Scene& scene) {
  std::vector<bool> promoted(scene.facings.size(), false);
  for (const PriceLabel& label : scene.price_labels)
    if (label.promotion != 0 && label.sku == scene.facings[label.facing].sku)
      promoted[label.facing] = true;
  const auto bays = bay_numbers(scene);
  std::vector<PlanogramRow> rows;
  rows.reserve(scene.facings.size());
  for (std::size_t f = 0; f < scene.facings.size(); ++f) {
    const Facing& facing = scene.facings[f];
    const SceneShelf& shelf = scene.shelves[facing.shelf];
    const layout::Fixture& fixture = scene.layout.fixtures[shelf.fixture];
    PlanogramRow row;
    row.fixture = fixture.id, row.run = fixture.run;
    row.level = shelf.level, row.side = shelf.side, row.position = facing.position;
    row.bay = bays.at({shelf.fixture, shelf.side});
    row.x_mm = static_cast<int>(std::lround(facing.x_m * 1000));  // as floats round it
    row.use = shelf.use;
    row.promotion = promoted[f];
    row.orientation = face_seen(scene, facing);
    add_product(row, scene.catalog[facing.sku]);
    add_place(row, scene, facing);
    add_counts(row, scene, facing);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace marketgen::scene
