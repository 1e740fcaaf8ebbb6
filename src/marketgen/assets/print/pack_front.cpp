#include "assets/print/pack_front.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "assets/print/motif_brush.h"
#include "assets/print/pack_design.h"
#include "assets/print/pack_facts.h"

namespace marketgen::assets {
namespace {

void draw_name(Canvas& canvas, const PackArt& art, const FrontPlan& plan) {
  draw_headline(canvas,
                {art.product->name,
                 art.look.name_face,
                 art.type_on(plan.name_ground),
                 plan.name,
                 plan.align,
                 VerticalAlign::middle,
                 3,
                 plan.name.h * 0.8,
                 1.04});
}

void draw_variant(Canvas& canvas, const PackArt& art, const FrontPlan& plan) {
  const Area& a = plan.variant;
  const std::string& text = art.product->variant;
  if (text.empty() || a.w <= 0) return;
  Typeface face = art.look.name_face;
  face.letter_case = LetterCase::as_written;
  face.weight = 700;
  Headline line{
      text, face, art.type_on(plan.variant_ground), a.part(0.05, 0.10, 0.95, 0.90), plan.align};
  if (plan.variant_mark == VariantMark::plain) {
    line.area = a;
  } else if (plan.variant_mark == VariantMark::band) {
    canvas.rectangle(a).fill(plan.variant_ground);
  } else {
    // The pill is as long as its words.
    line.area = a.part(0.06, 0.16, 0.94, 0.84);
    const double words = std::min(a.w, fit_headline(line).width + a.h * 0.9);
    const double x = plan.align == Align::left ? a.x : a.center_x() - words / 2;
    canvas.rounded({x, a.y, words, a.h}, a.h / 2).fill(plan.variant_ground);
    line.area = {x + a.h * 0.4, a.y + a.h * 0.16, words - a.h * 0.8, a.h * 0.68};
    line.align = Align::center;
  }
  draw_headline(canvas, line);
}

void draw_net(Canvas& canvas, const PackArt& art, const FrontPlan& plan) {
  if (art.product->net.empty()) return;
  const Typeface face{"Open Sans", 700};
  const bool liquid_or_weighed = art.product->unit_of_measure != "piece";
  // The e-mark of prepackages filled to a nominal quantity (directive 76/211/EEC).
  const std::string text = art.product->net + (liquid_or_weighed ? " \u212e" : "");
  draw_headline(canvas,
                {text, face, readable_on(plan.net_ground, art.text), plan.net, plan.net_align});
}

// The motif; some brands strew two small ones behind it.
void draw_picture(Canvas& canvas, const PackArt& art, const Area& area) {
  if (art.motif->use == MotifUse::strewn && art.look.pattern % 2 == 1) {
    const double side = std::min(area.w, area.h);
    for (const auto& [x, y, angle] :
         {std::array{-0.40, 0.25, -0.5}, std::array{0.40, -0.24, 0.45}}) {
      placed(canvas, area.center_x() + x * side, area.center_y() + y * side, angle, 1, [&] {
        draw_motif(
            canvas, *art.motif, art.ink(), {-side * 0.2, -side * 0.2, side * 0.4, side * 0.4});
      });
    }
  }
  draw_motif(canvas, *art.motif, art.ink(), area);
}

// A star of many short spikes.
void draw_burst(Canvas& canvas, const Ball& body, const Color& color) {
  constexpr int spikes = 16;
  std::vector<std::array<double, 2>> star;
  for (int i = 0; i < 2 * spikes; ++i) {
    const double angle = i * std::numbers::pi / spikes;
    const double r = i % 2 == 0 ? body.radius : body.radius * 0.84;
    star.push_back({body.x + r * std::sin(angle), body.y - r * std::cos(angle)});
  }
  canvas.polygon(star).fill(color);
}

// A round claim, or a star burst for what is new.
void draw_badge(Canvas& canvas, const PackArt& art, const Area& area) {
  Stream draw = art.seed.child("badge").stream();
  constexpr double badge_share = 0.42;
  constexpr double burst_share = 0.3;
  if (area.w <= 0 || !draw.chance(badge_share)) return;
  const bool burst = draw.chance(burst_share);
  const std::string claim =
      burst ? (draw.chance(0.5) ? "New!" : "Best value") : claim_of(art, draw);
  const double r = std::min(area.w, area.h) / 2;
  const double x = area.center_x();
  const double y = area.center_y();
  const Color ground = contrast(art.accent, art.primary) >= 1.4 ? art.accent : art.secondary;
  if (burst) {
    draw_burst(canvas, {x, y, r}, ground);
  } else {
    canvas.circle(x, y, r).fill(ground);
    canvas.circle(x, y, r * 0.90).stroke(faded(readable_on(ground, paper_white), 0.8), r * 0.035);
  }
  placed(canvas, x, y, burst ? -0.18 : 0, 1, [&] {
    draw_headline(canvas,
                  {claim,
                   {"Open Sans", 800, false, false, 0, LetterCase::upper},
                   readable_on(ground, print_ink),
                   {-r * 0.70, -r * 0.56, r * 1.40, r * 1.12},
                   Align::center,
                   VerticalAlign::middle,
                   3,
                   1e9,
                   1.05});
  });
}

}  // namespace

void draw_front(Canvas& canvas, const PackArt& art, const Area& area) {
  const Canvas::Saved saved = canvas.saved();
  canvas.rectangle(area).clip();
  const FrontPlan plan =
      is_strip(area) ? draw_strip_face(canvas, art, area) : design_of(art).face(canvas, art, area);
  draw_picture(canvas, art, plan.motif);
  draw_brand_mark(canvas, art.look, art.product->brand, plan.brand, plan.brand_ground, plan.align);
  draw_name(canvas, art, plan);
  draw_variant(canvas, art, plan);
  draw_net(canvas, art, plan);
  draw_badge(canvas, art, plan.badge);
}

void draw_title(Canvas& canvas, const PackArt& art, const Area& area, const Color& ground) {
  const bool lying = area.h < area.w * 0.22;
  const Area brand = lying ? area.part(0, 0, 0.46, 1) : area.part(0, 0, 1, 0.62);
  const Area name = lying ? area.part(0.50, 0.12, 1, 0.88) : area.part(0.05, 0.66, 0.95, 1);
  draw_brand_mark(canvas, art.look, art.product->brand, brand, ground);
  const std::string words = art.product->variant.empty()
                                ? art.product->name
                                : art.product->name + " " + art.product->variant;
  draw_headline(canvas,
                {words,
                 art.look.name_face,
                 art.type_on(ground),
                 name,
                 Align::center,
                 VerticalAlign::middle,
                 2});
}

}  // namespace marketgen::assets
