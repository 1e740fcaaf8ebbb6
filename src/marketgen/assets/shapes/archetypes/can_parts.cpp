#include "assets/shapes/archetypes/can_parts.h"

#include "assets/shapes/archetypes/panel_box.h"

namespace marketgen::assets {
namespace {

constexpr float lid_height = 0.975F;  // the lid lies a little below the rim

}  // namespace

void add_can_end(Profile& profile, float height, float neck, std::uint16_t metal) {
  const float h = height, rim = neck + 0.035F, lid = lid_height * h;
  profile.use(metal).curve_to_body(Curve::slope, h - 0.022F * h, neck, 5);
  profile.body(h - 0.016F * h, rim)
      .body(h - 0.004F * h, rim)
      .body(h, rim - 0.015F)
      .body(h - 0.004F * h, neck);
  profile.body(lid, neck - 0.025F).body(lid + 0.001F, neck - 0.10F).pole(lid + 0.001F);
}

void add_can_tab(
    PackBuilder& pack, float height, float radius, std::uint16_t metal, const PartFrame& can) {
  PartFrame tab = can;
  tab.origin = can({0, -0.12F * radius, lid_height * height + 0.0008F});
  add_plain_box(pack, {0.36F * radius, 0.62F * radius, 0.0012F}, 0.0005F, metal, tab);
}

Result<ProductModel> finish_can(PackBuilder& pack,
                                Profile& profile,
                                const CanForm& form,
                                const LoftStyle& style) {
  const float h = pack.height();
  profile.use(form.print).body(form.print_to_m, 1);
  add_can_end(profile, h, form.neck, form.metal);
  add_loft(pack, profile.sections(), style);
  const std::size_t tab = pack.triangle_count();
  add_can_tab(pack, h, profile.min_half(), form.metal);
  pack.add_part_feature(FeatureKind::tab, tab);
  pack.add_band_feature(FeatureKind::rim, h - 0.022F * h, h);
  return pack.finish();
}

}  // namespace marketgen::assets
