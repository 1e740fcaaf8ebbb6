// Brand marks: every brand name has its own logo, type and pack design, derived from the name
// alone.
#pragma once
#include <array>
#include <string>
#include <string_view>

#include "assets/print/canvas.h"
#include "assets/print/lettering.h"

namespace marketgen::assets {

enum class MarkShape {
#define MARK_SHAPE(name, description) name,
#include "assets/print/brand_shapes.inc"
#undef MARK_SHAPE
};
constexpr auto names_of(MarkShape) {
  return std::to_array<std::string_view>({
#define MARK_SHAPE(name, description) #name,
#include "assets/print/brand_shapes.inc"
#undef MARK_SHAPE
  });
}

// What all packs of a brand share.
struct BrandLook {
  MarkShape shape = MarkShape::wordmark;
  Typeface mark_face;      // the brand's own lettering
  Typeface name_face;      // product names
  Color plate;             // ground of enclosed marks (oval, block, shield…)
  Color trim;              // their outline, the swoosh, the leaf…
  std::size_t design = 0;  // index into pack_designs(), modulo their number
  int pattern = 0;         // tone-on-tone ornament of the ground
};

BrandLook brand_look(std::string_view brand);

// Draws the mark into `area`, on a pack whose colour there is `ground`. Nothing for an empty name.
void draw_brand_mark(Canvas& canvas,
                     const BrandLook& look,
                     const std::string& brand,
                     const Area& area,
                     const Color& ground,
                     Align align = Align::center);

}  // namespace marketgen::assets
