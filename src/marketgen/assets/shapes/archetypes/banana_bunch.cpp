#include <algorithm>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/foliage.h"
#include "assets/shapes/archetypes/fruit.h"
#include "assets/shapes/archetypes/growth.h"
#include "assets/shapes/archetypes/registry.h"

namespace marketgen::assets {
namespace {

constexpr int min_bananas = 4, max_bananas = 6;
constexpr int segments = 14, bands = 14;

// In shares of the pack's half sizes: the hand rests on its tips, the crown is at the upper left.
// Position along the fan -1 (front) .. 1 (back).
TubeForm banana(float fan, float longer, Vec3f half) {
  const float thick = std::min({banana_thickness * half.z, 0.36F * half.y, 0.3F * half.x});
  const float spread = fan * half.y;
  const auto at = [&](float x, float share, float z) {
    return Vec3f{x * half.x, share * spread, z * half.z};
  };
  TubeForm form;
  form.up = {0, 0.3F, 1};
  const float tip = 0.78F + 0.2F * longer;
  form.knots = {{at(tip, 0.80F, -0.72F), 0.22F * thick, 0.22F * thick},
                {at(tip - 0.06F, 0.81F, -0.62F), 0.32F * thick, 0.32F * thick},
                {at(tip - 0.16F, 0.82F, -0.42F), 0.78F * thick, 0.78F * thick},
                {at(0.42F, 0.82F, -0.05F), thick, thick},
                {at(0.08F, 0.80F, 0.22F), 1.05F * thick, 1.05F * thick},
                {at(-0.28F, 0.72F, 0.40F), thick, thick},
                {at(-0.58F, 0.55F, 0.55F), 0.66F * thick, 0.66F * thick},
                {at(-0.78F, 0.36F, 0.68F), 0.36F * thick, 0.40F * thick},
                {at(-0.96F, 0.26F, 0.80F), 0.34F * thick, 0.38F * thick}};
  form.low_round_m = 0.08F * thick;
  form.high_round_m = 0.2F * thick;
  return form;
}

void add_crown(PackBuilder& pack, Vec3f half) {
  const std::uint16_t cut = pack.add_surface(plant({0.16F, 0.13F, 0.035F}));
  const float thick = 0.17F * half.z;
  TubeForm crown;
  const auto knot = [&](float y, float share) {
    crown.knots.push_back(
        {{-0.93F * half.x, y * half.y, 0.80F * half.z}, share * thick, 1.1F * share * thick});
  };
  knot(-0.36F, 0.8F);
  knot(-0.12F, 1.1F);
  knot(0.12F, 1.15F);
  knot(0.36F, 0.8F);
  crown.low_round_m = crown.high_round_m = 0.8F * thick;
  add_tube(pack, {cut}, 12, 4, crown);
}

}  // namespace

Result<ProductModel> make_banana_bunch(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  Stream draw = growth_seed(product).stream();
  const std::uint16_t skin = pack.add_print(0.45F);
  const Vec3f half = Vec3f{pack.width(), pack.depth(), pack.height()} * 0.5F;
  const int count = draw.integer(min_bananas, max_bananas);
  for (int i = 0; i < count; ++i) {
    const float fan = 2 * static_cast<float>(i) / static_cast<float>(count - 1) - 1;
    const auto longer = static_cast<float>(draw.uniform(0.2, 1));
    // The sticker of one banana only faces the shopper.
    const int turned = i == count / 2 ? 0 : segments / 2;
    add_tube(pack, {skin, 0, 1, turned}, segments, bands, banana(fan, longer, half));
  }
  const std::size_t mark = pack.triangle_count();
  add_crown(pack, half);
  pack.add_part_feature(FeatureKind::stem, mark);
  return pack.finish(0.2F);
}

CollisionPrimitive collision_banana_bunch(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
