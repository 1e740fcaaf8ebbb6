#include "assets/print/barcode.h"

#include <zint.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "assets/print/lettering.h"

namespace marketgen::assets {
namespace {

constexpr int left_quiet_modules = 11;
constexpr int symbol_modules = 95;
// Height over width of the whole symbol: 0.69 nominal (22.85 mm over 37.29 mm with digits); packs
// often cut it lower.
constexpr double usual_aspect = 0.62;
constexpr double lowest_aspect = 0.30;

bool is_guard(int module) {
  return module < 3 || module >= symbol_modules - 3 || (module >= 45 && module < 50);
}

// The digits' share of the symbol's height; guard bars reach half way into it.
constexpr double digits_share = 0.2;

int bar_length(const BarcodePlace& place, bool guard) {
  const int digits = static_cast<int>(place.height_px * digits_share);
  return place.height_px - (guard ? digits / 2 : digits);
}

void draw_bars(Canvas& canvas, const std::string& modules, const BarcodePlace& place) {
  for (int i = 0; i < symbol_modules; ++i) {
    if (modules[static_cast<std::size_t>(i)] != '1') continue;
    canvas.rectangle({static_cast<double>((left_quiet_modules + i) * place.module_px),
                      0,
                      static_cast<double>(place.module_px),
                      static_cast<double>(bar_length(place, is_guard(i)))});
  }
  canvas.fill(Color{0, 0, 0});
}

void draw_digits(Canvas& canvas, std::string_view ean, const BarcodePlace& place) {
  constexpr double min_height_px = 5;  // no reader, human or not, gains from four-pixel digits
  const double m = place.module_px;
  const double h = place.height_px * digits_share;
  if (h * canvas.pixels_per_unit_y() < min_height_px) return;
  const Typeface face{"DejaVu Sans Mono", 400};
  const auto group = [&](std::string_view digits, double first_module, double width_modules) {
    draw_headline(canvas,
                  {std::string(digits),
                   face,
                   print_ink,
                   {first_module * m, place.height_px - h * 0.94, width_modules * m, h * 0.94}});
  };
  group(ean.substr(0, 1), 1, 8);
  group(ean.substr(1, 6), left_quiet_modules + 4, 40);
  group(ean.substr(7, 6), left_quiet_modules + 51, 40);
}

// Moves the canvas to the symbol's upper left corner, turned as it lies.
void enter(Canvas& canvas, const BarcodePlace& place) {
  canvas.translate(place.x, place.y);
  if (!place.ladder) return;
  // A quarter turn written out, so that pixels stay whole.
  const cairo_matrix_t quarter{0, 1, -1, 0, static_cast<double>(place.height_px), 0};
  cairo_transform(canvas.context(), &quarter);
}

void draw_ground(Canvas& canvas, const BarcodePlace& place) {
  const int length = place.module_px * ean13_width_modules;
  canvas.rectangle({0, 0, static_cast<double>(length), static_cast<double>(place.height_px)})
      .fill(paper_white);
}

// The box of an area in pixels; its corners may have changed places.
Area device_box(Canvas& canvas, const Area& area) {
  double x0 = area.x, y0 = area.y, x1 = area.right(), y1 = area.bottom();
  cairo_user_to_device(canvas.context(), &x0, &y0);
  cairo_user_to_device(canvas.context(), &x1, &y1);
  return {std::min(x0, x1), std::min(y0, y1), std::fabs(x1 - x0), std::fabs(y1 - y0)};
}

}  // namespace

Result<std::string> ean13_modules(std::string_view ean, std::string_view where) {
  const bool digits =
      ean.size() == 13 && ean.find_first_not_of("0123456789") == std::string_view::npos;
  if (!digits) {
    return Error{"assets.bad_row",
                 std::string(where),
                 "\"" + std::string(ean) + "\" is not an EAN-13; give 13 digits"};
  }
  const std::unique_ptr<zint_symbol, decltype(&ZBarcode_Delete)> symbol(ZBarcode_Create(),
                                                                        ZBarcode_Delete);
  symbol->symbology = BARCODE_EANX_CHK;  // checks the thirteenth digit
  const std::string text(ean);
  const int status = ZBarcode_Encode(symbol.get(),
                                     reinterpret_cast<const unsigned char*>(text.c_str()),
                                     static_cast<int>(text.size()));
  if (status >= ZINT_ERROR || symbol->width != symbol_modules) {
    return Error{
        "assets.bad_row",
        std::string(where),
        "EAN " + text + " cannot be encoded (" + symbol->errtxt + "); correct its check digit"};
  }
  std::string modules;
  for (int i = 0; i < symbol_modules; ++i) {
    const bool bar = (symbol->encoded_data[0][i >> 3] >> (i & 7)) & 1;
    modules += bar ? '1' : '0';
  }
  return modules;
}

BarcodePlace place_barcode(const Area& area_px, int wanted_px, double wanted_height_px) {
  const int w = static_cast<int>(area_px.w);
  const int h = static_cast<int>(area_px.h);
  const auto module_along = [&](int length, int across) {
    const int by_length = length / ean13_width_modules;
    const int by_height = static_cast<int>(across / (lowest_aspect * ean13_width_modules));
    return std::min({wanted_px, by_length, by_height});
  };
  const int standing = module_along(w, h);
  const int lying = module_along(h, w);
  BarcodePlace place;
  place.ladder = lying > standing;
  place.module_px = std::max({standing, lying, 0});
  const int length = place.module_px * ean13_width_modules;
  const int across = place.ladder ? w : h;
  const double height = std::clamp(wanted_height_px, length * lowest_aspect, length * usual_aspect);
  place.height_px = std::min(across, static_cast<int>(height));
  place.x = static_cast<int>(area_px.right()) - (place.ladder ? place.height_px : length);
  place.y = static_cast<int>(area_px.bottom()) - (place.ladder ? length : place.height_px);
  return place;
}

void draw_barcode(Canvas& canvas,
                  const std::string& modules,
                  std::string_view ean,
                  const BarcodePlace& place) {
  if (place.module_px <= 0) return;
  const Canvas::Saved saved = canvas.saved();
  cairo_identity_matrix(canvas.context());  // whole pixels: the caller's transform is left aside
  enter(canvas, place);
  draw_ground(canvas, place);
  cairo_set_antialias(canvas.context(), CAIRO_ANTIALIAS_NONE);
  draw_bars(canvas, modules, place);
  cairo_set_antialias(canvas.context(), CAIRO_ANTIALIAS_GRAY);
  draw_digits(canvas, ean, place);
}

void leave_barcode(Canvas& canvas,
                   const std::string& modules,
                   std::string_view ean,
                   const BarcodePlace& place,
                   double unit) {
  if (place.module_px <= 0) return;
  const Canvas::Saved saved = canvas.saved();
  canvas.scale(unit, unit);
  enter(canvas, place);
  draw_ground(canvas, place);
  draw_digits(canvas, ean, place);
  const double plain = bar_length(place, false), guarded = bar_length(place, true);
  const Area bars{static_cast<double>(left_quiet_modules * place.module_px),
                  0,
                  static_cast<double>(symbol_modules * place.module_px),
                  guarded};
  // Half of the light, as half of the modules are bars: in sRGB 188 of 255.
  canvas.rectangle({bars.x, bars.y, bars.w, plain}).fill(rgb("#bcbcbc"));
  canvas.leave_bars({device_box(canvas, bars), modules, place.ladder, 1 - plain / guarded});
}

}  // namespace marketgen::assets
