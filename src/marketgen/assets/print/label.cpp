#include "assets/print/label.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "assets/materials/produce_skin.h"
#include "assets/own_pack.h"
#include "assets/print/label_bars.h"
#include "assets/print/label_sheet.h"
#include "assets/print/pack_art.h"
#include "assets/print/pack_back.h"
#include "assets/print/pack_design.h"
#include "assets/print/pack_front.h"
#include "assets/print/pack_pictures.h"

namespace marketgen::assets {
namespace {

constexpr int min_px = 16;
constexpr int max_px = 8192;
constexpr double min_px_per_mm = 0.1, max_px_per_mm = 20;
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
    return std::max(min_px, static_cast<int>(std::lround(pixels)));
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

// What of a face turns away from the eye, in shares of its width (left and right) and height (above
// and below): round bottles, seals, film drawn around a corner.
struct FlatRow {
  std::string_view archetype;
  double side, end;
};
constexpr FlatRow bag_flat{"", 0.06, 0.08};
constexpr FlatRow flat_rows[] = {
    {"flask", 0.11, 0.02},          {"tube", 0.11, 0.02},
    {"squeeze_bottle", 0.05, 0.03}, {"milk_jug", 0.04, 0.03},
    {"jerrycan", 0.03, 0.02},       {"detergent_bottle", 0.04, 0.02},
    {"spray_bottle", 0.05, 0.02},   {"pump_bottle", 0.05, 0.02},
    {"stick", 0.05, 0.03},          {"flow_pack", 0.10, 0.17},
    {"chub", 0.03, 0.14},           {"baguette_bag", 0.10, 0.10},
    {"blister", 0.03, 0.03},        {"net_bag", 0.04, 0.06},
    {"can_six_pack", 0.09, 0.05},   {"bottle_six_pack", 0.09, 0.03},
    {"roll_pack", 0.10, 0.06},      {"soft_pack", 0.06, 0.13},
    {"loaf", 0.18, 0.06},           {"bundle", 0.08, 0.12},
};

// The part of a face that lies flat before the eye; see "Sheets" in assets/print/label.h.
Area flat_part(const catalog::Product& product, SheetKind kind, const Area& area) {
  FlatRow flat = kind == SheetKind::front_back ? bag_flat : FlatRow{"", 0, 0};
  for (const FlatRow& row : flat_rows) {
    if (row.archetype == product.archetype) flat = row;
  }
  return area.part(flat.side, flat.end, 1 - flat.side, 1 - flat.end);
}

// Goods are seen through the film of a tray.
bool is_under_film(const catalog::Product& product) {
  return product.archetype == "tray" || product.archetype == "meat_tray";
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

// What a sleeve, a lid or a label says on one face: the front, and beside or below it the rest.
void draw_sleeve_print(Canvas& canvas, const PackArt& art, const Area& sleeve) {
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
  draw_sleeve_print(canvas, art, sleeve);
}

// A box that lies on its back, like a pizza's: its top is what the eye meets.
bool is_flat_box(const catalog::Product& product) {
  const bool box = product.archetype == "box" || product.archetype == "bundle";
  return box && product.size_mm[1] * 2 > product.size_mm[2] * 3;
}

void draw_top(Canvas& canvas, const PackArt& art, const Area& area) {
  if (is_under_film(*art.product)) return draw_sleeve_top(canvas, art, area);
  if (sheet_kind_of(art.product->archetype).value() == SheetKind::sleeve)
    return draw_sleeve_print(canvas, art, area);
  if (is_flat_box(*art.product)) {
    design_of(art).ground(canvas, art, area);
    return draw_front(canvas, art, area);
  }
  canvas.rectangle(area).fill(art.primary);
  const std::array<int, 3>& size = art.product->size_mm;
  if (art.product->archetype == "soft_pack" && size[2] < size[1]) {
    // In front of the flip lid.
    return draw_title(canvas, art, area.part(0.08, 0.82, 0.92, 0.97), art.primary);
  }
  if (art.product->archetype == "gable_carton") {
    // The lower part slopes to the front; the cap sits left of its middle.
    return draw_title(canvas, art, area.part(0.46, 0.62, 0.94, 0.94), art.primary);
  }
  draw_title(canvas, art, area.part(0.18, 0.26, 0.82, 0.74), art.primary);
}

void draw_panel(Canvas& canvas, const PackArt& art, PanelKind kind, const Area& area) {
  const SheetKind sheet = sheet_kind_of(art.product->archetype).value();
  const bool bag_or_bottle = sheet == SheetKind::front_back;
  const Area flat = flat_part(*art.product, sheet, area);
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
      if (is_under_film(*art.product))
        return draw_title(canvas, art, area.inset(area.h * 0.12), art.primary);
      return draw_front(canvas, art, flat);
    case PanelKind::back:
      ground();
      if (bag_or_bottle) return draw_full_back(canvas, art, info_field(canvas, flat));
      draw_back(canvas, art, info_field(canvas, flat));
      return;
    case PanelKind::right:
      ground();
      return draw_nutrition_side(canvas, art, info_field(canvas, flat));
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

// Draws every panel; bars stay apart when the art says so.
Result<PrintedPicture> drawn_sheet(const PackArt& art, const SheetPixels& sheet) {
  const catalog::Product& product = *art.product;
  MARKETGEN_TRY(const std::vector<Panel> panels, panels_of(product));
  if (panels.size() == 1 && panels[0].kind == PanelKind::skin)
    return PrintedPicture{draw_produce_skin(art, sheet.width, sheet.height), std::nullopt};
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
  return PrintedPicture{canvas.image(), label_bars(canvas)};
}

}  // namespace

Result<Image> draw_label(const catalog::Product& product, int size_px) {
  if (size_px < min_px || size_px > max_px) {
    return Error{
        "assets.bad_row",
        product.sku,
        "a label cannot be " + std::to_string(size_px) + " pixels high; choose 16 to 8192"};
  }
  if (has_own_mesh(product)) return own_pack_picture(product, size_px);
  MARKETGEN_TRY(const SheetSize size, sheet_size_of(product));
  const SheetPixels pixels = sheet_pixels(size, size_px);
  if (product.faces) return pictured_sheet(product, pixels.width, pixels.height);
  MARKETGEN_TRY(const PackArt art, pack_art(product));
  MARKETGEN_TRY(PrintedPicture sheet, drawn_sheet(art, pixels));
  return std::move(sheet.picture);
}

Result<PrintedPicture> print_label(const catalog::Product& product, double px_per_mm) {
  if (px_per_mm < min_px_per_mm || px_per_mm > max_px_per_mm) {
    return Error{"assets.bad_row",
                 product.sku,
                 fmt::format("a label cannot have {} pixels a millimetre; choose {} to {}",
                             px_per_mm,
                             min_px_per_mm,
                             max_px_per_mm)};
  }
  const auto pixels = [&](double metres) {
    return std::clamp(static_cast<int>(std::lround(metres * 1e3 * px_per_mm)), min_px, max_px);
  };
  if (has_own_mesh(product)) {
    MARKETGEN_TRY(Image picture, own_pack_picture(product, pixels(product.height_m())));
    return PrintedPicture{std::move(picture), std::nullopt};
  }
  MARKETGEN_TRY(const SheetSize size, sheet_size_of(product));
  const SheetPixels sheet{pixels(static_cast<double>(size.width_m)),
                          pixels(static_cast<double>(size.height_m))};
  if (product.faces) {
    MARKETGEN_TRY(Image picture, pictured_sheet(product, sheet.width, sheet.height));
    return PrintedPicture{std::move(picture), std::nullopt};
  }
  MARKETGEN_TRY(PackArt art, pack_art(product));
  art.bars_apart = true;
  return drawn_sheet(art, sheet);
}

}  // namespace marketgen::assets
