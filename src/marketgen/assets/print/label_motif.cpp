#include "assets/print/label_motif.h"

#include <algorithm>
#include <string>

#include "assets/print/motif_brush.h"
#include "base/text.h"

namespace marketgen::assets {

const std::vector<LabelMotif>& label_motifs() {
  static const std::vector<LabelMotif> motifs{
#define MOTIF(name, use, description) {#name, MotifUse::use, description, draw_motif_##name},
#include "assets/print/label_motifs.inc"
#undef MOTIF
  };
  return motifs;
}

Result<const LabelMotif*> find_motif(std::string_view name, std::string_view where) {
  std::vector<std::string_view> names;
  for (const LabelMotif& motif : label_motifs()) {
    if (motif.name == name) return &motif;
    names.push_back(motif.name);
  }
  return Error{"assets.bad_row",
               std::string(where),
               "no motif is called \"" + std::string(name) + "\"" + did_you_mean(name, names)};
}

void draw_motif(Canvas& canvas, const LabelMotif& motif, const MotifInk& ink, const Area& area) {
  const double side = std::min(area.w, area.h);
  if (side <= 0) return;
  const Canvas::Saved saved = canvas.saved();
  canvas.translate(area.center_x(), area.center_y());
  canvas.scale(side / 100, side / 100);
  motif.draw(canvas, ink);
}

}  // namespace marketgen::assets
