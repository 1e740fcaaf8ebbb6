#include <algorithm>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/panel_box.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {
namespace {

// Along the loaf from the gathered end (0) to the flat end (1): what is left of the cross-section,
// across and up.
struct Gather {
  float along, across, up;
};
constexpr Gather gathers[] = {
    {0.000F, 0.34F, 0.22F},
    {0.050F, 0.12F, 0.10F},
    {0.065F, 0.12F, 0.10F},
    {0.095F, 0.55F, 0.50F},
    {0.130F, 0.86F, 0.82F},
    {0.180F, 0.98F, 0.97F},
    {0.250F, 1.00F, 1.00F},
    {1.000F, 1.00F, 1.00F},
};

Gather gather_at(float along) {
  std::size_t i = 1;
  while (i + 1 < std::size(gathers) && gathers[i].along < along)
    ++i;
  const Gather &a = gathers[i - 1], &b = gathers[i];
  const float t = std::clamp((along - a.along) / (b.along - a.along), 0.0F, 1.0F);
  return {along, a.across + (b.across - a.across) * t, a.up + (b.up - a.up) * t};
}

// In loaf coordinates: X along from the gathered end, Y across, Z up. The crown is wider than the
// foot and arched.
Vec3f loaf_point(Vec3f share, Vec3f size) {
  Vec3f p = rounded_box_point(share, size, 0.22F * std::min(size.y, size.z));
  const float height = p.z / size.z, across = 2 * p.y / size.y;
  const float crown = std::clamp((height - 0.30F) / 0.35F, 0.0F, 1.0F);
  p.y *= 0.90F + 0.10F * crown * crown * (3 - 2 * crown);
  p.z *= 1 - 0.10F * across * across * height;
  const Gather gather = gather_at(share.x);
  const float middle = 0.45F * size.z;
  return {p.x, p.y * gather.across, middle + (p.z - middle) * gather.up};
}

std::vector<float> loaf_lines_along() {
  std::vector<float> lines;
  for (const Gather& gather : gathers) {
    if (gather.along < 1) lines.push_back(gather.along);
  }
  for (const float share : {0.5F, 0.75F, 0.90F, 0.95F, 0.98F, 1.0F})
    lines.push_back(share);
  return lines;
}

std::vector<float> mirrored_lines(const std::vector<float>& lines) {
  std::vector<float> mirrored(lines.rbegin(), lines.rend());
  for (float& line : mirrored)
    line = 1 - line;
  return mirrored;
}

}  // namespace

// Lies along the longer side of its footprint, the gathered end of the bag to the left or to the
// back.
Result<ProductModel> make_loaf(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const std::uint16_t print = pack.add_print(film_roughness);
  const std::uint16_t gathered = pack.add_surface(film(colors.secondary));
  const bool lengthwise = pack.depth() > pack.width();
  const float across = lengthwise ? pack.width() : pack.depth();
  const Vec3f size{lengthwise ? pack.depth() : pack.width(), across, pack.height()};

  const std::vector<float> along = loaf_lines_along();
  const float radius = 0.22F * std::min(size.y, size.z);
  const std::vector<float> cross = rounded_lines(across, radius, 2, 4),
                           up = rounded_lines(size.z, radius, 2, 4);
  if (lengthwise) {
    const std::vector<float> from_front = mirrored_lines(along);
    add_panel_box(pack,
                  {cross, from_front, up},
                  {print, print, gathered, print, print, print},
                  [&](Vec3f share) {
                    const Vec3f p = loaf_point({1 - share.y, share.x, share.z}, size);
                    return Vec3f{p.y, -p.x, p.z};
                  });
  } else {
    add_panel_box(
        pack, {along, cross, up}, {print, print, print, gathered, print, print}, [&](Vec3f share) {
          return loaf_point(share, size);
        });
  }
  pack.add_surface_feature(FeatureKind::seam, gathered);
  return pack.finish(0.3F);
}

CollisionPrimitive collision_loaf(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
