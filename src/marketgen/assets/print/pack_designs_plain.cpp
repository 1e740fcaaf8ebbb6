// Pack designs made of plain fields of colour.
#include <algorithm>

#include "assets/print/pack_design.h"
#include "assets/print/pack_ornament.h"

namespace marketgen::assets {
namespace {

Paint top_to_bottom(const Area& area, const Color& top, const Color& bottom) {
  return Paint::linear(area.x, area.y, area.x, area.bottom(), {{0, top}, {1, bottom}});
}

// Colour of a full-colour ground about the middle of its gradient.
void fill_full_color(Canvas& canvas, const PackArt& art, const Area& area) {
  canvas.rectangle(area).fill(
      top_to_bottom(area, lighter(art.primary, 0.12), darker(art.primary, 0.18)));
  draw_pattern(canvas,
               art.look.pattern,
               area,
               std::max(3.0, area.h * 0.05),
               faded(lighter(art.primary, 0.6), 0.13));
}

// Words left, picture right: what every plain design does on a wide front.
FrontPlan wide_plan(const Area& a, const Color& ground) {
  FrontPlan plan;
  plan.align = Align::left;
  plan.net_align = Align::left;
  plan.brand = a.part(0.04, 0.08, 0.54, 0.40);
  plan.name = a.part(0.04, 0.43, 0.56, 0.70);
  plan.variant = a.part(0.04, 0.72, 0.56, 0.83);
  plan.net = a.part(0.04, 0.86, 0.40, 0.95);
  plan.motif = a.part(0.60, 0.06, 0.98, 0.94);
  plan.badge = a.part(0.84, 0.05, 0.98, 0.40);
  plan.brand_ground = plan.name_ground = plan.net_ground = ground;
  return plan;
}

FrontPlan tall_plan(const Area& a, const Color& ground) {
  FrontPlan plan;
  plan.brand = a.part(0.07, 0.04, 0.93, 0.225);
  plan.motif = a.part(0.08, 0.235, 0.92, 0.63);
  plan.name = a.part(0.07, 0.635, 0.93, 0.81);
  plan.variant = a.part(0.08, 0.82, 0.92, 0.89);
  plan.net = a.part(0.08, 0.91, 0.92, 0.965);
  plan.badge = a.part(0.66, 0.24, 0.96, 0.40);
  plan.brand_ground = plan.name_ground = plan.net_ground = ground;
  return plan;
}

}  // namespace

void draw_ground_glow(Canvas& canvas, const PackArt& art, const Area& area) {
  fill_full_color(canvas, art, area);
}

FrontPlan draw_face_glow(Canvas& canvas, const PackArt& art, const Area& area) {
  FrontPlan plan = is_wide(area) ? wide_plan(area, art.primary) : tall_plan(area, art.primary);
  const double radius = std::min(plan.motif.w, plan.motif.h) * 0.72;
  draw_glow(canvas, plan.motif.center_x(), plan.motif.center_y(), radius, art.paper(0.5), 0.85);
  plan.variant_mark = VariantMark::pill;
  plan.variant_ground = art.accent;
  return plan;
}

void draw_ground_header(Canvas& canvas, const PackArt& art, const Area& area) {
  const Color paper = art.paper(0.75);
  canvas.rectangle(area).fill(top_to_bottom(area, paper, art.paper(0.45)));
  const Area head = area.part(0, 0, 1, 0.30);
  canvas.rectangle(head).fill(top_to_bottom(head, lighter(art.primary, 0.08), art.primary));
  canvas.rectangle({area.x, head.bottom(), area.w, area.h * 0.015}).fill(art.accent);
}

FrontPlan draw_face_header(Canvas&, const PackArt& art, const Area& area) {
  const Color paper = art.paper(0.75);
  FrontPlan plan = is_wide(area) ? wide_plan(area, paper) : tall_plan(area, paper);
  if (is_wide(area)) {
    plan.brand = area.part(0.04, 0.03, 0.60, 0.27);
    plan.name = area.part(0.04, 0.36, 0.58, 0.68);
    plan.motif = area.part(0.60, 0.14, 0.98, 0.98);
  } else {
    plan.brand = area.part(0.06, 0.03, 0.94, 0.27);
    plan.name = area.part(0.06, 0.34, 0.94, 0.49);
    plan.variant = area.part(0.08, 0.50, 0.92, 0.565);
    plan.motif = area.part(0.10, 0.57, 0.90, 0.90);
    plan.badge = area.part(0.68, 0.56, 0.96, 0.70);
    plan.net = area.part(0.06, 0.915, 0.94, 0.97);
    plan.net_align = Align::left;
  }
  plan.brand_ground = art.primary;
  plan.variant_mark = VariantMark::plain;
  plan.variant_ground = paper;
  return plan;
}

void draw_ground_diagonal(Canvas& canvas, const PackArt& art, const Area& area) {
  canvas.rectangle(area).fill(
      top_to_bottom(area, lighter(art.primary, 0.06), darker(art.primary, 0.10)));
}

FrontPlan draw_face_diagonal(Canvas& canvas, const PackArt& art, const Area& area) {
  const auto slanted = [&](double left, double right, double thickness, const Color& color) {
    canvas.polygon({{area.x, area.y + area.h * left},
                    {area.right(), area.y + area.h * right},
                    {area.right(), area.y + area.h * (right + thickness)},
                    {area.x, area.y + area.h * (left + thickness)}});
    canvas.fill(color);
  };
  const Color field = art.paper(0.6);
  slanted(0.62, 0.40, 0.03, art.accent);
  slanted(0.65, 0.43, 0.60, field);
  FrontPlan plan = is_wide(area) ? wide_plan(area, field) : tall_plan(area, field);
  if (is_wide(area)) {
    plan.brand = area.part(0.04, 0.05, 0.56, 0.38);
    plan.name = area.part(0.04, 0.68, 0.56, 0.86);
    plan.variant = area.part(0.04, 0.87, 0.56, 0.95);
    plan.net = area.part(0.04, 0.46, 0.24, 0.56);
    plan.net_ground = art.primary;
  } else {
    plan.motif = area.part(0.10, 0.23, 0.92, 0.64);
    plan.name = area.part(0.06, 0.665, 0.94, 0.81);
    plan.variant = area.part(0.08, 0.815, 0.92, 0.88);
    plan.badge = area.part(0.04, 0.40, 0.30, 0.56);
  }
  plan.brand_ground = art.primary;
  plan.variant_mark = VariantMark::plain;
  plan.variant_ground = field;
  return plan;
}

void draw_ground_split(Canvas& canvas, const PackArt& art, const Area& area) {
  const Color paper = art.paper(0.7);
  canvas.rectangle(area).fill(top_to_bottom(area, paper, art.paper(0.4)));
  draw_pattern(
      canvas, art.look.pattern, area, std::max(3.0, area.h * 0.045), faded(art.primary, 0.05));
  canvas.rectangle(area.part(0, 0.93, 1, 1)).fill(art.primary);
}

FrontPlan draw_face_split(Canvas& canvas, const PackArt& art, const Area& area) {
  const Color paper = art.paper(0.7);
  FrontPlan plan = is_wide(area) ? wide_plan(area, paper) : tall_plan(area, paper);
  const Area strip = is_wide(area) ? area.part(0, 0, 0.36, 1) : area.part(0, 0, 0.20, 1);
  canvas.rectangle(strip).fill(
      Paint::linear(strip.x,
                    0,
                    strip.right(),
                    0,
                    {{0, darker(art.primary, 0.12)}, {1, lighter(art.primary, 0.08)}}));
  canvas.rectangle({strip.right(), area.y, area.w * 0.012, area.h}).fill(art.accent);
  if (is_wide(area)) {
    plan.brand = strip.part(0.08, 0.15, 0.92, 0.78);
    plan.brand_ground = art.primary;
    plan.align = Align::center;
    plan.name = area.part(0.40, 0.12, 0.70, 0.62);
    plan.variant = area.part(0.40, 0.66, 0.70, 0.80);
    plan.net = strip.part(0.1, 0.82, 0.9, 0.95);
    plan.net_ground = art.primary;
    plan.net_align = Align::center;
    plan.motif = area.part(0.71, 0.08, 0.98, 0.92);
  } else {
    plan.brand = area.part(0.25, 0.05, 0.96, 0.22);
    plan.name = area.part(0.26, 0.25, 0.95, 0.42);
    plan.variant = area.part(0.26, 0.43, 0.95, 0.50);
    plan.motif = area.part(0.22, 0.515, 0.98, 0.925);
    plan.badge = area.part(0.02, 0.06, 0.26, 0.20);
    plan.net = area.part(0.26, 0.935, 0.95, 0.995);
    plan.net_ground = art.primary;
  }
  plan.variant_mark = VariantMark::band;
  plan.variant_ground = art.accent;
  return plan;
}

void draw_ground_poster(Canvas& canvas, const PackArt& art, const Area& area) {
  canvas.rectangle(area).fill(art.primary);
}

FrontPlan draw_face_poster(Canvas& canvas, const PackArt& art, const Area& area) {
  FrontPlan plan = is_wide(area) ? wide_plan(area, art.primary) : tall_plan(area, art.primary);
  plan.align = Align::left;
  plan.net_align = Align::left;
  if (is_wide(area)) {
    plan.motif = area.part(0.58, -0.05, 1.02, 1.05);
  } else {
    plan.brand = area.part(0.07, 0.04, 0.93, 0.23);
    plan.name = area.part(0.07, 0.26, 0.93, 0.46);
    plan.variant = area.part(0.07, 0.47, 0.93, 0.535);
    plan.motif = area.part(0.20, 0.52, 1.02, 0.95);
    plan.net = area.part(0.07, 0.90, 0.55, 0.96);
    plan.badge = area.part(0.04, 0.60, 0.30, 0.76);
  }
  const double radius = std::min(plan.motif.w, plan.motif.h) * 0.56;
  canvas.circle(plan.motif.center_x(), plan.motif.center_y(), radius)
      .fill(lighter(art.primary, 0.16));
  canvas
      .rectangle({plan.name.x, plan.brand.bottom() + area.h * 0.012, area.w * 0.22, area.h * 0.008})
      .fill(art.accent);
  plan.variant_mark = VariantMark::plain;
  plan.variant_ground = art.primary;
  return plan;
}

}  // namespace marketgen::assets
