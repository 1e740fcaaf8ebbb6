// EAN-13 bar codes, encoded by zint and drawn as rectangles on whole pixels.
#pragma once
#include <string>
#include <string_view>

#include "assets/print/canvas.h"
#include "base/result.h"

namespace marketgen::assets {

// 95 modules, '1' for a bar. Errors: assets.bad_row when `ean` is not 13 digits with a right check
// digit.
Result<std::string> ean13_modules(std::string_view ean, std::string_view where);

// Widths in modules: the symbol with the quiet zones that GS1 asks for (11 left, 7 right).
constexpr int ean13_width_modules = 11 + 95 + 7;

// The symbol with its quiet zones, white ground and digits, in pixels; (x, y) is its upper left
// corner.
struct BarcodePlace {
  int x = 0, y = 0;
  int module_px = 2;
  int height_px = 60;   // bars and digits
  bool ladder = false;  // turned a quarter, bars lying: `height_px` then runs along x
};

// The place in an area (pixels) with modules as near to `wanted_px` as the area allows, standing if
// that loses nothing, at the area's lower right corner; its height is the wanted one as far as a
// symbol's usual proportions allow. `module_px` is 0 when not even one pixel a module fits.
BarcodePlace place_barcode(const Area& area_px, int wanted_px, double wanted_height_px);

void draw_barcode(Canvas& canvas,
                  const std::string& modules,
                  std::string_view ean,
                  const BarcodePlace& place);

// The same with everything in `place` counted in `unit`s of the canvas instead of pixels. White
// ground and digits are drawn; the bars are left to the reader of the picture, which shows their
// mean grey (Canvas::bars).
void leave_barcode(Canvas& canvas,
                   const std::string& modules,
                   std::string_view ean,
                   const BarcodePlace& place,
                   double unit);

}  // namespace marketgen::assets
