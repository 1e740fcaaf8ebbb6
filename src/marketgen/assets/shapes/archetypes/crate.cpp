#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "assets/contents.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/pack_faces.h"
#include "assets/shapes/archetypes/panel_box.h"
#include "assets/shapes/archetypes/plate.h"
#include "assets/shapes/archetypes/profile.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {
namespace {

constexpr float bottle_pitch_m = 0.076F;  // 20 half-litre bottles in 400 x 300 mm
constexpr int max_bottles = 24;
constexpr float crate_label_m = 0.0004F;

struct Rows {
  int across, deep;
};

// As many as the net quantity says, in the rows that give each the squarest place.
Rows rows_of(const catalog::Product& product, float width, float depth) {
  const int wanted = std::atoi(product.net.c_str());
  Rows best{1, 1};
  float least = 1e9F;
  for (int across = 1; across <= max_bottles; ++across) {
    for (int deep = 1; across * deep <= max_bottles; ++deep) {
      const float w = width / static_cast<float>(across), d = depth / static_cast<float>(deep);
      const float unusual = std::abs(std::log(w / d)) +
                            std::abs(std::log(std::min(w, d) / bottle_pitch_m)) +
                            (wanted > 1 && across * deep != wanted ? 10.0F : 0.0F);
      if (unusual < least) {
        least = unusual;
        best = {across, deep};
      }
    }
  }
  return best;
}

// Corner posts, a rim and a foot: what stands out of the walls.
void add_frame(PackBuilder& pack, std::uint16_t surface) {
  const float w = pack.width(), d = pack.depth(), top = crate_wall_high * pack.height();
  const float post_x = crate_post_share * w, post_y = crate_post_share * d;
  const float round = 0.22F * std::min(post_x, post_y), bar = crate_bar_share * pack.height();
  for (const float x : {-1.0F, 1.0F}) {
    for (const float y : {-1.0F, 1.0F}) {
      add_plain_box(pack,
                    {post_x, post_y, top},
                    round,
                    surface,
                    PartFrame{.origin = {x * (w - post_x) / 2, y * (d - post_y) / 2, 0}});
    }
  }
  const float thick = 0.55F * std::min(post_x, post_y), sunk = 0.04F * thick;
  for (const float z : {0.004F * top, top - bar - 0.004F * top}) {
    for (const float side : {-1.0F, 1.0F}) {
      add_plain_box(pack,
                    {w - post_x, thick, bar},
                    0.18F * thick,
                    surface,
                    PartFrame{.origin = {0, side * ((d - thick) / 2 - sunk), z}});
      add_plain_box(pack,
                    {thick, d - post_y, bar},
                    0.18F * thick,
                    surface,
                    PartFrame{.origin = {side * ((w - thick) / 2 - sunk), 0, z}});
    }
  }
}

// Long walls carry the print, short walls the handles.
void add_walls(PackBuilder& pack, std::uint16_t surface, std::uint16_t print) {
  const float w = pack.width(), d = pack.depth(), h = pack.height();
  const FaceSize face = crate_face_of(w, h);
  const float thick = 0.20F * crate_post_share * std::min(w, d);
  const float inset = 0.9F * thick, low = crate_bar_share * h;
  for (const float side : {-1.0F, 1.0F}) {
    PartFrame wall{
        .origin = {0, side * (d / 2 - inset), 0.5F * low}, .x = {-side, 0, 0}, .y = {0, -side, 0}};
    add_plain_box(pack,
                  {face.width_m + 0.02F * w, thick, crate_wall_high * h - low},
                  0.1F * thick,
                  surface,
                  [&](Vec3f p) {
                    return wall(p + Vec3f{0, thick / 2, 0});
                  });
    wall.origin = {0, side * (d / 2 - inset + crate_label_m), low};
    const PanelKind kind = side < 0 ? PanelKind::front : PanelKind::back;
    add_sticker(pack,
                pack.panel(kind),
                {face.width_m, 2 * crate_label_m, face.height_m},
                print,
                surface,
                wall);
    PlateForm plate;
    plate.size = {(1 - 1.9F * crate_post_share) * d, thick, crate_wall_high * h - 1.1F * low};
    plate.hole_size = {std::min(0.42F * d, 0.115F), std::min(0.13F * h, 0.036F)};
    plate.hole_middle = {0, plate.size.z - 0.55F * low - 0.9F * plate.hole_size.y};
    plate.hole_corner_m = 0.45F * plate.hole_size.y;
    add_holed_plate(pack,
                    plate,
                    surface,
                    PartFrame{.origin = {side * (w / 2 - inset), 0, 0.55F * low},
                              .x = {0, side, 0},
                              .y = {-side, 0, 0}});
    const Vec3f grip{side * (w / 2 - inset), 0, 0.55F * low + plate.hole_middle.y};
    const Vec3f half{thick, plate.hole_size.x / 2, plate.hole_size.y / 2};
    pack.add_feature(FeatureKind::handle, {grip - half, grip + half});
  }
  add_plain_box(pack,
                {w - 2 * inset, d - 2 * inset, 0.5F * low},
                0.1F * low,
                surface,
                PartFrame{.origin = {0, 0, 0.2F * low}});
}

// Shoulder, neck and crown cork of one bottle.
void add_bottle(
    PackBuilder& pack, Vec3f place, float radius, std::uint16_t glass, std::uint16_t cork) {
  const float h = pack.height(), neck = std::min(0.0135F, 0.40F * radius);
  Profile profile(radius);
  const float mouth = h - 0.026F * h;
  profile.use(glass).body(0.10F * h, 1).body(0.50F * h, 1);
  profile.curve_to_neck(Curve::slope, 0.80F * h, neck, 4).neck(mouth - 0.01F * h, 0.95F * neck);
  profile.use(cork).neck(mouth - 0.01F * h, 1.20F * neck).neck(mouth, 1.18F * neck);
  profile.neck(h, 0.90F * neck).pole(h);
  add_loft(
      pack, profile.sections(), {.triangles = 260, .max_chords = 3}, PartFrame{.origin = place});
}

}  // namespace

// Twenty bottles of beer or a dozen of water in the crate in which they come back.
Result<ProductModel> make_crate(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  MARKETGEN_TRY(Surface wall, contents_wall(product, glass_roughness, dark_glass()));
  wall.fill = wall.refraction = 0;  // their shoulders alone are seen
  const std::uint16_t body = pack.add_surface(plastic(colors.primary));
  const std::uint16_t print = pack.add_print(film_roughness);
  const std::uint16_t glass = pack.add_surface(wall);
  const std::uint16_t cork = pack.add_surface(lacquered_metal(colors.accent));
  add_frame(pack, body);
  add_walls(pack, body, print);
  const float w = (1 - crate_post_share) * pack.width(), d = (1 - crate_post_share) * pack.depth();
  const Rows rows = rows_of(product, w, d);
  const float pitch_x = w / static_cast<float>(rows.across),
              pitch_y = d / static_cast<float>(rows.deep);
  for (int k = 0; k < rows.deep; ++k) {
    for (int i = 0; i < rows.across; ++i) {
      const Vec3f place{(static_cast<float>(i) + 0.5F) * pitch_x - w / 2,
                        (static_cast<float>(k) + 0.5F) * pitch_y - d / 2,
                        0};
      add_bottle(pack, place, 0.43F * std::min(pitch_x, pitch_y), glass, cork);
    }
  }
  return pack.finish();
}

CollisionPrimitive collision_crate(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
