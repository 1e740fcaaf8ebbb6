#include "physics/settle/penetration.h"

#include <algorithm>
#include <map>
#include <span>

#include "assets/product_model.h"
#include "physics/goods/spec_geoms.h"

namespace marketgen::physics {
namespace {

constexpr char penetration_where[] = "collision check";

// A model that holds the items, each as one static geom in the order of `items`.
Result<MujocoModel> model_of(const scene::Scene& scene, const std::vector<std::uint32_t>& items) {
  const MujocoSpec spec(mj_makeSpec(), mj_deleteSpec);
  mjsBody* world = mjs_findBody(spec.get(), "world");
  for (const std::uint32_t row : items) {
    const scene::SceneProduct& item = scene.products[row];
    MARKETGEN_TRY(const assets::CollisionPrimitive primitive,
                  assets::collision_of(scene.catalog[item.sku]));
    add_shape(world, scene::world_from_product(item) * assets::contact_shape_of(primitive));
  }
  return compile(*spec, penetration_where);
}

// Appends the depths of the pairs, by one model that holds their items.
Result<void> measure(const scene::Scene& scene,
                     std::span<const ProductPair> pairs,
                     std::vector<double>& depths) {
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
  return {};
}

}  // namespace

// MuJoCo takes a time that grows with the square of what a model holds to add to it: many small
// models are made instead of a large one.
Result<std::vector<double>> penetration_depths(const scene::Scene& scene,
                                               const std::vector<ProductPair>& pairs) {
  constexpr std::size_t pairs_of_a_model = 200;
  std::vector<double> depths;
  depths.reserve(pairs.size());
  for (std::size_t first = 0; first < pairs.size(); first += pairs_of_a_model) {
    const std::size_t count = std::min(pairs_of_a_model, pairs.size() - first);
    MARKETGEN_CHECK(measure(scene, std::span(pairs).subspan(first, count), depths));
  }
  return depths;
}

}  // namespace marketgen::physics
