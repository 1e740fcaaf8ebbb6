// The pictures on labels: vector drawings by name, listed in label_motifs.inc.
//
// A motif is drawn into the square from -50 to 50 along both axes, y down, lit from the upper left.
#pragma once
#include <string_view>
#include <vector>

#include "assets/print/canvas.h"
#include "base/result.h"

namespace marketgen::assets {

// The pack's colours, for motifs that have none of their own (sparkle, flower, rings…).
struct MotifInk {
  Color primary, secondary, accent;
};

enum class MotifUse { single, strewn };

struct LabelMotif {
  std::string_view name;
  MotifUse use;
  std::string_view description;
  void (*draw)(Canvas& canvas, const MotifInk& ink);
};

// Every motif, in the order of label_motifs.inc.
const std::vector<LabelMotif>& label_motifs();

// Errors: assets.bad_row, with the nearest name.
Result<const LabelMotif*> find_motif(std::string_view name, std::string_view where);

// Draws the motif as large as it fits into the middle of `area`.
void draw_motif(Canvas& canvas, const LabelMotif& motif, const MotifInk& ink, const Area& area);

}  // namespace marketgen::assets
