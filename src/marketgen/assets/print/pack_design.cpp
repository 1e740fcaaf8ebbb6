#include "assets/print/pack_design.h"

namespace marketgen::assets {

const std::vector<PackDesign>& pack_designs() {
  static const std::vector<PackDesign> designs{
#define PACK_DESIGN(name, description) {#name, description, draw_ground_##name, draw_face_##name},
#include "assets/print/pack_designs.inc"
#undef PACK_DESIGN
  };
  return designs;
}

const PackDesign& design_of(const PackArt& art) {
  return pack_designs()[art.look.design % pack_designs().size()];
}

FrontPlan draw_strip_face(Canvas& canvas, const PackArt& art, const Area& area) {
  const Color field = art.paper(0.6);
  canvas.rectangle(area.part(0, 0, 0.38, 1)).fill(art.primary);
  canvas.rectangle(area.part(0.38, 0, 1, 1)).fill(field);
  canvas.rectangle(area.part(0.375, 0, 0.385, 1)).fill(art.accent);
  FrontPlan plan;
  plan.brand = area.part(0.02, 0.10, 0.36, 0.78);
  plan.brand_ground = plan.net_ground = art.primary;
  plan.net = area.part(0.02, 0.80, 0.36, 0.95);
  plan.name = area.part(0.41, 0.10, 0.72, 0.66);
  plan.name_ground = plan.variant_ground = field;
  plan.variant = area.part(0.41, 0.70, 0.72, 0.88);
  plan.variant_mark = VariantMark::plain;
  plan.motif = area.part(0.73, 0.05, 0.99, 0.95);
  return plan;
}

}  // namespace marketgen::assets
