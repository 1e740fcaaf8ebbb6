// Square pictures in rows: contact sheets.
#pragma once
#include <functional>

#include "base/result.h"
#include "geometry/image.h"

namespace marketgen::render {

// `count` pictures, each `size_px` a side, half as many columns again as rows, about; draw(i)
// makes number i. White where there is none.
Result<Image> picture_grid(std::size_t count,
                           int size_px,
                           const std::function<Result<Image>(std::size_t)>& draw);

}  // namespace marketgen::render
