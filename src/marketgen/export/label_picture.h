// The printed sheet of a pack and its price tag, as exports and the viewer have them. Kept between
// runs, so that every format draws them once.
#pragma once
#include "assets/print/label.h"
#include "base/result.h"
#include "geometry/image.h"

namespace marketgen::exporters {

constexpr int exported_label_px = 256;  // rows: legible from arm's length, 20-60 kB each

// Errors: those of draw_label(), of draw_price_tag().
Result<Image> exported_label(const catalog::Product& product, int height_px = exported_label_px);
Result<Image> exported_price_tag(const catalog::Product& product, bool promotion, int height_px);

}  // namespace marketgen::exporters
