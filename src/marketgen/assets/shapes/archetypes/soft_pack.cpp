#include <algorithm>
#include <cmath>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/pack_faces.h"
#include "assets/shapes/archetypes/panel_box.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {
namespace {

// Faces swell between their edges, the ends less.
Vec3f swollen_point(Vec3f share, Vec3f size, float edge) {
  const Vec3f p = rounded_box_point(share, size, edge);
  const Vec3f o{2 * share.x - 1, 2 * share.y - 1, 2 * share.z - 1};
  const auto full = [](float a, float b) { return (1 - a * a) * (1 - b * b); };
  const float least = std::min({size.x, size.y, size.z});
  const float swell = 0.055F * least;
  const float middle = size.z / 2;
  return {p.x * (1 - swell / size.x * (1 - full(o.y, o.z))),
          p.y * (1 - 2 * swell / size.y * (1 - full(o.x, o.z))),
          middle + (p.z - middle) * (1 - 1.4F * swell / size.z * (1 - full(o.x, o.y)))};
}

// The crimped seal at one end: a strip of film, ridged by the jaws.
void add_fin(PackBuilder& pack, float side, float length, std::uint16_t surface) {
  const float w = pack.width(), d = pack.depth(), h = pack.height();
  const float thick = std::min(0.0012F, 0.03F * h);
  const Vec3f size{2.6F * length, 0.62F * d, thick};
  add_plain_box(pack,
                size,
                0.4F * thick,
                surface,
                PartFrame{.origin = {side * (w / 2 - size.x / 2), 0, 0.46F * h}});
}

// A hard lid glued over the opening: a frame, the lid in it, a lip for the thumb in front.
void add_lid(PackBuilder& pack, float low, float high, std::uint16_t frame, std::uint16_t lid) {
  const float wide = std::min(0.50F * pack.width(), 0.125F), deep = 0.60F * pack.depth();
  const float rise = high - low;
  add_plain_box(pack,
                {wide, deep, 0.62F * rise + rise},
                0.6F * rise,
                frame,
                PartFrame{.origin = {0, 0, low - rise}});
  add_plain_box(pack,
                {0.86F * wide, 0.84F * deep, 2 * rise},
                0.45F * rise,
                lid,
                PartFrame{.origin = {0, -0.01F * deep, low - rise}});
  add_plain_box(pack,
                {0.20F * wide, 0.08F * deep, 1.7F * rise},
                0.3F * rise,
                lid,
                PartFrame{.origin = {0, -0.44F * deep, low - rise}});
}

}  // namespace

// Wipes with a flip lid; tissues, nappies and pads as plain blocks of film: soft, full,
// round-edged.
Result<ProductModel> make_soft_pack(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const std::uint16_t print = pack.add_print(film_roughness);
  const std::uint16_t fin = pack.add_surface(film(colors.primary));
  const SoftForm form = soft_form_of(product);
  const Vec3f size = form.size;
  const float edge = form.edge_m, h = pack.height();

  const BoxGrid grid{rounded_lines(size.x, edge, 3, 8),
                     rounded_lines(size.y, edge, 3, 5),
                     rounded_lines(size.z, edge, 3, 5)};
  add_panel_box(pack, grid, {print, print, print, print, print, print}, [&](Vec3f share) {
    return swollen_point(share, size, edge);
  });
  for (const float side : {-1.0F, 1.0F})
    add_fin(pack, side, form.fin_m, fin);
  if (form.lid_m > 0) {
    const std::uint16_t frame = pack.add_surface(plastic({0.86F, 0.87F, 0.88F}));
    const std::uint16_t lid = pack.add_surface(plastic(colors.accent));
    add_lid(pack, h - form.lid_m, h, frame, lid);
    pack.add_surface_feature(FeatureKind::lid, lid);
  }
  return pack.finish(0.4F);
}

CollisionPrimitive collision_soft_pack(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
