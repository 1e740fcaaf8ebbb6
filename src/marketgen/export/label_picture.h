// The printed sheet of a pack, as exports have it.
#pragma once
#include "assets/print/label.h"
#include "base/result.h"
#include "geometry/image.h"

namespace marketgen::exporters {

constexpr int exported_label_px = 256;  // rows: legible from arm's length, 20-60 kB each

// Kept between runs, so that every format draws it once. Errors: those of draw_label().
Result<Image> exported_label(const catalog::Product& product);

}  // namespace marketgen::exporters
