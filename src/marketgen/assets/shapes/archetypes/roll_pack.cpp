#include <algorithm>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/film_wrap.h"
#include "assets/shapes/archetypes/profile.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {
namespace {

constexpr Vec3f tissue{0.86F, 0.86F, 0.84F};
constexpr Vec3f core_board{0.42F, 0.33F, 0.24F};
constexpr float core_radius_m = 0.021F;  // cores are 38 to 45 mm across

// How far a roll's rounded end stands out.
float end_rise(float height) {
  return std::min(0.05F * height, 0.012F);
}

// The end of a roll under the film: rounded edge, flat paper, the cardboard core's hole.
void add_roll_end(PackBuilder& pack,
                  const FilmForm& form,
                  Vec3f place,
                  std::uint16_t paper_end,
                  std::uint16_t core) {
  const float h = pack.height(), radius = 0.95F * form.piece_radius_m;
  const float rise = end_rise(h);
  const float hole = std::min(core_radius_m, 0.42F * radius);
  Profile profile(radius);
  profile.use(paper_end).body(h - 2.3F * rise, 1).body(h - 0.55F * rise, 1);
  profile.curve_to_body(Curve::dome, h, 0.90F, 4).neck(h, 1.12F * hole);
  profile.curve_to_neck(Curve::swell, h - 0.12F * rise, 1.02F * hole, 2);
  profile.use(core).neck(h - 0.12F * rise, hole).neck(h - 1.7F * rise, hole).pole(h - 1.7F * rise);
  add_loft(
      pack, profile.sections(), {.triangles = 520, .max_chords = 8}, PartFrame{.origin = place});
}

// The wall from the ground up, drawn in between two layers of rolls.
std::vector<WallLevel> wall_levels(const FilmForm& form, std::uint16_t print, std::uint16_t clear) {
  const float h = form.high_m, r = form.piece_radius_m;
  const float layer = h / static_cast<float>(form.high);
  const float round = std::min(0.10F * r, 0.10F * layer), sink = 0.05F * r;
  std::vector<WallLevel> levels{{0, 2.0F * round, print},
                                {0.15F * round, 1.0F * round, print},
                                {0.5F * round, 0.4F * round, print},
                                {1.1F * round, 0.1F * round, print},
                                {2.0F * round, 0, print}};
  for (int i = 1; i < form.high; ++i) {
    const float z = layer * static_cast<float>(i);
    levels.push_back({z - 1.6F * round, 0, print});
    levels.push_back({z - 0.6F * round, 0.3F * sink, print});
    levels.push_back({z - 0.15F * round, 0.9F * sink, print});
    levels.push_back({z + 0.15F * round, 0.9F * sink, print});
    levels.push_back({z + 0.6F * round, 0.3F * sink, print});
    levels.push_back({z + 1.6F * round, 0, print});
  }
  const float top = h - 0.25F * round;
  levels.push_back({top - 2.0F * round, 0, print});
  levels.push_back({top - 1.1F * round, 0.1F * round, print});
  levels.push_back({top - 0.5F * round, 0.4F * round, print});
  levels.push_back({top - 0.15F * round, 1.0F * round, clear});
  levels.push_back({top, 2.2F * round, clear});
  // Between the rolls the film sinks deeper than their cores are seen.
  levels.push_back({h - 0.8F * end_rise(h), 3.0F * round, clear});
  levels.push_back({h - 2.0F * end_rise(h), 3.3F * round, clear});
  return levels;
}

}  // namespace

// Toilet paper, kitchen rolls: printed film around the rolls; their ends are seen from above.
Result<ProductModel> make_roll_pack(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const std::uint16_t print = pack.add_print(film_roughness);
  const std::uint16_t clear = pack.add_surface(film(colors.secondary));
  const std::uint16_t paper_end = pack.add_surface({.color = tissue, .roughness = 0.55F});
  const std::uint16_t core = pack.add_surface(paper(core_board));
  const FilmForm form = film_form_of(product);
  add_film_wall(pack, form, wall_levels(form, print, clear));
  for (int k = 0; k < form.deep; ++k) {
    for (int i = 0; i < form.across; ++i)
      add_roll_end(pack, form, piece_place(pack, form, i, k), paper_end, core);
  }
  return pack.finish();
}

CollisionPrimitive collision_roll_pack(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
