#include <algorithm>
#include <cmath>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/loft.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {
namespace {

// Shares of the length or of the greatest radius.
struct LongForm {
  float tip_radius = 0.80F;   // before rounding, at the free end
  float stem_radius = 0.92F;  // at the stem end
  float tip_length = 0.16F;   // over which the free end rounds off
  float stem_length = 0.10F;
  float stalk = 0;  // length of a stalk of a third of the radius
};

// By the picture that the row names; a cucumber otherwise.
LongForm long_form_of(const catalog::Product& product) {
  const std::string& motif = product.label.motif;
  if (motif == "banana")
    return {.tip_radius = 0.62F,
            .stem_radius = 0.66F,
            .tip_length = 0.14F,
            .stem_length = 0.10F,
            .stalk = 0.13F};
  if (motif == "carrot")
    return {.tip_radius = 0.30F, .stem_radius = 1.0F, .tip_length = 0.10F, .stem_length = 0.07F};
  if (motif == "chili")
    return {.tip_radius = 0.12F,
            .stem_radius = 0.95F,
            .tip_length = 0.06F,
            .stem_length = 0.08F,
            .stalk = 0.12F};
  if (motif == "corn")
    return {.tip_radius = 0.62F, .stem_radius = 0.90F, .tip_length = 0.14F, .stem_length = 0.08F};
  return {};
}

// A quarter circle's height at share t of its width, 0 at the end of the fruit.
float rounded_end(float t) {
  const float s = std::clamp(t, 0.0F, 1.0F);
  return std::sqrt(std::max(0.0F, s * (2 - s)));
}

// Share of the greatest radius at share t of the length, from the tip (0) to the stem (1).
float long_radius(const LongForm& form, float t) {
  const float body_end = 1 - form.stalk;
  const float along = std::min(t / body_end, 1.0F);
  const float middle = along * 2 - 1;
  const float end_radius = middle < 0 ? form.tip_radius : form.stem_radius;
  const float taper = 1 - (1 - end_radius) * middle * middle *
                              (form.tip_radius < 0.5F ? std::abs(middle) * 0.3F + 0.7F : 1.0F);
  const float body =
      taper * rounded_end(along / form.tip_length) * rounded_end((1 - along) / form.stem_length);
  if (form.stalk <= 0) return body;
  const float stalk = 0.30F * rounded_end((1 - t) / 0.015F) *
                      std::clamp((t - body_end + 0.12F) / 0.06F, 0.0F, 1.0F);
  return std::max(body, stalk);
}

// Closer together at the ends, where the outline turns.
std::vector<float> stations(const LongForm& form) {
  std::vector<float> t{0};
  for (const float s : {0.06F, 0.25F, 0.55F})
    t.push_back(form.tip_length * s);
  const float high = 1 - form.stalk;
  for (int i = 0; i <= 10; ++i) {
    t.push_back(form.tip_length +
                (high - form.stem_length - form.tip_length) * static_cast<float>(i) / 10);
  }
  for (const float s : {0.45F, 0.75F, 0.94F})
    t.push_back(high - form.stem_length * (1 - s));
  if (form.stalk > 0) {
    for (const float z : {high, 1 - 0.3F * form.stalk, 0.99F})
      t.push_back(z);
  }
  t.push_back(1);
  return t;
}

// Bends the straight fruit (its axis Z from tip to stem, 0..length) into an arc that sinks by `sag`
// at both ends, and lays it along X. Positive sag bends in the plane of the shelf, ends to the
// back; negative upright, ends down.
Placement laid_along_x(float length, float sag) {
  return [length, sag](Vec3f p) {
    const float s = 2 * p.z / length - 1;
    const float depth = std::abs(sag);
    const float slope = 4 * depth * s / length;  // of the parabola sag * s^2
    const float level = 1 / std::sqrt(1 + slope * slope);
    const bool flat = sag >= 0;
    const float across = flat ? p.x : p.y;  // towards the inside of the bend
    const float other = flat ? -p.y : p.x;
    const float along = -(p.z - length / 2) + across * slope * level;
    const float bend = depth * s * s + across * level;
    return flat ? Vec3f{along, bend, other} : Vec3f{along, other, -bend};
  };
}

}  // namespace

// The stem end lies to the left. Whatever depth and height differ by is the bend.
Result<ProductModel> make_elongated_produce(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const std::uint16_t skin = pack.add_print(skin_roughness);
  const LongForm form = long_form_of(product);
  const float thin = std::min(pack.depth(), pack.height()),
              wide = std::max(pack.depth(), pack.height());
  const float sag = std::max(wide - thin, 0.06F * thin);
  const float radius = std::min(thin, wide - 0.5F * sag) / 2;

  std::vector<Section> sections;
  for (const float t : stations(form)) {
    const float r = t <= 0 || t >= 1 ? 0.0F : radius * long_radius(form, t);
    sections.push_back({.z = t * pack.width(), .half_width = r, .half_depth = r, .surface = skin});
  }
  const float turned_sag = pack.depth() >= pack.height() ? sag : -sag;
  add_loft(pack, sections, {}, laid_along_x(pack.width(), turned_sag));
  if (form.stalk > 0) {
    const float left = -pack.width() / 2;
    pack.add_band_feature(FeatureKind::stem, left, left + form.stalk * pack.width(), PackAxis::x);
  }
  return pack.finish(0.2F);
}

CollisionPrimitive collision_elongated_produce(const catalog::Product& product) {
  return lying_cylinder_around(product);
}

}  // namespace marketgen::assets
