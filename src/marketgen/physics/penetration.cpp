#include "physics/penetration.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <map>
#include <memory>

#include "assets/product_model.h"

namespace marketgen {
namespace {

struct Model {
  std::unique_ptr<mjModel, decltype(&mj_deleteModel)> model{nullptr, mj_deleteModel};
  std::unique_ptr<mjData, decltype(&mj_deleteData)> data{nullptr, mj_deleteData};
};

mjtGeom geom_type(CollisionShape shape) {
  switch (shape) {
    case CollisionShape::box:
      return mjGEOM_BOX;
    case CollisionShape::cylinder:
      return mjGEOM_CYLINDER;
    default:
      return mjGEOM_ELLIPSOID;
  }
}

void add_item(mjsBody* world, const CollisionPrimitive& primitive, const SceneProduct& item) {
  Pose item_from_geom{to_double(primitive.center), {}};
  if (primitive.lying)
    item_from_geom.rotation = rotation_from_half_tangent({0, 1, 0}, 1.0);  // Z onto X
  const Pose world_from_geom = world_from_product(item) * item_from_geom;
  mjsGeom* geom = mjs_addGeom(world, nullptr);
  geom->type = geom_type(primitive.shape);
  const Vec3 p = world_from_geom.position;
  const Quaternion& q = world_from_geom.rotation;
  const double position[3] = {p.x, p.y, p.z}, rotation[4] = {q.w, q.x, q.y, q.z};
  const bool cylinder = primitive.shape == CollisionShape::cylinder;
  const double size[3] = {primitive.half_size.x,
                          cylinder ? primitive.half_size.z : primitive.half_size.y,
                          primitive.half_size.z};
  std::copy(position, position + 3, geom->pos);
  std::copy(rotation, rotation + 4, geom->quat);
  std::copy(size, size + 3, geom->size);
}

// A model that holds the items, each as one static geom in the order of `items`.
Result<Model> model_of(const Scene& scene, const std::vector<std::uint32_t>& items) {
  const std::unique_ptr<mjSpec, decltype(&mj_deleteSpec)> spec(mj_makeSpec(), mj_deleteSpec);
  mjsBody* world = mjs_findBody(spec.get(), "world");
  for (const std::uint32_t item : items) {
    MARKETGEN_TRY(const CollisionPrimitive primitive,
                  collision_of(scene.catalog[scene.products[item].sku]));
    add_item(world, primitive, scene.products[item]);
  }
  Model built;
  built.model.reset(mj_compile(spec.get(), nullptr));
  if (built.model == nullptr)
    return Error{"physics.failed", "collision check", mjs_getError(spec.get())};
  built.data.reset(mj_makeData(built.model.get()));
  if (built.data == nullptr)
    return Error{"physics.failed", "collision check", "MuJoCo could not allocate its data"};
  mj_kinematics(built.model.get(), built.data.get());
  return built;
}

}  // namespace

Result<std::vector<double>> penetration_depths(const Scene& scene,
                                               const std::vector<ProductPair>& pairs) {
  std::vector<double> depths;
  if (pairs.empty()) return depths;
  std::map<std::uint32_t, int> geom_of;
  std::vector<std::uint32_t> items;
  for (const auto& [a, b] : pairs) {
    for (const std::uint32_t item : {a, b}) {
      if (geom_of.try_emplace(item, static_cast<int>(items.size())).second) items.push_back(item);
    }
  }
  MARKETGEN_TRY(const Model built, model_of(scene, items));
  for (const auto& [a, b] : pairs) {
    const double distance = mj_geomDistance(
        built.model.get(), built.data.get(), geom_of.at(a), geom_of.at(b), 0.001, nullptr);
    depths.push_back(std::max(0.0, -distance));
  }
  return depths;
}

}  // namespace marketgen
