// From bars left out on a canvas to bars on a label's sheet.
#pragma once
#include <optional>

#include "assets/print/canvas.h"
#include "assets/print/label.h"

namespace marketgen::assets {

std::optional<LabelBars> label_bars(const Canvas& canvas);

}  // namespace marketgen::assets
