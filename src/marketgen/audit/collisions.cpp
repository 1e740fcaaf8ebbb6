#include "audit/collisions.h"

#include <algorithm>
#include <cmath>

#include "audit/item_bounds.h"
#include "base/parallel.h"
#include "geometry/box_tree.h"
#include "scene/placements.h"

namespace marketgen::audit {
namespace {

constexpr float near_m = 0.005F;
constexpr float tolerance_m = 0.001F;

struct NearPairs {
  std::uint64_t number = 0;
  std::vector<physics::ProductPair> suspects;  // boxes overlap by more than the limit
};

// Pairs of an item with those that stand after it.
NearPairs pairs_of(std::uint32_t item, const BoxTree& tree, const std::vector<Bounds3>& bounds) {
  NearPairs found;
  tree.each_near(bounds[item], -near_m, [&](std::uint32_t other) {
    if (other <= item) return;
    ++found.number;
    if (overlap_of(bounds[item], bounds[other]) > static_cast<float>(physics::penetration_limit_m))
      found.suspects.emplace_back(item, other);
  });
  std::ranges::sort(found.suspects);
  return found;
}

bool inside_shelf(const scene::Scene& scene,
                  const scene::SceneProduct& item,
                  const assets::CollisionPrimitive& primitive) {
  const scene::SceneShelf& shelf = scene.shelves[scene.facings[item.facing].shelf];
  const Pose shelf_from_item =
      inverse(scene::world_from_shelf(scene, scene.facings[item.facing].shelf)) *
      scene::world_from_product(item);
  const Bounds3 b = bounds_of(primitive, shelf_from_item);
  return b.low.x >= -shelf.width_m / 2 - tolerance_m &&
         b.high.x <= shelf.width_m / 2 + tolerance_m && b.low.y >= -tolerance_m &&
         b.high.y <= shelf.depth_m + tolerance_m && b.low.z >= -tolerance_m &&
         b.high.z <= shelf.clearance_m + tolerance_m;
}

// The corners of the box, drawn in by the tolerance, on the floor's polygon. Precondition: the box
// is inside the rectangle.
bool on_floor(const PolygonMm& floor, const Bounds3& b) {
  const auto mm = [](float m) { return static_cast<int>(std::lround(m * 1000)); };
  const int x0 = mm(b.low.x + tolerance_m), x1 = mm(b.high.x - tolerance_m),
            y0 = mm(b.low.y + tolerance_m), y1 = mm(b.high.y - tolerance_m);
  return contains(floor, PointMm{x0, y0}) && contains(floor, PointMm{x1, y0}) &&
         contains(floor, PointMm{x1, y1}) && contains(floor, PointMm{x0, y1});
}

bool inside_room(const scene::Scene& scene, const Bounds3& b) {
  const plan::Shell& shell = scene.layout.shell;
  const auto m = [](int mm) { return static_cast<float>(mm) * 1e-3F; };
  const bool inside_box = b.low.x >= -tolerance_m && b.low.y >= -tolerance_m &&
                          b.low.z >= -tolerance_m && b.high.x <= m(shell.width_mm) + tolerance_m &&
                          b.high.y <= m(shell.depth_mm) + tolerance_m &&
                          b.high.z <= m(shell.ceiling_mm) + tolerance_m;
  return inside_box && (!shell.outline_mm || on_floor(*shell.outline_mm, b));
}

}  // namespace

Result<CollisionCount> count_collisions(const scene::Scene& scene,
                                        const std::vector<Bounds3>& bounds) {
  const BoxTree tree(bounds);
  constexpr std::size_t grain = 256;
  const auto found = parallel_map(
      bounds.size(),
      [&](std::size_t i) { return pairs_of(static_cast<std::uint32_t>(i), tree, bounds); },
      grain);
  CollisionCount count;
  std::vector<physics::ProductPair> suspects;
  for (const NearPairs& item : found) {
    count.near_pairs += item.number;
    suspects.insert(suspects.end(), item.suspects.begin(), item.suspects.end());
  }
  MARKETGEN_TRY(const std::vector<double> depths, physics::penetration_depths(scene, suspects));
  for (std::size_t i = 0; i < depths.size(); ++i) {
    if (depths[i] <= physics::penetration_limit_m) continue;
    ++count.colliding_pairs;
    if (!count.deepest || depths[i] > count.deepest->depth_m)
      count.deepest = DeepPair{suspects[i], depths[i]};
  }
  return count;
}

std::vector<std::uint32_t> items_out_of_place(const scene::Scene& scene,
                                              const std::vector<Bounds3>& bounds) {
  std::vector<assets::CollisionPrimitive> primitives;
  for (const catalog::Product& product : scene.catalog) {
    const auto primitive = assets::collision_of(product);
    primitives.push_back(primitive.ok() ? *primitive : assets::CollisionPrimitive{});
  }
  constexpr std::size_t grain = 512;
  const auto outside = parallel_map(
      bounds.size(),
      [&](std::size_t i) -> std::uint8_t {
        const scene::SceneProduct& item = scene.products[i];
        const bool in_place =
            inside_room(scene, bounds[i]) &&
            (item.facing == scene::no_facing || inside_shelf(scene, item, primitives[item.sku]));
        return in_place ? 0 : 1;
      },
      grain);
  std::vector<std::uint32_t> rows;
  for (std::uint32_t i = 0; i < outside.size(); ++i) {
    if (outside[i] != 0) rows.push_back(i);
  }
  return rows;
}

}  // namespace marketgen::audit
