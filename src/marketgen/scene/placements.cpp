#include "scene/placements.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "catalog/standing_box.h"
#include "geometry/box_tree.h"
#include "scene/row_arrays.h"
#include "scene/shelf_fill.h"

namespace marketgen::scene {
namespace {

bool takes_no_more_room(const catalog::Product& candidate, const catalog::Product& place) {
  for (int axis = 0; axis < 3; ++axis) {
    if (candidate.size_mm[static_cast<std::size_t>(axis)] >
        place.size_mm[static_cast<std::size_t>(axis)])
      return false;
  }
  return true;
}

constexpr double touching_m = 1e-4;  // what only touches does not meet: poses are rounded to floats

bool meet_in_plan(const catalog::StandingBox& a, const catalog::StandingBox& b) {
  return a.low.x + touching_m < b.high.x && b.low.x + touching_m < a.high.x &&
         a.low.y + touching_m < b.high.y && b.low.y + touching_m < a.high.y;
}
bool meet(const catalog::StandingBox& a, const catalog::StandingBox& b) {
  return meet_in_plan(a, b) && a.low.z + touching_m < b.high.z && b.low.z + touching_m < a.high.z;
}

// What was taken out of one block, by place: an item asks only about what lay around it.
class TakenOut {
 public:
  // `pitch_m`: no box of the block is wider or deeper.
  explicit TakenOut(double pitch_m) : pitch_m_(pitch_m) {}

  void add(const catalog::StandingBox& box) { boxes_[cell_of(box)].push_back(box); }

  bool lay_below(const catalog::StandingBox& box) const {
    const auto [column, row] = cell_of(box);
    for (std::int64_t x = column - 1; x <= column + 1; ++x) {
      for (std::int64_t y = row - 1; y <= row + 1; ++y) {
        const auto cell = boxes_.find({x, y});
        if (cell == boxes_.end()) continue;
        const bool below = std::ranges::any_of(cell->second, [&](const catalog::StandingBox& b) {
          return b.low.z < box.low.z && meet_in_plan(b, box);
        });
        if (below) return true;
      }
    }
    return false;
  }

 private:
  using Cell = std::pair<std::int64_t, std::int64_t>;

  Cell cell_of(const catalog::StandingBox& box) const {
    const auto at = [&](double low, double high) {
      return static_cast<std::int64_t>(std::floor((low + high) / 2 / pitch_m_));
    };
    return {at(box.low.x, box.high.x), at(box.low.y, box.high.y)};
  }

  double pitch_m_;
  std::map<Cell, std::vector<catalog::StandingBox>> boxes_;
};

// The pinned products' boxes, to be asked who meets them.
class Pinned {
 public:
  explicit Pinned(const std::vector<catalog::StandingBox>& boxes)
      : boxes_(boxes), tree_(bounds(boxes)) {}

  bool meets(const catalog::StandingBox& box) const {
    constexpr float rounding_m = 1e-3F;  // the tree's boxes are single precision
    bool found = false;
    tree_.each_near(catalog::bounds_of(box), -rounding_m, [&](std::uint32_t pin) {
      found = found || meet(boxes_[pin], box);
    });
    return found;
  }

 private:
  static std::vector<Bounds3> bounds(const std::vector<catalog::StandingBox>& boxes) {
    std::vector<Bounds3> all;
    for (const catalog::StandingBox& box : boxes)
      all.push_back(catalog::bounds_of(box));
    return all;
  }

  const std::vector<catalog::StandingBox>& boxes_;
  BoxTree tree_;
};

// Items of a block in the way of a pinned product, and what stands on those: a block lists lower
// items first.
void take_out(const Scene& scene,
              const Facing& facing,
              const Pinned& pinned,
              const catalog::Catalog& catalog,
              std::vector<std::uint8_t>& drop) {
  std::vector<catalog::StandingBox> boxes;
  double pitch_m = 0;
  bool hit = false;
  for (std::uint32_t k = 0; k < facing.product_count; ++k) {
    const SceneProduct& item = scene.products[facing.first_product + k];
    const Pose pose = world_from_product(item);
    boxes.push_back(
        catalog::standing_box(catalog.products[item.sku], pose.position, pose.rotation));
    const catalog::StandingBox& box = boxes.back();
    pitch_m = std::max({pitch_m, box.high.x - box.low.x, box.high.y - box.low.y});
    drop[facing.first_product + k] = pinned.meets(box) ? 1 : 0;
    hit = hit || drop[facing.first_product + k] != 0;
  }
  if (!hit) return;
  TakenOut gone(pitch_m);
  for (std::uint32_t k = 0; k < facing.product_count; ++k) {
    std::uint8_t& dropped = drop[facing.first_product + k];
    if (dropped == 0 && gone.lay_below(boxes[k])) dropped = 1;
    if (dropped != 0) gone.add(boxes[k]);
  }
}

std::vector<std::uint8_t> items_in_the_way(const Scene& scene,
                                           const std::vector<catalog::StandingBox>& boxes,
                                           const catalog::Catalog& catalog) {
  const Pinned pinned(boxes);
  std::vector<std::uint8_t> drop(scene.products.size(), 0);
  for (const Facing& facing : scene.facings)
    take_out(scene, facing, pinned, catalog, drop);
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

bool is_on_top(const Scene& scene, const Facing& facing, std::uint32_t i) {
  return i + 1 == facing.first_product + facing.product_count ||
         scene.products[i + 1].position_m[2] <= scene.products[i].position_m[2];
}

// In heaps its neighbours lie against an item; in stacks others stand on it; what shoppers left out
// of line has room just as it stands.
bool can_change(const Scene& scene,
                const Facing& facing,
                std::uint32_t i,
                const catalog::Catalog& catalog) {
  const std::uint32_t flags = scene.products[i].flags;
  return !lies_in_a_heap(catalog.products[facing.sku]) && (flags & product_front_row) != 0 &&
         (flags & product_out_of_line) == 0 && is_on_top(scene, facing, i);
}

// The plan's zone of a facing; null unless something is to be misplaced there.
const plan::Zone* untidy_zone(const Scene& scene, const plan::Plan& plan, const Facing& facing) {
  const layout::Fixture& fixture = scene.layout.fixtures[scene.shelves[facing.shelf].fixture];
  const plan::Zone* zone = plan::find_zone(plan, fixture.zone);
  return zone != nullptr && zone->stock.misplaced > 0 ? zone : nullptr;
}

// The chance of an item that can be another product: a share of misplaced goods is one of all that
// shoppers see in the front rows of the zone.
std::map<const plan::Zone*, double> chances(const Scene& scene,
                                            const plan::Plan& plan,
                                            const catalog::Catalog& catalog) {
  std::map<const plan::Zone*, std::array<double, 2>> counts;  // seen; of these, that can change
  for (const Facing& facing : scene.facings) {
    const plan::Zone* zone = untidy_zone(scene, plan, facing);
    if (zone == nullptr) continue;
    auto& [seen, changeable] = counts[zone];
    for (std::uint32_t i = facing.first_product; i < facing.first_product + facing.product_count;
         ++i) {
      seen += (scene.products[i].flags & product_front_row) != 0 ? 1 : 0;
      changeable += can_change(scene, facing, i, catalog) ? 1 : 0;
    }
  }
  std::map<const plan::Zone*, double> chances;
  for (const auto& [zone, count] : counts)
    chances[zone] = count[1] > 0 ? std::min(1.0, zone->stock.misplaced * (count[0] / count[1])) : 0;
  return chances;
}

}  // namespace

std::uint32_t stranger_for(std::uint32_t row, const catalog::Catalog& catalog, Stream& draw) {
  const catalog::Product& place = catalog.products[row];
  const auto start =
      static_cast<std::size_t>(draw.integer(0, static_cast<int>(catalog.products.size()) - 1));
  for (std::size_t i = 0; i < catalog.products.size(); ++i) {
    const std::size_t candidate = (start + i) % catalog.products.size();
    const catalog::Product& product = catalog.products[candidate];
    if (product.subcategory != place.subcategory && product.storage == place.storage &&
        takes_no_more_room(product, place)) {
      return static_cast<std::uint32_t>(candidate);
    }
  }
  return row;
}

void misplace_items(Scene& scene,
                    const plan::Plan& plan,
                    const catalog::Catalog& catalog,
                    Seed seed) {
  const auto is_untidy = [](const plan::Zone& zone) { return zone.stock.misplaced > 0; };
  if (std::ranges::none_of(plan.zones, is_untidy)) return;
  const std::map<const plan::Zone*, double> chance_in = chances(scene, plan, catalog);
  for (const Facing& facing : scene.facings) {
    const plan::Zone* zone = untidy_zone(scene, plan, facing);
    if (zone == nullptr) continue;
    const double chance = chance_in.at(zone);
    const layout::Fixture& fixture = scene.layout.fixtures[scene.shelves[facing.shelf].fixture];
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
      if (!can_change(scene, facing, i, catalog) || !draw.chance(chance)) continue;
      const std::uint32_t stranger = stranger_for(item.sku, catalog, draw);
      if (stranger == item.sku) continue;
      item.sku = stranger;
      item.rotation_wxyz = as_array(straight);
      item.flags |= product_misplaced;
    }
  }
}

Result<void> add_placements(Scene& scene, const plan::Plan& plan, const catalog::Catalog& catalog) {
  if (plan.placements.empty()) return {};
  std::vector<SceneProduct> pinned;
  std::vector<catalog::StandingBox> boxes;
  for (std::size_t i = 0; i < plan.placements.size(); ++i) {
    const plan::Placement& placement = plan.placements[i];
    const catalog::Product* product = catalog.product(placement.sku);
    if (product == nullptr) {
      std::vector<std::string_view> names;
      for (const catalog::Product& p : catalog.products)
        names.push_back(p.sku);
      return catalog::unknown_name("catalog.unknown_sku",
                                   "plan:/placements/" + std::to_string(i) + "/sku",
                                   "product",
                                   placement.sku,
                                   names);
    }
    const Vec3 position{placement.position_m[0], placement.position_m[1], placement.position_m[2]};
    const Quaternion rotation =
        rotation_about({0, 0, 1}, placement.yaw_deg * std::numbers::pi / 180);
    boxes.push_back(catalog::standing_box(*product, position, rotation));
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

}  // namespace marketgen::scene
