// The label library: the printed sheet of every product as textures keep it, compressed and cached.
//
// A store asks for the sheets of what it shows; `build_label_library` draws them all beforehand.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assets/print/label.h"
#include "assets/print/label_sheet.h"
#include "base/progress.h"
#include "base/result.h"
#include "catalog/product.h"
#include "render/render.h"

namespace marketgen::render::raytrace {

// Pixels a millimetre of a sheet in the library: 1.9 for a sheet of 200 x 200 mm, more for smaller
// ones, which are looked at from nearer, less for larger ones. All sheets of the catalogue together
// then take some 120 kB each.
double label_px_per_mm(const assets::SheetSize& size);

// What decides a product's sheet in the library: the key of cached_print().
std::string label_content(const catalog::Product& product, PrintDetail detail = PrintDetail::near);
// Draws it. Errors: as print_label().
Result<assets::PrintedPicture> library_label(const catalog::Product& product,
                                             PrintDetail detail = PrintDetail::near);

struct LabelLibrary {
  std::size_t labels = 0;       // products that show a sheet
  std::size_t drawn = 0;        // of them, now; the others were in the cache
  std::size_t kept = 0;         // of them, in the cache now
  std::uint64_t bytes = 0;      // of all their textures in memory
  std::optional<Error> unkept;  // why the first that is not there could not be put there
};

// Puts the sheets of all products in the cache, side by side. Errors: as print_label(), of the
// first product in order.
Result<LabelLibrary> build_label_library(const std::vector<catalog::Product>& products,
                                         Progress& progress);

}  // namespace marketgen::render::raytrace
