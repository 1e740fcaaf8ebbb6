#include <algorithm>

#include "assets/contents.h"
#include "assets/shapes/archetypes/bottle_parts.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/film_wrap.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/shell.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {
namespace {

constexpr float caps_high = 0.965F;  // share of the height: the carrying tape arches over the caps

void add_bottle_top(
    PackBuilder& pack, const FilmForm& form, Vec3f place, std::uint16_t bottle, std::uint16_t cap) {
  const float high = caps_high * pack.height(), low = form.high_m, above = high - low;
  const float radius = 0.985F * form.piece_radius_m;
  const float cap_radius = std::min(0.015F, 0.40F * radius);
  const float neck_low = high - std::min(0.030F, 0.26F * above);
  Profile profile(radius);
  profile.use(bottle).body(low - 0.08F * above, 0.96F).body(low + 0.05F * above, 0.96F);
  profile.curve_to_neck(Curve::slope, neck_low, 0.86F * cap_radius, 8);
  add_screw_cap(profile, neck_low, high, cap_radius, bottle, cap);
  add_loft(
      pack, profile.sections(), {.triangles = 1000, .max_chords = 6}, PartFrame{.origin = place});
}

// The carrying tape: stuck to the film on both short sides.
void add_tape(PackBuilder& pack, const FilmForm& form, std::uint16_t surface) {
  const float w = pack.width() / 2, h = pack.height(), low = form.high_m;
  const float wide = std::min(0.014F, 0.12F * pack.depth()),
              thin = std::min(0.0006F, 0.01F * wide + 0.0002F);
  const float side = w - 1.2F * thin;
  TubeForm tape;
  tape.up = {0, 1, 0};
  const auto knot = [&](float x, float z) { return TubeKnot{{x, 0, z}, thin, wide}; };
  tape.knots = {knot(-side, 0.72F * low),
                knot(-side, 0.95F * low),
                knot(-0.93F * side, low + 0.40F * (h - low)),
                knot(-0.62F * side, low + 0.86F * (h - low)),
                knot(-0.28F * side, h - thin),
                knot(0.28F * side, h - thin),
                knot(0.62F * side, low + 0.86F * (h - low)),
                knot(0.93F * side, low + 0.40F * (h - low)),
                knot(side, 0.95F * low),
                knot(side, 0.72F * low)};
  add_tube(pack, {.surface = surface}, 8, 40, tape);
}

}  // namespace

// Six bottles in printed shrink film, their shoulders free, carried by a tape.
Result<ProductModel> make_bottle_six_pack(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  MARKETGEN_TRY(Surface wall,
                contents_wall(product, plastic_wall_roughness, clear_plastic(colors.primary)));
  wall.fill = wall.refraction = 0;  // their shoulders alone are seen
  const std::uint16_t print = pack.add_print(film_roughness);
  const std::uint16_t wrap = pack.add_surface(film(colors.primary));
  const std::uint16_t bottle = pack.add_surface(wall);
  const std::uint16_t cap = pack.add_surface(plastic(colors.accent));
  const std::uint16_t tape = pack.add_surface(film(colors.secondary));
  const FilmForm form = film_form_of(product);
  const float r = form.piece_radius_m, top = form.high_m;
  const float round = std::min(0.08F * r, 0.03F * top);
  add_film_wall(pack,
                form,
                {{0, 0.16F * r, print},
                 {0.4F * round, 0.08F * r, print},
                 {1.6F * round, 0.02F * r, print},
                 {4 * round, 0, print},
                 {0.5F * top, 0.01F * r, print},
                 {top - 3 * round, 0, print},
                 {top - 1.2F * round, 0.02F * r, print},
                 {top - 0.3F * round, 0.08F * r, print},
                 {top, 0.18F * r, wrap},
                 {top - 0.4F * round, 0.30F * r, wrap}});
  for (int k = 0; k < form.deep; ++k) {
    for (int i = 0; i < form.across; ++i)
      add_bottle_top(pack, form, piece_place(pack, form, i, k), bottle, cap);
  }
  add_tape(pack, form, tape);
  pack.add_surface_feature(FeatureKind::handle, tape);
  return pack.finish();
}

CollisionPrimitive collision_bottle_six_pack(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
