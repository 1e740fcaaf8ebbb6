#include "physics/world/world_state.h"

#include "geometry/pose.h"

namespace marketgen::physics {
namespace {

// By MuJoCo's tree: an actuator moves a joint of it.
std::vector<bool> driven_trees(const mjModel& m) {
  std::vector<bool> driven(static_cast<std::size_t>(m.ntree), false);
  const auto note = [&](int joint) {
    driven[static_cast<std::size_t>(m.dof_treeid[m.jnt_dofadr[joint]])] = true;
  };
  for (int actuator = 0; actuator < m.nu; ++actuator) {
    const int target = m.actuator_trnid[2 * actuator];
    if (m.actuator_trntype[actuator] == mjTRN_JOINT) note(target);
    if (m.actuator_trntype[actuator] != mjTRN_TENDON) continue;
    for (int wrap = m.tendon_adr[target]; wrap < m.tendon_adr[target] + m.tendon_num[target];
         ++wrap)
      if (m.wrap_type[wrap] == mjWRAP_JOINT) note(m.wrap_objid[wrap]);
  }
  return driven;
}

bool can_move(const mjModel& m, int body) {
  return m.body_treeid[body] >= 0 || m.body_mocapid[m.body_rootid[body]] >= 0;
}

}  // namespace

Pose pose_of(const ShapePose& shape) {
  const auto& p = shape.position;
  const auto& q = shape.rotation;
  return {{p[0], p[1], p[2]}, {q[0], q[1], q[2], q[3]}};
}

ShapePose shape_pose_of(const Pose& pose) {
  const Vec3& p = pose.position;
  const Quaternion& q = pose.rotation;
  return {{p.x, p.y, p.z}, {q.w, q.x, q.y, q.z}};
}

World::State::State(const scene::Scene& scene_in,
                    WorldOptions options_in,
                    StoreModel store_in,
                    MujocoData data_in)
    : scene(scene_in),
      options(std::move(options_in)),
      store(std::move(store_in)),
      data(std::move(data_in)),
      near(*store.model, store.still_body),
      grid(scene.products.size()),
      frictions(options.frictions),
      belt_geoms(scene.joints.size()),
      body_of(scene.products.size(), -1),
      live(store.pool.size()),
      refused(scene.products.size(), false),
      belt_speed(scene.joints.size(), 0),
      looked_at(scene.joints.size(), 0),
      hulls(*store.model) {
  for (std::size_t sku = 0; sku < scene.catalog.size(); ++sku) {
    sku_material.push_back(frictions.material(scene.catalog[sku].material));
    shape_from_product.push_back(inverse(store.goods[sku].shape.pose));
  }
  geom_material.assign(store.owners.size(), FrictionTable::unknown);
  for (int geom = 0; geom < m().ngeom; ++geom) {
    const GeomOwner& owner = store.owners[static_cast<std::size_t>(geom)];
    auto& material = geom_material[static_cast<std::size_t>(geom)];
    if (owner.kind == BodyKind::room) {
      material = frictions.material(room_material);
    } else if (owner.kind == BodyKind::fixture) {
      const std::int32_t joint = scene.parts[owner.row].joint;
      const bool belt = joint >= 0 && scene.joints[static_cast<std::size_t>(joint)].kind ==
                                          assets::JointKind::belt;
      material = frictions.material(belt ? belt_material : reference_material);
      if (belt) belt_geoms[static_cast<std::size_t>(joint)].push_back(geom);
    } else if (owner.kind == BodyKind::product && !owner.pool) {
      material = sku_material[sku_of(owner.row)];
      grid.put(owner.row, box_at(owner.row, geom_pose(m(), geom)));
    } else if (owner.kind == BodyKind::actor) {
      const char* name = mj_id2name(&m(), mjOBJ_GEOM, geom);
      const auto named = options.actor_materials.find(name == nullptr ? "" : name);
      if (named != options.actor_materials.end()) material = frictions.material(named->second);
      const bool collides = m().geom_contype[geom] != 0 || m().geom_conaffinity[geom] != 0;
      const int body = m().geom_bodyid[geom];
      const char* of = mj_id2name(&m(), mjOBJ_BODY, body);
      const bool keeps_clear = of != nullptr && options.bystanders.contains(of);
      if (collides && can_move(m(), body) && !keeps_clear) actor_geoms.push_back(geom);
      if (collides && m().body_treeid[body] >= 0) jointed_geoms.push_back(geom);
    }
  }
  loose_rows.assign(scene.products.size(), false);
  for (const std::uint32_t product : options.loose)
    loose_rows[product] = true;
  find_hands();
  find_fixture_trees();
  find_gaskets();
  find_cups();
  for (const PoolBody& body : store.pool)
    park_body(m(), d(), body);
  shorten_bit_filter(m(), store.still_body);
}

// What hangs on no joint is moved from outside, or carries what moves.
void World::State::find_hands() {
  const std::vector<bool> driven = driven_trees(m());
  hand_geoms.assign(store.owners.size(), false);
  for (int geom = 0; geom < m().ngeom; ++geom) {
    const int tree = m().body_treeid[m().geom_bodyid[geom]];
    hand_geoms[static_cast<std::size_t>(geom)] =
        store.owners[static_cast<std::size_t>(geom)].kind == BodyKind::actor &&
        (tree < 0 || driven[static_cast<std::size_t>(tree)]);
  }
}

void World::State::find_fixture_trees() {
  std::map<int, FixtureTree> by_tree;
  for (std::uint32_t joint = 0; joint < store.joints.size(); ++joint) {
    const JointAddress& at = store.joints[joint];
    if (at.dof < 0) continue;
    by_tree[m().dof_treeid[at.dof]].joints.push_back(joint);
    looked_at[joint] = d().qpos[at.qpos];
  }
  for (int geom = 0; geom < m().ngeom; ++geom) {
    const auto found = by_tree.find(m().body_treeid[m().geom_bodyid[geom]]);
    if (found != by_tree.end()) found->second.geoms.push_back(geom);
  }
  for (auto& [tree, fixture] : by_tree) {
    fixture.tree = tree;
    fixture_trees.push_back(std::move(fixture));
  }
}

ShapePose World::State::shape_pose(std::uint32_t product) const {
  if (body_of[product] < 0) return geom_pose(m(), store.product_geom[product]);
  return shape_pose_of(product_pose(product) * store.goods[sku_of(product)].shape.pose);
}

Pose World::State::product_pose(std::uint32_t product) const {
  if (!moved.contains(product)) return scene::world_from_product(scene.products[product]);
  const int body = body_of[product];
  if (body < 0) return pose_of(shape_pose(product)) * shape_from_product[sku_of(product)];
  const auto has = static_cast<std::size_t>(body);
  return world_from_body(has) * inverse(product_from_body(has));
}

Box3 World::State::box_at(std::uint32_t product, const ShapePose& pose) const {
  assets::ContactShape shape = store.goods[sku_of(product)].shape;
  shape.pose = pose_of(pose);
  const Vec3 half = assets::half_extents(shape);
  return {shape.pose.position - half, shape.pose.position + half};
}

void World::State::report(EventKind kind, std::uint32_t product) {
  events.push_back({kind, product, d().time});
}

void World::State::update_running_belts() {
  running_belts.clear();
  for (std::size_t joint = 0; joint < belt_speed.size(); ++joint) {
    if (belt_speed[joint] == 0) continue;
    for (const int geom : belt_geoms[joint]) {
      const std::uint32_t part = store.owners[static_cast<std::size_t>(geom)].row;
      assets::ContactShape shape = contact_shape_of(scene.parts[part]);
      shape.pose = pose_of(geom_pose(m(), geom));
      const Vec3 half = assets::half_extents(shape);
      running_belts.push_back({shape.pose.position - half, shape.pose.position + half});
    }
  }
}

}  // namespace marketgen::physics
