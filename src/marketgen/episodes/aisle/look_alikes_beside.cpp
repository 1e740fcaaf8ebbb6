#include "episodes/aisle/look_alikes_beside.h"

#include <algorithm>
#include <map>
#include <vector>

#include "catalog/look_alike.h"
#include "geometry/vector.h"

namespace marketgen::episodes {
namespace {

using PlacesBySku = std::map<std::uint32_t, std::vector<Vec3>>;  // rows of Scene::catalog

PlacesBySku places_of(const scene::Scene& scene) {
  PlacesBySku places;
  for (const scene::Facing& facing : scene.facings) {
    if (facing.product_count == 0) continue;
    const auto& at = scene.products[facing.first_product].position_m;
    places[facing.sku].push_back({at[0], at[1], at[2]});
  }
  return places;
}

bool are_beside(const std::vector<Vec3>& some, const std::vector<Vec3>& others) {
  return std::ranges::any_of(some, [&](const Vec3& a) {
    return std::ranges::any_of(others,
                               [&](const Vec3& b) { return length(a - b) <= alike_within_m; });
  });
}

}  // namespace

std::set<std::string> skus_with_look_alikes_beside(const scene::Scene& scene) {
  const PlacesBySku places = places_of(scene);
  std::set<std::string> found;
  for (auto a = places.begin(); a != places.end(); ++a)
    for (auto b = std::next(a); b != places.end(); ++b) {
      const catalog::Product &first = scene.catalog[a->first], &second = scene.catalog[b->first];
      if (!catalog::are_look_alikes(first, second) || !are_beside(a->second, b->second)) continue;
      found.insert(first.sku);
      found.insert(second.sku);
    }
  return found;
}

}  // namespace marketgen::episodes
