#include <algorithm>

#include "assets/shapes/archetypes/bunch.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/foliage.h"
#include "assets/shapes/archetypes/fruit.h"
#include "assets/shapes/archetypes/growth.h"
#include "assets/shapes/archetypes/registry.h"

namespace marketgen::assets {
namespace {

// How one herb's leaves grow. Sizes in shares of the bunch's length.
struct HerbForm {
  std::string_view words;
  int sprigs, leaves;  // leaves of a sprig, in pairs up its stem
  float leaf_length, leaf_width;
  LeafOutline outline;
  float ruffle;
  double first_leaf;  // height up the sprig
};
constexpr HerbForm herb_forms[] = {
    {"chive", 22, 0, 0, 0, LeafOutline::pointed, 0, 1},
    {"rosemary|thyme|dill|tarragon", 10, 11, 0.13F, 0.009F, LeafOutline::pointed, 0, 0.3},
    {"parsley|coriander|cilantro", 12, 8, 0.17F, 0.055F, LeafOutline::spoon, 0.45F, 0.5},
    {"", 11, 7, 0.20F, 0.06F, LeafOutline::oval, 0.12F, 0.42}};

const HerbForm& herb_form_of(const catalog::Product& product) {
  return *std::find_if(std::begin(herb_forms), std::end(herb_forms), [&](const HerbForm& form) {
    return has_word(product, form.words);
  });
}

constexpr float tie_share = 0.3F;  // of the length

void add_sprig(PackBuilder& pack,
               std::uint16_t skin,
               const HerbForm& form,
               const PlantFrame& frame,
               Vec2f fan,
               Stream draw) {
  const float end = frame.length * static_cast<float>(draw.uniform(0.8, 0.95));
  const auto at = [&](float t) {
    const float open = std::max(0.35F * (1 - t / tie_share), (t - tie_share) / (1 - tie_share));
    return Vec3f{fan.x * (0.12F + 0.36F * open) * frame.across,
                 fan.y * (0.14F + 0.32F * open) * frame.thick,
                 t * end};
  };
  const float thin = 0.0065F * frame.length;
  TubeForm stem;
  stem.up = plant_front;
  stem.knots = {{at(0), thin, thin},
                {at(tie_share), thin, thin},
                {at(0.65F), 0.8F * thin, 0.8F * thin},
                {at(1), 0.4F * thin, 0.4F * thin}};
  add_tube(pack, {skin, 0.6F, 1}, 6, 6, stem, frame.place);
  for (int i = 0; i < form.leaves; ++i) {
    const bool crown = i + 1 == form.leaves;
    const auto up = static_cast<float>(form.first_leaf + (1 - form.first_leaf) * i / form.leaves);
    const Vec3f foot = at(up);
    const float side = i % 2 == 0 ? -1.0F : 1.0F;
    const float reach =
        form.leaf_length * frame.length * static_cast<float>(draw.uniform(0.75, 1.1));
    LeafForm leaf;
    leaf.foot = foot;
    leaf.tip = foot + Vec3f{crown ? 0.0F : side * 0.75F * reach,
                            static_cast<float>(draw.uniform(-0.35, 0.35)) * reach,
                            crown ? reach : 0.6F * reach};
    leaf.tip.z = std::min(leaf.tip.z, frame.length);
    leaf.up = normalized(Vec3f{0.2F * side, -1, -0.3F});
    leaf.half_width = form.leaf_width * frame.length;
    leaf.outline = form.outline;
    leaf.ruffle = form.ruffle;
    leaf.arch = 0.12F;
    leaf.curl = 0.1F;
    leaf.segments = 6;
    add_leaf(pack, {skin, 0.0F, 0.55F}, leaf, frame.place);
  }
}

}  // namespace

Result<ProductModel> make_herb_bunch(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const Seed seed = growth_seed(product);
  Stream draw = seed.stream();
  const PlantFrame frame = plant_frame(pack, lies_along_x(product));
  const std::uint16_t skin = pack.add_print(0.7F);
  const HerbForm& form = herb_form_of(product);
  for (int i = 0; i < form.sprigs; ++i) {
    const float spread = 2 * (static_cast<float>(i) + 0.5F) / static_cast<float>(form.sprigs) - 1;
    add_sprig(pack,
              skin,
              form,
              frame,
              {spread, static_cast<float>(draw.uniform(-1, 1))},
              seed.child("sprig", static_cast<std::uint64_t>(i)).stream());
  }
  const Vec3f string_white{0.6F, 0.58F, 0.5F};
  add_rubber_band(pack,
                  string_white,
                  0.28F * frame.length,
                  {0.16F * frame.across, 0.19F * frame.thick},
                  0.011F * frame.length,
                  frame.place);
  return pack.finish(0.2F);
}

CollisionPrimitive collision_herb_bunch(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
