// Soft packs of a World: made when first needed, dressed, and at rest only when they are straight.
#include <algorithm>

#include "physics/world_state.h"

namespace marketgen {
namespace {

// So near, an actor would wake it again at once.
constexpr double near_actor_m = 0.005;

bool is_free(const LiveBody& body) {
  return body.product < 0;
}

}  // namespace

// Its seam is looked for on the pack's mesh (a millisecond), so only for what is touched.
const SoftGoods* World::State::soft_goods(std::uint32_t product) {
  const std::uint32_t sku = sku_of(product);
  const GoodsShape& goods = store.goods[sku];
  if (!goods.may_be_soft || options.soft_pool == 0) return nullptr;
  const auto [found, first] = soft.try_emplace(sku);
  if (!first) return found->second ? &*found->second : nullptr;
  const auto make = [&]() -> Result<std::optional<SoftGoods>> {
    MARKETGEN_TRY(const std::optional<SoftPack> pack, soft_pack_of(scene.catalog[sku]));
    if (!pack) return std::optional<SoftGoods>();
    MARKETGEN_TRY(MujocoModel model, soft_model(*pack, goods.contact, scene.catalog[sku].sku));
    return std::optional<SoftGoods>(SoftGoods{*pack, std::move(model)});
  };
  Result<std::optional<SoftGoods>> made = make();
  if (!made.ok()) {
    fault = made.error();
    soft.erase(found);
    return nullptr;
  }
  found->second = std::move(made).value();
  return found->second ? &*found->second : nullptr;
}

int World::State::free_body(bool soft_one) const {
  const auto first_soft = live.begin() + options.pool;
  auto found = soft_one ? std::find_if(first_soft, live.end(), is_free) : live.end();
  if (found == live.end()) {
    found = std::find_if(live.begin(), first_soft, is_free);
    if (found == first_soft) return -1;
  }
  return static_cast<int>(found - live.begin());
}

void World::State::dress(std::size_t body, std::uint32_t product, const ShapePose& pose) {
  const std::uint32_t sku = sku_of(product);
  const PoolBody& made = store.pool[body];
  if (made.soft()) {
    dress_soft_body(m(), d(), made, *soft.at(sku)->model, pose);
  } else {
    dress_body(m(), d(), made, store.goods[sku], pose);
  }
  std::fill_n(geom_material.begin() + made.geom, made.parts, sku_material[sku]);
}

// Not while it is bent, nor while an actor is within its box: a gripper that holds it by the seam
// would find itself inside the still shape.
bool World::State::may_rest(std::size_t body) const {
  const PoolBody& made = store.pool[body];
  if (!made.soft()) return true;
  if (!lies_in_its_box(m(), d(), made.body)) return false;
  const auto product = static_cast<std::uint32_t>(live[body].product);
  const Box3 box = box_at(product, shape_pose(product));
  return std::ranges::none_of(actor_geoms, [&](int geom) {
    const Vec3 center = vec3_of(d().geom_xpos + 3 * geom);
    const double radius = m().geom_rbound[geom];
    const Vec3 half{radius, radius, radius};
    return box.meets({center - half, center + half}, near_actor_m);
  });
}

void World::State::wake_kept() {
  for (std::size_t body = 0; body < live.size(); ++body) {
    if (live[body].keeps) mark_wake(d(), store.pool[body]);
  }
}

// Every part by its share of the mass: together they act at the middle of mass, and bend nothing.
void World::State::push_body(std::size_t body, const Wrench& wrench) {
  const PoolBody& made = store.pool[body];
  const Vec3 &f = wrench.force_n, &t = wrench.torque_n_m;
  for (int part = made.body; part < made.body + made.parts; ++part) {
    const double share = m().body_mass[part] / m().body_subtreemass[made.body];
    const mjtNum applied[6] = {
        share * f.x, share * f.y, share * f.z, share * t.x, share * t.y, share * t.z};
    std::copy(applied, applied + 6, d().xfrc_applied + 6 * part);
  }
  mark_wake(d(), made);
}

}  // namespace marketgen
