#include "physics/penetration.h"

#include <algorithm>
#include <map>

#include "assets/product_model.h"
#include "physics/spec_geoms.h"

namespace marketgen {
namespace {

constexpr char penetration_where[] = "collision check";

// A model that holds the items, each as one static geom in the order of `items`.
Result<MujocoModel> model_of(const Scene& scene, const std::vector<std::uint32_t>& items) {
  const MujocoSpec spec(mj_makeSpec(), mj_deleteSpec);
  mjsBody* world = mjs_findBody(spec.get(), "world");
  for (const std::uint32_t row : items) {
    const SceneProduct& item = scene.products[row];
    MARKETGEN_TRY(const CollisionPrimitive primitive, collision_of(scene.catalog[item.sku]));
    add_shape(world, world_from_product(item) * contact_shape_of(primitive));
  }
  return compile(*spec, penetration_where);
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
  MARKETGEN_TRY(const MujocoModel model, model_of(scene, items));
  MARKETGEN_TRY(const MujocoData data, make_data(*model, penetration_where));
  mj_kinematics(model.get(), data.get());
  for (const auto& [a, b] : pairs) {
    const double distance =
        mj_geomDistance(model.get(), data.get(), geom_of.at(a), geom_of.at(b), 0.001, nullptr);
    depths.push_back(std::max(0.0, -distance));
  }
  return depths;
}

}  // namespace marketgen
