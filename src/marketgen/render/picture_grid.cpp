#include "render/picture_grid.h"

#include <algorithm>
#include <cmath>

namespace marketgen::render {
namespace {

constexpr double columns_over_rows = 1.5;

}  // namespace

Result<Image> picture_grid(std::size_t count,
                           int size_px,
                           const std::function<Result<Image>(std::size_t)>& draw) {
  const int columns = std::max(
      1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count) * columns_over_rows))));
  const int rows = (static_cast<int>(count) + columns - 1) / columns;
  Image sheet(columns * size_px, std::max(1, rows) * size_px);
  std::fill(sheet.pixels.begin(), sheet.pixels.end(), std::uint8_t{255});
  for (std::size_t i = 0; i < count; ++i) {
    MARKETGEN_TRY(const Image picture, draw(i));
    const int x0 = static_cast<int>(i) % columns * size_px;
    const int y0 = static_cast<int>(i) / columns * size_px;
    for (int y = 0; y < size_px; ++y)
      std::copy_n(picture.at(0, y), static_cast<std::size_t>(size_px) * 3, sheet.at(x0, y0 + y));
  }
  return sheet;
}

}  // namespace marketgen::render
