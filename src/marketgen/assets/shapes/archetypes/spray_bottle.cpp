#include <algorithm>

#include "assets/shapes/archetypes/bottle_parts.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/shell.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {
namespace {

// Heights in shares of the bottle's.
constexpr float spray_collar_low = 0.715F, spray_collar_high = 0.785F, spray_head_low = 0.855F;

constexpr float head_front = -0.40F;  // share of the width: where the nozzle sits

float head_half_depth(const PackBuilder& pack) {
  return std::min(0.21F * pack.depth(), 0.0125F);
}

// From the head's coordinates: along the head from its back (+X) to the nozzle (-X), its cross-
// section's x upwards.
PartFrame head_frame(float back, float middle) {
  return {.origin = {back, 0, middle}, .x = {0, 0, 1}, .y = {0, 1, 0}, .z = {-1, 0, 0}};
}

// A sloping back, a long nose.
void add_shroud(PackBuilder& pack, std::uint16_t shroud) {
  const float w = pack.width(), h = pack.height();
  const float back = 0.30F * w, length = back - head_front * w;
  const float high = 0.5F * (1 - spray_head_low) * h, deep = head_half_depth(pack);
  const auto section = [&](float along, float top, float low, float wide, std::uint16_t surface) {
    return Section{.z = along * length,
                   .half_width = (top - low) * high / 2,
                   .half_depth = wide * deep,
                   .surface = surface,
                   .roundness = 0.72F,
                   .x = (top + low) * high / 2};
  };
  add_loft(pack,
           {section(0, 0.10F, -0.62F, 0.45F, shroud),
            section(0.02F, 0.30F, -0.85F, 0.72F, shroud),
            section(0.08F, 0.55F, -0.98F, 0.92F, shroud),
            section(0.18F, 0.78F, -1.0F, 1, shroud),
            section(0.32F, 0.94F, -1.0F, 1, shroud),
            section(0.48F, 1, -1.0F, 1, shroud),
            section(0.60F, 1, -0.86F, 0.98F, shroud),
            section(0.72F, 0.98F, -0.42F, 0.94F, shroud),
            section(0.85F, 0.95F, -0.28F, 0.90F, shroud),
            section(1, 0.92F, -0.22F, 0.86F, shroud),
            section(1, 0.78F, -0.08F, 0.70F, shroud)},
           {.triangles = 520, .max_chords = 6},
           head_frame(back, (1 + spray_head_low) / 2 * h));
}

// The nozzle's square cap, which turns to close.
void add_nozzle_cap(PackBuilder& pack, std::uint16_t nozzle) {
  const float w = pack.width(), h = pack.height();
  const float high = 0.5F * (1 - spray_head_low) * h, deep = head_half_depth(pack);
  const float tip = 0.085F * w, at = 0.35F * high;
  const auto square = [&](float z, float share) {
    return Section{.z = z,
                   .half_width = share * 0.56F * high,
                   .half_depth = share * 0.80F * deep,
                   .surface = nozzle,
                   .roundness = 0.45F,
                   .x = at};
  };
  add_loft(pack,
           {square(-0.004F, 1),
            square(0.86F * tip, 1),
            square(tip, 0.90F),
            square(tip, 0.35F),
            square(0.9F * tip, 0.22F)},
           {.triangles = 240, .max_chords = 4},
           head_frame(head_front * w, (1 + spray_head_low) / 2 * h));
}

// The lever hangs from the head's front and bends towards the bottle's neck, then away for the
// fingers.
void add_trigger(PackBuilder& pack, std::uint16_t surface) {
  const float w = pack.width(), h = pack.height(), deep = std::min(0.22F * pack.depth(), 0.011F);
  const float thick = std::min(0.035F * w, 0.016F * h);
  TubeForm lever;
  lever.up = {0, 1, 0};
  lever.high_round_m = 1.5F * thick;
  lever.knots = {{{-0.17F * w, 0, 0.93F * h}, 1.2F * thick, 0.75F * deep},
                 {{-0.215F * w, 0, 0.865F * h}, 1.2F * thick, 0.8F * deep},
                 {{-0.235F * w, 0, 0.80F * h}, thick, 0.9F * deep},
                 {{-0.285F * w, 0, 0.735F * h}, 0.9F * thick, 0.95F * deep},
                 {{-0.37F * w, 0, 0.695F * h}, 0.75F * thick, 0.85F * deep}};
  add_tube(pack, {.surface = surface}, 12, 14, lever);
}

}  // namespace

// Cleaners with a trigger sprayer; the nozzle looks to the left of who reads the label.
Result<ProductModel> make_spray_bottle(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const LabelZone zone = label_zone_of(product);
  const std::uint16_t body = pack.add_surface(plastic(colors.primary));
  const std::uint16_t print = pack.add_print(film_roughness);
  const std::uint16_t head = pack.add_surface(plastic(colors.secondary));
  const std::uint16_t lever = pack.add_surface(plastic(colors.accent));
  const float h = pack.height(), step = 0.005F * h;

  Profile profile(pack, zone.roundness);
  const float collar = std::min(0.0155F, 0.52F * profile.min_half());
  profile.use(body).pole(0.008F * h).body(0.003F * h, 0.6F).body(0, 0.86F);
  profile.curve_to_body(Curve::swell, 0.022F * h, 1, 5).body(zone.low_m, 1);
  profile.use(print).body(zone.high_m, 1).use(body);
  profile.curve_to_neck(Curve::slope, (spray_collar_low - 0.015F) * h, 0.86F * collar, 10);
  profile.neck(spray_collar_low * h, 0.86F * collar);
  profile.use(head)
      .neck(spray_collar_low * h, 0.98F * collar)
      .neck(spray_collar_low * h + step, collar);
  profile.neck(spray_collar_high * h - step, 0.96F * collar)
      .neck(spray_collar_high * h, 0.88F * collar);
  profile.neck(spray_collar_high * h, 0.70F * collar)
      .neck(0.90F * h, 0.66F * collar)
      .pole(0.90F * h);
  add_loft(pack, profile.sections(), labelled_style(zone, body, 1750));
  add_shroud(pack, head);
  add_nozzle_cap(pack, lever);
  const std::size_t trigger = pack.triangle_count();
  add_trigger(pack, lever);
  pack.add_part_feature(FeatureKind::trigger, trigger);
  pack.add_band_feature(FeatureKind::neck, (spray_collar_low - 0.12F) * h, spray_collar_low * h);
  return pack.finish();
}

CollisionPrimitive collision_spray_bottle(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
