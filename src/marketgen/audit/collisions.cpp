#include "audit/collisions.h"

#include <algorithm>
#include <cmath>

#include "audit/item_bounds.h"
#include "base/parallel.h"
#include "scene/placements.h"

namespace marketgen {
namespace {

constexpr float near_m = 0.005F;
constexpr float tolerance_m = 0.001F;

// Smallest overlap of two boxes over the axes; negative when apart.
float overlap_of(const Bounds3& a, const Bounds3& b) {
  const float x = std::min(a.high.x, b.high.x) - std::max(a.low.x, b.low.x);
  const float y = std::min(a.high.y, b.high.y) - std::max(a.low.y, b.low.y);
  const float z = std::min(a.high.z, b.high.z) - std::max(a.low.z, b.low.z);
  return std::min({x, y, z});
}

// Items sorted by their west side, so that neighbours are found by one sweep.
std::vector<std::uint32_t> west_to_east(const std::vector<Bounds3>& bounds) {
  std::vector<std::uint32_t> order(bounds.size());
  for (std::uint32_t i = 0; i < order.size(); ++i)
    order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return bounds[a].low.x != bounds[b].low.x ? bounds[a].low.x < bounds[b].low.x : a < b;
  });
  return order;
}

// Rows of the sweep are cut into strips along Y, so that a long store does not compare its two
// ends.
constexpr float strip_m = 0.5F;

struct Strips {
  std::vector<std::vector<std::uint32_t>> items;  // per strip, from west to east
  std::vector<std::size_t> first;  // per item: the southernmost strip that it reaches
};

Strips strips_of(const std::vector<Bounds3>& bounds) {
  if (bounds.empty()) return {};
  float low = 1e30F, high = -1e30F;
  for (const Bounds3& b : bounds) {
    low = std::min(low, b.low.y);
    high = std::max(high, b.high.y);
  }
  Strips strips;
  strips.items.resize(static_cast<std::size_t>((high - low) / strip_m) + 1);
  strips.first.resize(bounds.size());
  for (const std::uint32_t i : west_to_east(bounds)) {
    strips.first[i] =
        static_cast<std::size_t>(std::max(0.0F, (bounds[i].low.y - near_m - low) / strip_m));
    const auto last = static_cast<std::size_t>((bounds[i].high.y + near_m - low) / strip_m);
    for (std::size_t s = strips.first[i]; s <= last && s < strips.items.size(); ++s)
      strips.items[s].push_back(i);
  }
  return strips;
}

struct NearPairs {
  std::uint64_t number = 0;
  std::vector<ProductPair> suspects;  // boxes overlap by more than the limit
};

// A pair in several strips belongs to the southernmost of those that both reach.
NearPairs sweep(const Strips& strips, std::size_t number, const std::vector<Bounds3>& bounds) {
  const std::vector<std::uint32_t>& strip = strips.items[number];
  NearPairs found;
  for (std::size_t a = 0; a < strip.size(); ++a) {
    const Bounds3& first = bounds[strip[a]];
    for (std::size_t b = a + 1; b < strip.size() && bounds[strip[b]].low.x <= first.high.x + near_m;
         ++b) {
      const Bounds3& second = bounds[strip[b]];
      if (std::max(strips.first[strip[a]], strips.first[strip[b]]) != number) continue;
      const float overlap = overlap_of(first, second);
      if (overlap < -near_m) continue;
      ++found.number;
      if (overlap > static_cast<float>(penetration_limit_m))
        found.suspects.emplace_back(strip[a], strip[b]);
    }
  }
  return found;
}

bool inside_shelf(const Scene& scene,
                  const SceneProduct& item,
                  const CollisionPrimitive& primitive) {
  const SceneShelf& shelf = scene.shelves[scene.facings[item.facing].shelf];
  const Pose shelf_from_item =
      inverse(world_from_shelf(scene, scene.facings[item.facing].shelf)) * world_from_product(item);
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

bool inside_room(const Scene& scene, const Bounds3& b) {
  const Shell& shell = scene.layout.shell;
  const auto m = [](int mm) { return static_cast<float>(mm) * 1e-3F; };
  const bool inside_box = b.low.x >= -tolerance_m && b.low.y >= -tolerance_m &&
                          b.low.z >= -tolerance_m && b.high.x <= m(shell.width_mm) + tolerance_m &&
                          b.high.y <= m(shell.depth_mm) + tolerance_m &&
                          b.high.z <= m(shell.ceiling_mm) + tolerance_m;
  return inside_box && (!shell.outline_mm || on_floor(*shell.outline_mm, b));
}

}  // namespace

Result<CollisionCount> count_collisions(const Scene& scene, const std::vector<Bounds3>& bounds) {
  const Strips strips = strips_of(bounds);
  const auto found =
      parallel_map(strips.items.size(), [&](std::size_t s) { return sweep(strips, s, bounds); });
  CollisionCount count;
  std::vector<ProductPair> suspects;
  for (const NearPairs& strip : found) {
    count.near_pairs += strip.number;
    suspects.insert(suspects.end(), strip.suspects.begin(), strip.suspects.end());
  }
  MARKETGEN_TRY(const std::vector<double> depths, penetration_depths(scene, suspects));
  for (std::size_t i = 0; i < depths.size(); ++i) {
    if (depths[i] <= penetration_limit_m) continue;
    ++count.colliding_pairs;
    if (!count.deepest || depths[i] > count.deepest->depth_m)
      count.deepest = DeepPair{suspects[i], depths[i]};
  }
  return count;
}

std::vector<std::uint32_t> items_out_of_place(const Scene& scene,
                                              const std::vector<Bounds3>& bounds) {
  std::vector<CollisionPrimitive> primitives;
  for (const Product& product : scene.catalog) {
    const auto primitive = collision_of(product);
    primitives.push_back(primitive.ok() ? *primitive : CollisionPrimitive{});
  }
  constexpr std::size_t grain = 512;
  const auto outside = parallel_map(
      bounds.size(),
      [&](std::size_t i) -> std::uint8_t {
        const SceneProduct& item = scene.products[i];
        const bool in_place =
            inside_room(scene, bounds[i]) &&
            (item.facing == no_facing || inside_shelf(scene, item, primitives[item.sku]));
        return in_place ? 0 : 1;
      },
      grain);
  std::vector<std::uint32_t> rows;
  for (std::uint32_t i = 0; i < outside.size(); ++i) {
    if (outside[i] != 0) rows.push_back(i);
  }
  return rows;
}

}  // namespace marketgen
