#include <algorithm>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/label_zone.h"
#include "assets/shapes/archetypes/loft.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"
#include "assets/shapes/archetypes/tin_parts.h"

namespace marketgen::assets {

// Sardines, mackerel: a drawn aluminium tin with rounded corners, printed on its lid and its front
// wall, the ring pull at the right end.
Result<ProductModel> make_sardine_tin(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const std::uint16_t metal = pack.add_surface(aluminium());
  const std::uint16_t print = pack.add_print(lacquer_roughness);
  const LabelZone zone = label_zone_of(product);
  const float w = pack.width() / 2, d = pack.depth() / 2, h = pack.height();
  const float seam = 0.8F * zone.low_m;
  const auto section = [&](float z, float inset, std::uint16_t surface) {
    return Section{.z = z,
                   .half_width = w - inset * std::min(w, d),
                   .half_depth = d - inset * std::min(w, d),
                   .surface = surface,
                   .roundness = zone.roundness};
  };
  const float round = zone.low_m;
  std::vector<Section> sections{section(0, 0.13F, metal),
                                section(0.06F * round, 0.09F, metal),
                                section(0.30F * round, 0.055F, metal),
                                section(0.62F * round, 0.035F, metal),
                                section(zone.low_m, 0.03F, print),
                                section(zone.high_m, 0.03F, metal),
                                section(h - seam, 0, metal),
                                section(h - 0.2F * seam, 0, metal),
                                section(h, 0.02F, metal),
                                section(h - 0.1F * seam, 0.045F, metal),
                                section(h - 0.7F * seam, 0.055F, metal),
                                section(h - 0.7F * seam, 0.085F, print)};
  LoftStyle style = smooth_style;
  style.label_arc = zone.arc;
  style.beside = metal;
  add_loft(pack, sections, style);
  const PartFrame right{.origin = {0.62F * w, 0, 0}, .x = {0, -1, 0}, .y = {1, 0, 0}};
  const std::size_t tab = pack.triangle_count();
  add_ring_pull(pack, h - 0.7F * seam, std::min(0.55F * w, 0.70F * d), metal, right);
  pack.add_part_feature(FeatureKind::tab, tab);
  pack.add_band_feature(FeatureKind::rim, h - seam, h);
  return pack.finish();
}

CollisionPrimitive collision_sardine_tin(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
