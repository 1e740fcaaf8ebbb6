#include <algorithm>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/loft.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"
#include "base/hash.h"
#include "base/seed.h"
#include "geometry/circle.h"

namespace marketgen::assets {
namespace {

constexpr int stem_triangles = 60;

// How a fruit departs from a sphere. Lengths in radii of the sphere.
struct FruitForm {
  float top_dimple = 0.22F, bottom_dimple = 0.12F;  // depth of the hollows at the poles
  float shoulder = 0.06F;                           // wider above the middle (below: negative)
  float neck = 0;                                   // narrowing of the upper half, pears
  float tip = 0;                                    // points at both poles, lemons
  int lobes = 5;
  float lobe = 0.012F;
  float stem = 0.14F;  // rise over the dimple's floor; 0: none
  float wobble = 0;    // how far cross-sections stray from the axis
};

// By the picture that the row names; otherwise by its proportions.
FruitForm fruit_form_of(const catalog::Product& product) {
  const std::string& motif = product.label.motif;
  const int width = std::min(product.size_mm[0], product.size_mm[1]), height = product.size_mm[2];
  if (motif == "lemon")
    return {.top_dimple = 0, .bottom_dimple = 0, .shoulder = 0, .tip = 0.22F, .lobe = 0, .stem = 0};
  if (motif == "potato") {
    return {.top_dimple = 0,
            .bottom_dimple = 0,
            .shoulder = 0.08F,
            .lobes = 2,
            .lobe = 0.05F,
            .stem = 0,
            .wobble = 0.07F};
  }
  if (motif == "orange")
    return {
        .top_dimple = 0.05F, .bottom_dimple = 0.03F, .shoulder = 0, .lobe = 0.004F, .stem = 0.03F};
  if (100 * height > 118 * width)
    return {.top_dimple = 0.05F, .shoulder = 0, .neck = 0.42F, .stem = 0.22F};
  if (100 * height < 85 * width)
    return {.top_dimple = 0.16F, .bottom_dimple = 0.05F, .shoulder = 0.02F, .lobe = 0.02F};
  return {};
}

// Height and radius of the outline, `turn` from the lower pole (-0.25) to the upper (0.25), for a
// unit sphere.
Vec2f fruit_outline(const FruitForm& form, double turn) {
  const Vec2 on_circle = unit_circle(turn);
  const auto out = static_cast<float>(on_circle.x), up = static_cast<float>(on_circle.y);
  const float near_pole = (1 - out * out) * (1 - out * out);
  const float upper = std::max(0.0F, up);
  float radius = out * (1 + form.shoulder * up);
  radius *= 1 - form.neck * upper * upper * (3 - 2 * upper) * (1 - 0.35F * upper);
  const float hollow = near_pole * near_pole;
  float z = up - (up > 0 ? form.top_dimple : -form.bottom_dimple) * hollow;
  z += form.tip * up * near_pole * near_pole;
  return {radius, z};
}

void add_fruit(PackBuilder& pack, const FruitForm& form, double own_turn, std::uint16_t skin) {
  constexpr int bands = 18;
  std::vector<Section> sections;
  for (int i = 0; i <= bands; ++i) {
    const Vec2f p = fruit_outline(form, -0.25 + 0.5 * i / bands);
    const float radius = i == 0 || i == bands ? 0.0F : p.x;
    const Vec2 stray = unit_circle(1.7 * i / bands + own_turn);
    const float swell = 1 - p.y * p.y;  // lobes die out towards the poles, a dimple keeps a little
    sections.push_back({.z = 1 + p.y,
                        .half_width = radius,
                        .half_depth = radius,
                        .surface = skin,
                        .lobe = form.lobe * std::max(swell, 0.4F),
                        .x = form.wobble * static_cast<float>(stray.x),
                        .y = form.wobble * static_cast<float>(stray.y)});
  }
  add_loft(pack,
           sections,
           {.triangles = pack_triangles - stem_triangles,
            .lobes = form.lobes,
            .lobe_turn = static_cast<float>(own_turn)});
}

void add_stem(PackBuilder& pack, const FruitForm& form, std::uint16_t wood) {
  const float floor = 1 + fruit_outline(form, 0.25).y;
  const float thick = form.stem < 0.1F ? 0.09F : 0.045F;
  const auto ring = [&](float z, float share, float x) {
    return Section{
        .z = z, .half_width = share * thick, .half_depth = share * thick, .surface = wood, .x = x};
  };
  add_loft(pack,
           {ring(floor - 0.03F, 1, 0),
            ring(floor + 0.5F * form.stem, 0.8F, 0.01F),
            ring(floor + form.stem, 1.1F, 0.035F)},
           {.triangles = stem_triangles});
}

}  // namespace

Result<ProductModel> make_round_produce(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const std::uint16_t skin = pack.add_print(skin_roughness);
  const FruitForm form = fruit_form_of(product);
  add_fruit(pack, form, Seed(hash64(product.sku)).stream().uniform(), skin);
  if (form.stem > 0) {
    const Vec3f stem_brown{0.10F, 0.075F, 0.03F};
    const std::uint16_t stem = pack.add_surface({.color = stem_brown, .roughness = 0.9F});
    add_stem(pack, form, stem);
    pack.add_surface_feature(FeatureKind::stem, stem);
  }
  return pack.finish(0.2F);
}

CollisionPrimitive collision_round_produce(const catalog::Product& product) {
  return ellipsoid_around(product);
}

}  // namespace marketgen::assets
