#include <algorithm>

#include "assets/shapes/archetypes/can_parts.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/film_wrap.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {
namespace {

// What stands out of the film: the shoulder, the neck and the end of one can.
void add_can_top(
    PackBuilder& pack, const FilmForm& form, Vec3f place, std::uint16_t wall, std::uint16_t metal) {
  const float h = pack.height(), radius = 0.985F * form.piece_radius_m, low = form.high_m;
  Profile profile(radius);
  profile.use(wall).body(low - 0.025F * h, 0.97F).body(low + 0.012F * h, 0.97F);
  add_can_end(profile, h, 0.82F, metal);
  const PartFrame can{.origin = place};
  add_loft(pack, profile.sections(), {.triangles = 640, .max_chords = 6}, can);
  add_can_tab(pack, h, radius, metal, can);
}

}  // namespace

// Six cans in printed shrink film that leaves their ends free.
Result<ProductModel> make_can_six_pack(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const std::uint16_t print = pack.add_print(film_roughness);
  const std::uint16_t wrap = pack.add_surface(film(colors.primary));
  const std::uint16_t wall = pack.add_surface(lacquered_metal(colors.primary));
  const std::uint16_t metal = pack.add_surface(aluminium());
  const FilmForm form = film_form_of(product);
  const float r = form.piece_radius_m, top = form.high_m;
  const float round = std::min(0.05F * r, 0.03F * top);
  add_film_wall(pack,
                form,
                {{0, 0.14F * r, print},
                 {0.4F * round, 0.07F * r, print},
                 {1.6F * round, 0.02F * r, print},
                 {4 * round, 0, print},
                 {top - 3 * round, 0, print},
                 {top - 1.2F * round, 0.015F * r, print},
                 {top - 0.3F * round, 0.06F * r, print},
                 {top, 0.14F * r, wrap},
                 {top - 0.2F * round, 0.24F * r, wrap}});
  for (int k = 0; k < form.deep; ++k) {
    for (int i = 0; i < form.across; ++i)
      add_can_top(pack, form, piece_place(pack, form, i, k), wall, metal);
  }
  return pack.finish();
}

CollisionPrimitive collision_can_six_pack(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
