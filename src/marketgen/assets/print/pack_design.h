// Pack designs: where brand, name, picture and quantity stand on a front, and what is behind them.
#pragma once
#include <string_view>
#include <vector>

#include "assets/print/canvas.h"
#include "assets/print/lettering.h"
#include "assets/print/pack_art.h"

namespace marketgen::assets {

enum class VariantMark { plain, band, pill };

// Places for the parts of a front in millimetres, each with the colour that lies under it.
struct FrontPlan {
  Area brand;
  Color brand_ground;
  Align align = Align::center;  // of brand, name and variant
  Area name;
  Color name_ground;
  Area variant;
  VariantMark variant_mark = VariantMark::band;
  Color variant_ground;  // of the band or pill, or what lies under plain type
  Area motif;
  Area net;
  Color net_ground;
  Align net_align = Align::center;
  Area badge;  // a round spot that is free for a claim; empty = none
};

struct PackDesign {
  std::string_view name, description;
  // Paints the ground of any side of the pack; looks the same all along x, so that neighbouring
  // sides join.
  void (*ground)(Canvas& canvas, const PackArt& art, const Area& area);
  // Paints the ornament of the front over its ground and says where things go.
  FrontPlan (*face)(Canvas& canvas, const PackArt& art, const Area& area);
};

const std::vector<PackDesign>& pack_designs();  // in the order of pack_designs.inc
const PackDesign& design_of(const PackArt& art);

// A front that is this much wider than high has its picture beside the words.
constexpr bool is_wide(const Area& area) {
  return area.w > 1.25 * area.h;
}
// The narrow long side of a flat box: every design puts brand, name and picture in a row.
constexpr bool is_strip(const Area& area) {
  return area.w > 2.3 * area.h;
}
FrontPlan draw_strip_face(Canvas& canvas, const PackArt& art, const Area& area);

#define PACK_DESIGN(name, description)                                           \
  void draw_ground_##name(Canvas& canvas, const PackArt& art, const Area& area); \
  FrontPlan draw_face_##name(Canvas& canvas, const PackArt& art, const Area& area);
#include "assets/print/pack_designs.inc"
#undef PACK_DESIGN

}  // namespace marketgen::assets
