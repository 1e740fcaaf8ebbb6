#include "episodes/episode_origin.h"

#include <fmt/format.h>

namespace marketgen::episodes {

EpisodeSpec begun_spec(
    std::string_view kind, const EpisodeOrigin& origin, Seed seed, int index, Seed own) {
  EpisodeSpec spec;
  spec.id =
      fmt::format("{}/{}/{:016x}/{}", kind, origin.scene_hash.substr(0, 8), seed.value(), index);
  spec.store = origin.store;
  spec.scene_hash = origin.scene_hash;
  spec.plan_hash = origin.plan_hash;
  spec.seed = own.value();
  return spec;
}

EpisodeSpec repetition_of(EpisodeSpec spec, int number) {
  if (number > 1)
    spec.seed = Seed(spec.seed).child("repetition", static_cast<std::uint64_t>(number)).value();
  return spec;
}

std::string spoken_product(const catalog::Product& product) {
  const std::string variant = product.variant.empty() ? "" : " " + product.variant;
  return fmt::format("{} {}{} ({})", product.brand, product.name, variant, product.net);
}

std::vector<catalog::Product> store_stock(const scene::Scene& scene) {
  std::vector<bool> on_offer(scene.catalog.size());
  for (const scene::SceneProduct& product : scene.products)
    on_offer[product.sku] = true;
  std::vector<catalog::Product> stock;
  for (std::size_t row = 0; row < scene.catalog.size(); ++row)
    if (on_offer[row]) stock.push_back(scene.catalog[row]);
  return stock;
}

}  // namespace marketgen::episodes
