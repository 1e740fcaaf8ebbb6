// Pack designs with windows, medallions, waves and frames.
#include <algorithm>
#include <cmath>

#include "assets/print/pack_design.h"
#include "assets/print/pack_ornament.h"

namespace marketgen::assets {
namespace {

constexpr Color kraft_paper = rgb("#cfae82");
constexpr Color cream = rgb("#fbf5e6");

// A window with a round head.
void arch_path(Canvas& canvas, const Area& a) {
  const double r = std::min(a.w / 2, a.h * 0.7);
  cairo_t* c = canvas.context();
  cairo_move_to(c, a.x, a.bottom());
  cairo_line_to(c, a.x, a.y + r);
  cairo_curve_to(c, a.x, a.y + r * 0.35, a.x + a.w * 0.22, a.y, a.center_x(), a.y);
  cairo_curve_to(c, a.right() - a.w * 0.22, a.y, a.right(), a.y + r * 0.35, a.right(), a.y + r);
  cairo_line_to(c, a.right(), a.bottom());
  cairo_close_path(c);
}

}  // namespace

void draw_ground_wave(Canvas& canvas, const PackArt& art, const Area& area) {
  canvas.rectangle(area).fill(
      Paint::linear(0,
                    area.y,
                    0,
                    area.bottom(),
                    {{0, lighter(art.primary, 0.10)}, {0.6, art.primary}, {1, art.primary}}));
  draw_pattern(canvas,
               art.look.pattern,
               area.part(0, 0, 1, 0.6),
               std::max(3.0, area.h * 0.06),
               faded(paper_white, 0.10));
  const int waves = std::max(1, static_cast<int>(std::lround(area.w / (area.h * 0.9))));
  fill_below_wave(canvas, area, area.y + area.h * 0.575, area.h * 0.05, waves, art.accent);
  fill_below_wave(canvas, area, area.y + area.h * 0.605, area.h * 0.05, waves, art.paper(0.6));
}

FrontPlan draw_face_wave(Canvas&, const PackArt& art, const Area& area) {
  const Color foot = art.paper(0.6);
  FrontPlan plan;
  plan.brand_ground = art.primary;
  plan.name_ground = art.primary;
  plan.net_ground = foot;
  plan.variant_mark = VariantMark::pill;
  plan.variant_ground = art.primary;
  if (is_wide(area)) {
    plan.align = plan.net_align = Align::left;
    plan.brand = area.part(0.04, 0.05, 0.56, 0.30);
    plan.name = area.part(0.04, 0.31, 0.56, 0.53);
    plan.variant = area.part(0.04, 0.70, 0.50, 0.82);
    plan.net = area.part(0.04, 0.86, 0.50, 0.95);
    plan.motif = area.part(0.58, 0.08, 0.98, 0.96);
    plan.badge = area.part(0.46, 0.62, 0.60, 0.96);
    return plan;
  }
  plan.brand = area.part(0.07, 0.04, 0.93, 0.22);
  plan.name = area.part(0.07, 0.235, 0.93, 0.40);
  plan.motif = area.part(0.12, 0.41, 0.88, 0.80);
  plan.variant = area.part(0.10, 0.82, 0.90, 0.885);
  plan.net = area.part(0.10, 0.91, 0.90, 0.965);
  plan.badge = area.part(0.68, 0.66, 0.97, 0.81);
  return plan;
}

void draw_ground_arch(Canvas& canvas, const PackArt& art, const Area& area) {
  canvas.rectangle(area).fill(Paint::linear(
      0, area.y, 0, area.bottom(), {{0, art.primary}, {1, darker(art.primary, 0.22)}}));
  draw_pattern(canvas,
               1 + art.look.pattern % 3,
               area,
               std::max(2.5, area.h * 0.035),
               faded(lighter(art.primary, 0.5), 0.16));
}

FrontPlan draw_face_arch(Canvas& canvas, const PackArt& art, const Area& area) {
  FrontPlan plan;
  plan.brand_ground = plan.net_ground = art.primary;
  plan.variant_mark = VariantMark::band;
  plan.variant_ground = art.accent;
  Area window;
  if (is_wide(area)) {
    window = area.part(0.60, 0.10, 0.96, 1.0);
    plan.align = plan.net_align = Align::left;
    plan.brand = area.part(0.04, 0.08, 0.55, 0.40);
    plan.name = area.part(0.04, 0.44, 0.56, 0.70);
    plan.variant = area.part(0.04, 0.73, 0.56, 0.84);
    plan.net = area.part(0.04, 0.87, 0.50, 0.95);
    plan.motif = window.part(0.06, 0.12, 0.94, 0.96);
    plan.name_ground = art.primary;
  } else {
    window = area.part(0.07, 0.235, 0.93, 0.90);
    plan.brand = area.part(0.07, 0.035, 0.93, 0.215);
    plan.motif = window.part(0.10, 0.08, 0.90, 0.60);
    plan.name = window.part(0.06, 0.62, 0.94, 0.83);
    plan.variant = window.part(0.0, 0.86, 1.0, 0.98);
    plan.net = area.part(0.10, 0.915, 0.90, 0.97);
    plan.badge = window.part(0.72, 0.44, 1.02, 0.66);
    plan.name_ground = art.paper(0.65);
  }
  arch_path(canvas, window);
  canvas.fill_and_stroke(
      Paint::linear(0, window.y, 0, window.bottom(), {{0, paper_white}, {1, art.paper(0.55)}}),
      art.accent,
      area.h * 0.010);
  return plan;
}

void draw_ground_medallion(Canvas& canvas, const PackArt& art, const Area& area) {
  const Color paper = art.paper(0.82);
  canvas.rectangle(area).fill(paper);
  draw_pattern(canvas,
               1 + art.look.pattern % 3,
               area.part(0, 0.1, 1, 0.9),
               std::max(3.0, area.h * 0.04),
               faded(art.primary, 0.07));
  for (const Area& band : {area.part(0, 0, 1, 0.10), area.part(0, 0.88, 1, 1)})
    canvas.rectangle(band).fill(art.primary);
  for (const double y : {0.115, 0.857})
    canvas.rectangle({area.x, area.y + area.h * y, area.w, area.h * 0.008}).fill(art.accent);
}

FrontPlan draw_face_medallion(Canvas& canvas, const PackArt& art, const Area& area) {
  FrontPlan plan;
  plan.brand_ground = art.primary;
  plan.name_ground = plan.variant_ground = art.paper(0.82);
  plan.net_ground = art.primary;
  plan.variant_mark = VariantMark::plain;
  Area disc;
  if (area.w > 0.85 * area.h) {
    // Squarish and wide fronts: the medallion stands left, the picture right, the name under both.
    const double side = std::min(area.w * 0.50, area.h * 0.78);
    disc = {area.x + area.w * 0.03, area.y + area.h * 0.02, side, side};
    const double right = (disc.right() - area.x) / area.w + 0.01;
    plan.motif = area.part(right, 0.13, 0.98, is_wide(area) ? 0.60 : 0.66);
    plan.name =
        is_wide(area) ? area.part(right, 0.60, 0.98, 0.76) : area.part(0.04, 0.665, 0.96, 0.78);
    plan.variant =
        is_wide(area) ? area.part(right, 0.765, 0.98, 0.85) : area.part(0.06, 0.785, 0.94, 0.85);
    plan.net = area.part(0.05, 0.895, 0.95, 0.985);
    plan.net_align = Align::right;
  } else {
    const double side = std::min(area.w * 0.86, area.h * 0.42);
    disc = {area.center_x() - side / 2, area.y + area.h * 0.03, side, side};
    plan.motif = area.part(0.08, 0.43, 0.92, 0.71);
    plan.name = area.part(0.06, 0.71, 0.94, 0.80);
    plan.variant = area.part(0.08, 0.80, 0.92, 0.853);
    plan.net = area.part(0.10, 0.905, 0.90, 0.97);
    plan.badge = area.part(0.70, 0.44, 0.97, 0.58);
  }
  const double r = disc.w / 2;
  canvas.circle(disc.center_x(), disc.center_y(), r * 0.99).fill(art.accent);
  canvas.circle(disc.center_x(), disc.center_y(), r * 0.94);
  canvas.fill(Paint::radial(disc.center_x(),
                            disc.center_y(),
                            r,
                            disc.center_x() - r * 0.3,
                            disc.center_y() - r * 0.3,
                            {{0, lighter(art.primary, 0.18)}, {1, darker(art.primary, 0.12)}}));
  canvas.circle(disc.center_x(), disc.center_y(), r * 0.87)
      .stroke(faded(paper_white, 0.8), r * 0.018);
  plan.brand = disc.part(0.11, 0.27, 0.89, 0.73);
  return plan;
}

void draw_ground_kraft(Canvas& canvas, const PackArt& art, const Area& area) {
  canvas.rectangle(area).fill(kraft_paper);
  Stream draw = art.seed.child("kraft fibres").stream();
  for (int fibre = 0; fibre < 90; ++fibre) {
    const double x = area.x + draw.uniform() * area.w;
    const double y = area.y + draw.uniform() * area.h;
    cairo_move_to(canvas.context(), x, y);
    cairo_line_to(canvas.context(),
                  x + draw.uniform(-0.03, 0.03) * area.h,
                  y + draw.uniform(-0.02, 0.02) * area.h);
  }
  canvas.stroke(faded(rgb("#8a6a3c"), 0.30), area.h * 0.003);
  canvas.rectangle(area.part(0, 0.0, 1, 0.025)).fill(art.primary);
  canvas.rectangle(area.part(0, 0.975, 1, 1)).fill(art.primary);
}

FrontPlan draw_face_kraft(Canvas& canvas, const PackArt& art, const Area& area) {
  FrontPlan plan;
  Area sheet;
  plan.variant_mark = VariantMark::band;
  plan.variant_ground = art.primary;
  plan.brand_ground = plan.name_ground = cream;
  if (area.w > 0.85 * area.h) {
    sheet = area.part(0.04, 0.08, 0.56, 0.92);
    plan.motif = area.part(0.55, 0.08, 1.00, 0.92);
    plan.brand = sheet.part(0.06, 0.07, 0.94, 0.40);
    plan.name = sheet.part(0.06, 0.42, 0.94, 0.66);
    plan.variant = sheet.part(0, 0.69, 1, 0.83);
    plan.net = sheet.part(0.06, 0.85, 0.94, 0.97);
    plan.net_ground = cream;
  } else {
    sheet = area.part(0.10, 0.05, 0.90, 0.56);
    plan.brand = sheet.part(0.06, 0.06, 0.94, 0.40);
    plan.name = sheet.part(0.06, 0.42, 0.94, 0.74);
    plan.variant = sheet.part(0, 0.80, 1, 0.93);
    plan.motif = area.part(0.10, 0.555, 0.90, 0.90);
    plan.net = area.part(0.10, 0.91, 0.90, 0.965);
    plan.net_ground = kraft_paper;
    plan.badge = area.part(0.70, 0.57, 0.97, 0.71);
  }
  canvas
      .rounded({sheet.x + area.h * 0.006, sheet.y + area.h * 0.008, sheet.w, sheet.h},
               area.h * 0.012)
      .fill(faded(print_ink, 0.25));
  canvas.rounded(sheet, area.h * 0.012).fill(cream);
  canvas.rounded(sheet.inset(area.h * 0.010), area.h * 0.008).stroke(art.primary, area.h * 0.004);
  canvas.rounded(sheet.inset(area.h * 0.018), area.h * 0.006)
      .stroke(faded(art.primary, 0.6), area.h * 0.0016);
  return plan;
}

void draw_ground_stripes(Canvas& canvas, const PackArt& art, const Area& area) {
  canvas.rectangle(area).fill(art.primary);
  // Whole stripes along x, so that neighbouring sides join.
  const int stripes = std::max(4, static_cast<int>(area.w / 7.0));
  const double pitch = area.w / stripes;
  for (int i = 0; i < stripes; ++i)
    canvas.rectangle({area.x + i * pitch, area.y, pitch / 2, area.h});
  canvas.fill(blend(art.primary, art.paper(0.2), 0.35));
  canvas.rectangle(area.part(0, 0.90, 1, 1)).fill(darker(art.primary, 0.30));
}

FrontPlan draw_face_stripes(Canvas& canvas, const PackArt& art, const Area& area) {
  const Color plate_color = art.paper(0.72);
  FrontPlan plan;
  Area plate;
  plan.name_ground = plate_color;
  plan.brand_ground = plate_color;
  plan.net_ground = darker(art.primary, 0.30);
  plan.variant_mark = VariantMark::pill;
  plan.variant_ground = art.accent;
  if (is_wide(area)) {
    plate = area.part(0.03, 0.08, 0.66, 0.86);
    plan.brand = plate.part(0.05, 0.08, 0.95, 0.46);
    plan.name = plate.part(0.05, 0.48, 0.95, 0.74);
    plan.variant = plate.part(0.10, 0.77, 0.90, 0.94);
    plan.motif = area.part(0.64, 0.04, 0.99, 0.90);
    plan.net = area.part(0.04, 0.905, 0.66, 0.985);
  } else {
    plate = area.part(0.05, 0.06, 0.95, 0.53);
    plan.brand = plate.part(0.06, 0.08, 0.94, 0.45);
    plan.name = plate.part(0.06, 0.47, 0.94, 0.76);
    plan.variant = plate.part(0.10, 0.80, 0.90, 0.93);
    plan.motif = area.part(0.08, 0.49, 0.92, 0.90);
    plan.net = area.part(0.08, 0.92, 0.92, 0.98);
    plan.badge = area.part(0.69, 0.74, 0.97, 0.89);
  }
  canvas.rounded(plate, std::min(plate.w, plate.h) * 0.16);
  canvas.fill_and_stroke(plate_color, art.accent, area.h * 0.012);
  if (!is_wide(area))
    draw_glow(canvas,
              plan.motif.center_x(),
              plan.motif.center_y(),
              plan.motif.h * 0.62,
              paper_white,
              0.7);
  return plan;
}

}  // namespace marketgen::assets
