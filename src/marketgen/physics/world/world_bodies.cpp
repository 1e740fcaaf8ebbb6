// The bodies of a World's products while they move, rigid or soft: made when first needed, dressed,
// and at rest only when their still shape can take over.
#include <algorithm>

#include "physics/world/world_state.h"

namespace marketgen::physics {
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
  const StandingGoods& goods = store.goods[sku];
  if (!goods.may_be_soft || options.soft_pool == 0 || loose_rows[product]) return nullptr;
  const auto [found, first] = soft.try_emplace(sku);
  if (!first) return found->second ? &*found->second : nullptr;
  const auto make = [&]() -> Result<std::optional<SoftGoods>> {
    MARKETGEN_TRY(const std::optional<SoftPack> pack, soft_pack_of(scene.catalog[sku]));
    if (!pack) return std::optional<SoftGoods>();
    MARKETGEN_TRY(MujocoModel model, soft_model(*pack, goods.contact, scene.catalog[sku].sku));
    if (const double factor = mass_factor(sku); factor != 1) scale_mass(*model, factor);
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

// Its pieces are found on the pack's mesh (30 ms, once in a process).
const RigidRow* World::State::rigid_row(std::uint32_t product) {
  const std::uint32_t sku = sku_of(product);
  const std::pair key(sku, use_of(product));
  if (const auto known = rigid.find(key); known != rigid.end()) return &known->second;
  Result<std::shared_ptr<const RigidGoods>> made = rigid_goods(scene.catalog[sku], key.second);
  if (const double factor = mass_factor(sku); made.ok() && factor != 1)
    made = with_mass(**made, factor);
  if (!made.ok()) {
    fault = made.error();
    return nullptr;
  }
  const mjModel& alone = *(*made)->model;
  const int first_mesh = alone.nmesh > 0 ? hulls.add(alone) : 0;
  return &rigid.emplace(key, RigidRow{*made, first_mesh}).first->second;
}

const RigidRow& World::State::made_row(std::uint32_t product) const {
  return rigid.at({sku_of(product), use_of(product)});
}

bool World::State::make_ready(std::uint32_t product, bool soft_one) {
  return soft_one ? soft_goods(product) != nullptr : rigid_row(product) != nullptr;
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

Pose World::State::product_from_body(std::size_t body) const {
  const auto product = static_cast<std::uint32_t>(live[body].product);
  return store.pool[body].soft() ? store.goods[sku_of(product)].shape.pose
                                 : made_row(product).goods->product_from_body;
}

Pose World::State::world_from_body(std::size_t body) const {
  const mjtNum* q = d().qpos + store.pool[body].qpos;
  mjtNum rotation[4];
  mju_copy(rotation, q + 3, 4);
  mju_normalize4(rotation);
  return {vec3_of(q), {rotation[0], rotation[1], rotation[2], rotation[3]}};
}

// `body` is that product's already, which is made ready.
void World::State::dress(std::size_t body, std::uint32_t product, const Pose& world_from_product) {
  const std::uint32_t sku = sku_of(product);
  const PoolBody& made = store.pool[body];
  const RigidRow* row = made.soft() ? nullptr : &made_row(product);
  dress_body(m(),
             d(),
             made,
             row == nullptr ? *soft.at(sku)->model : *row->goods->model,
             row == nullptr ? 0 : row->first_mesh,
             shape_pose_of(world_from_product * product_from_body(body)));
  std::fill_n(geom_material.begin() + made.geom, made.geoms, sku_material[sku]);
}

// Not where it lies loose: on what moves, or on others that do. Not while it is bent; nor, where
// its still shape is more than the pack, while an actor is within that or another product moves
// there: a gripper that holds it by the seam or the neck would find itself inside.
bool World::State::may_rest(std::size_t body) const {
  const PoolBody& made = store.pool[body];
  const auto product = static_cast<std::uint32_t>(live[body].product);
  if (loose_rows[product]) return false;
  if (made.soft() && !lies_in_its_box(m(), d(), made.body)) return false;
  if (!made.soft() && !made_row(product).goods->hollow) return true;
  const Box3 box = box_at(product, shape_pose(product));
  const bool acted_on = std::ranges::any_of(actor_geoms, [&](int geom) {
    const Vec3 center = vec3_of(d().geom_xpos + 3 * geom);
    const double radius = m().geom_rbound[geom];
    const Vec3 half{radius, radius, radius};
    return box.meets({center - half, center + half}, near_actor_m);
  });
  if (acted_on || made.soft()) return !acted_on;
  for (std::size_t other = 0; other < live.size(); ++other) {
    const bool moves = other != body && live[other].product >= 0 && !asleep(other);
    if (moves && body_box(other).meets(box, -hollow_depth_m)) return false;
  }
  return true;
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

}  // namespace marketgen::physics
