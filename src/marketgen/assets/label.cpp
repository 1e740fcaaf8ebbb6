#include "assets/label.h"

#include <algorithm>
#include <cmath>

#include "assets/label_sheet.h"
#include "assets/pack_art.h"
#include "assets/pack_back.h"
#include "assets/pack_design.h"
#include "assets/pack_front.h"
#include "assets/produce_skin.h"

namespace marketgen {
namespace {

constexpr int least_px = 16;
constexpr int most_px = 8192;
// A flat tin's label is seven times as wide as high: beyond this aspect a sheet keeps the number of
// pixels that it has here.
constexpr double widest_full_aspect = 2.0;

struct SheetPixels {
  int width = 0, height = 0;
};

SheetPixels sheet_pixels(const SheetSize& size, int size_px) {
  const double aspect = static_cast<double>(size.width_m) / static_cast<double>(size.height_m);
  const double height = size_px * std::sqrt(std::min(1.0, widest_full_aspect / aspect));
  const auto whole = [](double pixels) {
    return std::max(least_px, static_cast<int>(std::lround(pixels)));
  };
  return {whole(height * aspect), whole(height)};
}

// A panel's area in its own millimetres.
Area millimetres(const Panel& panel) {
  return {
      0, 0, static_cast<double>(panel.width_m) * 1e3, static_cast<double>(panel.height_m) * 1e3};
}

// On whole pixels, so that neighbouring panels meet without a seam.
Area panel_pixels(const Panel& panel, const SheetPixels& sheet) {
  const auto whole = [](float share, int length) {
    return std::round(static_cast<double>(share) * length);
  };
  const double x = whole(panel.u0, sheet.width);
  const double y = whole(panel.v0, sheet.height);
  return {x,
          y,
          std::max(1.0, whole(panel.u1, sheet.width) - x),
          std::max(1.0, whole(panel.v1, sheet.height) - y)};
}

// The light or dark type that reads on what the design paints half way down.
Color info_type(const PackArt& art, const Area& area) {
  Canvas probe(8, 32, paper_white);
  probe.scale(8 / area.w, 32 / area.h);
  design_of(art).ground(probe, art, area);
  const Image picture = probe.image();
  const std::uint8_t* middle = picture.at(4, 20);
  const Color ground{middle[0] / 255.0, middle[1] / 255.0, middle[2] / 255.0};
  return contrast(ground, print_ink) > contrast(ground, paper_white) ? print_ink : paper_white;
}

// Small print stands on a field of its own, so that it reads on any ornament.
InfoField info_field(Canvas& canvas, const Area& area) {
  const double margin = std::min(area.w, area.h) * 0.03;
  const Area field = area.inset(margin);
  canvas.rounded(field, margin * 0.6).fill(faded(paper_white, 0.90));
  return {field.inset(margin * 0.8), print_ink};
}

void draw_band(Canvas& canvas, const PackArt& art, const Area& area) {
  design_of(art).ground(canvas, art, area);
  // What a shopper sees of a round pack: u = 0.29 .. 0.71.
  draw_front(canvas, art, area.part(0.29, 0, 0.71, 1));
  draw_nutrition_side(canvas, art, info_field(canvas, area.part(0.015, 0, 0.255, 1)));
  draw_back(canvas, art, info_field(canvas, area.part(0.735, 0, 0.985, 1)));
}

// The part of a bag's or bottle's face that lies flat before the eye; see "Sheets" in
// assets/label.h.
Area flat_part(const Product& product, const Area& area) {
  const bool bottle = product.archetype == "flask" || product.archetype == "tube";
  return bottle ? area.part(0.11, 0.02, 0.89, 0.98) : area.part(0.06, 0.08, 0.94, 0.92);
}

// The printed sleeve round a tray: across its longer side, nearly all of it on a small one.
Area sleeve_area(const Area& area) {
  constexpr double small_tray_mm = 150;
  const double from = std::max(area.w, area.h) < small_tray_mm ? 0.08 : 0.20;
  return area.w >= area.h ? area.part(from, 0, 1 - from, 1) : area.part(0, from, 1, 1 - from);
}

// The contents of a tray under its film, except where the sleeve hides them.
void draw_contents(Canvas& canvas, const PackArt& art, const Area& area, const Area& sleeve) {
  const double step = std::min(area.w, area.h) * 0.36;
  int row = 0;
  for (double y = area.y - step * 0.2; y < area.bottom(); y += step * 0.82, ++row) {
    for (double x = area.x - step * (row % 2 == 0 ? 0.1 : 0.6); x < area.right(); x += step) {
      const bool hidden = x >= sleeve.x && x + step <= sleeve.right() && y >= sleeve.y &&
                          y + step <= sleeve.bottom();
      if (!hidden) draw_motif(canvas, *art.motif, art.ink(), {x, y, step, step});
    }
  }
}

void draw_sleeve_top(Canvas& canvas, const PackArt& art, const Area& area) {
  canvas.rectangle(area).fill(darker(art.secondary, 0.08));
  const Area sleeve = sleeve_area(area);
  draw_contents(canvas, art, area, sleeve);
  canvas.rectangle(area).fill(Paint::linear(area.x,
                                            area.y,
                                            area.right(),
                                            area.bottom(),
                                            {{0, faded(paper_white, 0.28)},
                                             {0.35, faded(paper_white, 0.02)},
                                             {0.6, faded(paper_white, 0.14)},
                                             {1, faded(paper_white, 0)}}));
  {
    const Canvas::Saved saved = canvas.saved();
    canvas.rectangle(sleeve).clip();
    design_of(art).ground(canvas, art, sleeve);
  }
  const bool across = sleeve.w > sleeve.h;
  draw_front(canvas, art, across ? sleeve.part(0, 0, 0.64, 1) : sleeve.part(0, 0, 1, 0.68));
  draw_full_back(
      canvas,
      art,
      info_field(canvas, across ? sleeve.part(0.64, 0, 1, 1) : sleeve.part(0, 0.68, 1, 1)));
}

// A box that lies on its back, like a pizza's: its top is what the eye meets.
bool is_flat_box(const Product& product) {
  const bool box = product.archetype == "box" || product.archetype == "bundle";
  return box && product.size_mm[1] * 2 > product.size_mm[2] * 3;
}

void draw_top(Canvas& canvas, const PackArt& art, const Area& area) {
  if (art.product->archetype == "tray") return draw_sleeve_top(canvas, art, area);
  if (is_flat_box(*art.product)) {
    design_of(art).ground(canvas, art, area);
    return draw_front(canvas, art, area);
  }
  canvas.rectangle(area).fill(art.primary);
  if (art.product->archetype == "gable_carton") {
    // The lower part slopes to the front; the cap sits left of its middle.
    return draw_title(canvas, art, area.part(0.46, 0.62, 0.94, 0.94), art.primary);
  }
  draw_title(canvas, art, area.part(0.18, 0.26, 0.82, 0.74), art.primary);
}

void draw_panel(Canvas& canvas, const PackArt& art, PanelKind kind, const Area& area) {
  const bool bag_or_bottle = sheet_kind_of(art.product->archetype).value() == SheetKind::front_back;
  const Area flat = bag_or_bottle ? flat_part(*art.product, area) : area;
  // Bands and waves of the ground stand where the flat part's words expect them; seals take the
  // colour they continue.
  const auto ground = [&] {
    design_of(art).ground(canvas, art, area);
    if (bag_or_bottle) design_of(art).ground(canvas, art, {area.x, flat.y, area.w, flat.h});
  };
  const bool flat_box = is_flat_box(*art.product);
  if (flat_box &&
      (kind == PanelKind::back || kind == PanelKind::left || kind == PanelKind::right)) {
    canvas.rectangle(area).fill(art.primary);
    return draw_title(canvas, art, area.part(0.1, 0.12, 0.9, 0.88), art.primary);
  }
  switch (kind) {
    case PanelKind::band:
      return draw_band(canvas, art, area);
    case PanelKind::front:
      ground();
      if (art.product->archetype == "tray")
        return draw_title(canvas, art, area.inset(area.h * 0.12), art.primary);
      return draw_front(canvas, art, flat);
    case PanelKind::back:
      ground();
      if (bag_or_bottle) return draw_full_back(canvas, art, info_field(canvas, flat));
      draw_back(canvas, art, info_field(canvas, area));
      return;
    case PanelKind::right:
      ground();
      return draw_nutrition_side(canvas, art, info_field(canvas, area));
    case PanelKind::left:
      ground();
      return draw_story_side(
          canvas, art, {area.inset(std::min(area.w, area.h) * 0.1), info_type(art, area)});
    case PanelKind::top:
      return draw_top(canvas, art, area);
    case PanelKind::bottom:
      if (flat_box) {
        ground();
        return draw_full_back(canvas, art, info_field(canvas, area));
      }
      canvas.rectangle(area).fill(art.primary);
      return draw_bottom(canvas, art, {area, readable_on(art.primary, paper_white)});
    case PanelKind::skin:
      return;
  }
}

}  // namespace

Result<Image> draw_label(const Product& product, int size_px) {
  if (size_px < least_px || size_px > most_px) {
    return Error{
        "assets.bad_row",
        product.sku,
        "a label cannot be " + std::to_string(size_px) + " pixels high; choose 16 to 8192"};
  }
  MARKETGEN_TRY(const PackArt art, pack_art(product));
  MARKETGEN_TRY(const std::vector<Panel> panels, panels_of(product));
  MARKETGEN_TRY(const SheetSize size, sheet_size_of(product));
  const SheetPixels sheet = sheet_pixels(size, size_px);
  if (panels.size() == 1 && panels[0].kind == PanelKind::skin)
    return draw_produce_skin(art, sheet.width, sheet.height);
  Canvas canvas(sheet.width, sheet.height, art.primary);
  for (const Panel& panel : panels) {
    const Area px = panel_pixels(panel, sheet);
    const Area mm = millimetres(panel);
    const Canvas::Saved saved = canvas.saved();
    canvas.translate(px.x, px.y);
    canvas.scale(px.w / mm.w, px.h / mm.h);
    canvas.rectangle(mm).clip();
    draw_panel(canvas, art, panel.kind, mm);
  }
  if (!canvas.healthy()) {
    return Error{
        "internal.bug", product.sku, "Cairo refused a part of the label: please report it"};
  }
  return canvas.image();
}

}  // namespace marketgen
