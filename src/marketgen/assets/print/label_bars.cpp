#include "assets/print/label_bars.h"

namespace marketgen::assets {

std::optional<LabelBars> label_bars(const Canvas& canvas) {
  if (!canvas.bars()) return std::nullopt;
  const BarField& field = *canvas.bars();
  const auto share = [](double pixels, int of) { return static_cast<float>(pixels / of); };
  return LabelBars{share(field.px.x, canvas.width_px()),
                   share(field.px.y, canvas.height_px()),
                   share(field.px.right(), canvas.width_px()),
                   share(field.px.bottom(), canvas.height_px()),
                   static_cast<float>(field.foot),
                   field.ladder,
                   field.modules};
}

}  // namespace marketgen::assets
