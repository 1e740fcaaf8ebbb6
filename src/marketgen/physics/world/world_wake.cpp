// Products between static and moving.
#include <algorithm>

#include "physics/world/world_state.h"
#include "scene/placements.h"

namespace marketgen::physics {
namespace {

// Two packs this near to each other touch: contact settles to a tenth of a millimetre, stacks are
// generated with less than a millimetre of air.
constexpr double touching_m = 0.003;
constexpr double sunk_m = 0.005;  // how far into its support a pack may stand
constexpr double displaced_m = 0.02;

bool overlap_on_floor(const Box3& a, const Box3& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

}  // namespace

bool World::State::loose(std::uint32_t product) const {
  return moved.contains(product) || heaped(product);
}

bool World::State::heaped(std::uint32_t product) const {
  if (store.goods[sku_of(product)].contact.dimensions > 4) return true;
  const std::uint32_t facing = scene.products[product].facing;
  return facing == scene::no_facing ||
         scene.shelves[scene.facings[facing].shelf].use == assets::ShelfUse::heap;
}

std::vector<std::uint32_t> World::State::resting_on(std::uint32_t product, const Box3& box) const {
  std::vector<std::uint32_t> carried;
  for (const std::uint32_t other : grid.near(box, touching_m)) {
    if (other == product) continue;
    const Box3& above = grid.box(other);
    const bool stands = above.low.z >= box.high.z - sunk_m && overlap_on_floor(above, box);
    const bool leans = loose(other) && above.low.z + above.high.z > box.low.z + box.high.z;
    if (stands || leans) carried.push_back(other);
  }
  return carried;
}

// Goods on pegs hang from the middle of their upper edge; soft packs, from the flap if that is
// there.
void World::State::hook(std::size_t body, std::uint32_t product) {
  const std::uint32_t sku = sku_of(product);
  const PoolBody& made = store.pool[body];
  const Vec3 top{0, 0, scene.catalog[sku].height_m()};
  Vec3 on_body = inverse(product_from_body(body)) * top;
  m().eq_obj1id[made.hook] = made.body;
  if (made.soft() && soft.at(sku)->pack.parts.back().center.z > 0) {
    m().eq_obj1id[made.hook] = made.body + made.parts - 1;
    on_body = on_body - soft.at(sku)->pack.hinges.back().at;
  }
  const Vec3 in_store = scene::world_from_product(scene.products[product]) * top;
  mjtNum* anchors = m().eq_data + mjNEQDATA * made.hook;
  const Vec3 both[2] = {on_body, in_store};
  for (int i = 0; i < 2; ++i)
    anchors[3 * i] = both[i].x, anchors[3 * i + 1] = both[i].y, anchors[3 * i + 2] = both[i].z;
}

bool World::State::wake(std::uint32_t product) {
  const int geom = store.product_geom[product];
  if (geom < 0) return false;
  if (body_of[product] >= 0) {
    const auto has = static_cast<std::size_t>(body_of[product]);
    if (asleep(has)) mark_wake(d(), store.pool[has]);
    return true;
  }
  const bool is_soft = soft_goods(product) != nullptr;
  if (fault) return false;
  const int found = free_body(is_soft);
  if (found < 0) {
    if (!refused[product]) report(EventKind::refused, product);
    if (!refused[product]) ++refusals;
    refused[product] = true;
    return false;
  }
  const auto body = static_cast<std::size_t>(found);
  if (!make_ready(product, store.pool[body].soft())) return false;
  LiveBody* const free = &live[body];
  const PoolBody& made = store.pool[body];
  const Pose stood = product_pose(product);
  const bool first = moved.try_emplace(product, geom_pose(m(), geom)).second;
  *free = {};
  free->product = product;
  free->woke_at = stood;
  free->carries = resting_on(product, grid.box(product));
  free->hooked = first && hangs_on_hook(scene, product);
  switch_geom(m(), geom, false);
  grid.remove(product);
  dress(body, product, stood);
  if (free->hooked) hook(body, product);
  d().eq_active[made.hook] = free->hooked;
  body_of[product] = found;
  ++woken;
  if (is_soft && !made.soft()) ++stiffened;
  report(EventKind::woke, product);
  return true;
}

void World::State::fall_asleep(std::size_t body) {
  LiveBody& here = live[body];
  if (!here.keeps) report_rest(body);
  here.keeps = !may_rest(body);
  if (here.keeps) return;
  const auto product = static_cast<std::uint32_t>(here.product);
  const ShapePose pose = shape_pose(product);
  park_body(m(), d(), store.pool[body]);
  stand(product, pose);
  body_of[product] = -1;
  refused.assign(refused.size(), false);
  here = {};
}

void World::State::report_rest(std::size_t body) {
  const auto product = static_cast<std::uint32_t>(live[body].product);
  const Vec3 way = product_pose(product).position - live[body].woke_at.position;
  report(EventKind::fell_asleep, product);
  if (length(way) > displaced_m) report(EventKind::displaced, product);
}

void World::State::wake_carried(std::size_t body) {
  const std::vector<std::uint32_t> carried = std::exchange(live[body].carries, {});
  for (const std::uint32_t product : carried)
    wake(product);
}

}  // namespace marketgen::physics
