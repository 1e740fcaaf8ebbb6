#include "assets/shapes/archetypes/growth.h"

#include "base/hash.h"
#include "base/text.h"
#include "geometry/circle.h"

namespace marketgen::assets {

Seed growth_seed(const catalog::Product& product) {
  return Seed(hash64(product.sku)).child("growth");
}

bool has_word(const catalog::Product& product, std::string_view words) {
  if (words.empty()) return true;
  const std::string text = lower_ascii(product.variant + " " + product.name);
  for (const std::string& word : marketgen::split(words, '|')) {
    if (text.find(word) != std::string::npos) return true;
  }
  return false;
}

Placement lying_along_x(float length) {
  return [length](Vec3f p) { return Vec3f{length / 2 - p.z, p.x, -p.y}; };
}

PlantFrame plant_frame(const PackBuilder& pack, bool lying) {
  if (lying) return {pack.depth(), pack.height(), pack.width(), lying_along_x(pack.width())};
  return {pack.width(), pack.depth(), pack.height(), PartFrame{}};
}

Vec2 draw_on_circle(Stream& draw) {
  return unit_circle(draw.uniform());
}

}  // namespace marketgen::assets
