#include <algorithm>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/label_zone.h"
#include "assets/shapes/archetypes/loft.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {
namespace {

constexpr float seam_half_m = 0.0008F;  // half the thickness of the welded end

struct TubeShape {
  float half_width,
      half_depth;  // of the row: the width is that of the flat end, the depth that of the round one
  float low, high;  // from round to flat
};

// The wall flattens and widens on its way up, as a foil tube of constant girth does.
Section tube_section(const TubeShape& tube, float z, std::uint16_t surface) {
  const float share = std::clamp((z - tube.low) / (tube.high - tube.low), 0.0F, 1.0F);
  const float round = std::min(tube.half_depth, tube.half_width);
  return {.z = z,
          .half_width = round + (tube.half_width - round) * share,
          .half_depth = tube.half_depth + (seam_half_m - tube.half_depth) * share,
          .surface = surface};
}

}  // namespace

Result<ProductModel> make_tube(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const LabelZone zone = label_zone_of(product);
  const std::uint16_t cap = pack.add_surface(plastic(colors.accent));
  const std::uint16_t body = pack.add_surface(plastic(colors.primary));
  const std::uint16_t print = pack.add_print(film_roughness);
  const float h = pack.height(), cap_high = 0.62F * zone.low_m, shoulder = 0.80F * zone.low_m;
  const TubeShape tube{pack.width() / 2, pack.depth() / 2, shoulder, zone.high_m};
  const float r = std::min(tube.half_width, tube.half_depth);

  const auto round = [](float z, float radius, std::uint16_t surface) {
    return Section{.z = z, .half_width = radius, .half_depth = radius, .surface = surface};
  };
  std::vector<Section> sections{round(0, 0, cap),
                                round(0, 0.72F * r, cap),
                                round(0.06F * cap_high, 0.78F * r, cap),
                                round(cap_high, 0.74F * r, body),
                                round(cap_high, 0.62F * r, body),
                                round(shoulder, 0.97F * r, body)};
  sections.push_back(tube_section(tube, shoulder + 0.02F * h, body));
  constexpr int bands = 6;
  for (int i = 0; i <= bands; ++i) {
    const float z = zone.low_m + (zone.high_m - zone.low_m) * static_cast<float>(i) / bands;
    sections.push_back(tube_section(tube, z, i == bands ? body : print));
  }
  sections.push_back(tube_section(tube, h, body));
  sections.back().z = h;
  add_loft(pack, sections);
  pack.add_surface_feature(FeatureKind::cap, cap);
  pack.add_band_feature(FeatureKind::seam, zone.high_m, h);
  return pack.finish();
}

CollisionPrimitive collision_tube(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
