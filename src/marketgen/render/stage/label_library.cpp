#include "render/stage/label_library.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/parallel.h"
#include "io/json.h"
#include "render/picture_cache.h"

namespace marketgen::render::raytrace {

namespace {

constexpr double distant_share = 1.0 / 4;  // of the pixels a millimetre
constexpr double usual_px_per_mm = 1.9, usual_area_mm2 = 200.0 * 200.0;

}  // namespace

double label_px_per_mm(const assets::SheetSize& size) {
  constexpr double falloff = 0.125;  // pixels grow with the area to the power of 3/4
  const double area_mm2 =
      static_cast<double>(size.width_m) * static_cast<double>(size.height_m) * 1e6;
  return usual_px_per_mm * std::pow(usual_area_mm2 / std::max(area_mm2, 1.0), falloff);
}

std::string label_content(const catalog::Product& product, PrintDetail detail) {
  return (detail == PrintDetail::near ? "library label " : "distant label ") +
         io::write_json_line(product);
}

Result<assets::PrintedPicture> library_label(const catalog::Product& product, PrintDetail detail) {
  const Result<assets::SheetSize> size =
      assets::sheet_size_of(product);  // products with a mesh of their own: none
  const double px_per_mm = size.ok() ? label_px_per_mm(*size) : usual_px_per_mm;
  return assets::print_label(product,
                             detail == PrintDetail::near ? px_per_mm : px_per_mm * distant_share);
}

Result<LabelLibrary> build_label_library(const std::vector<catalog::Product>& products,
                                         Progress& progress) {
  struct Made {
    std::uint64_t bytes = 0;
    bool drawn = false;
    std::optional<Error> unkept, error;
  };
  std::vector<Made> made(products.size());
  progress.begin("labels", products.size());
  parallel_for(products.size(), [&](std::size_t i) {
    const Result<Print> print =
        cached_print(label_content(products[i]), [&] { return library_label(products[i]); });
    if (print.ok())
      made[i] = {print->blocks.bytes(), print->drawn, print->unkept, std::nullopt};
    else
      made[i].error = print.error();
    progress.advance();
  });
  progress.end();
  LabelLibrary library;
  for (const Made& one : made) {
    if (one.error) return *one.error;
    library.labels += one.bytes > 0 ? 1 : 0;
    library.drawn += one.drawn ? 1 : 0;
    library.kept += one.bytes > 0 && !one.unkept ? 1 : 0;
    library.bytes += one.bytes;
    if (!library.unkept && one.bytes > 0) library.unkept = one.unkept;
  }
  return library;
}

}  // namespace marketgen::render::raytrace
