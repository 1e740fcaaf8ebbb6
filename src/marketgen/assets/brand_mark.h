// Brand marks: every brand name has its own logo, type and pack design, derived from the name
// alone.
#pragma once
#include <array>
#include <string>
#include <string_view>

#include "assets/canvas.h"
#include "assets/lettering.h"

namespace marketgen {

enum class MarkShape {
  wordmark,
  swoosh,
  oval,
  block,
  shield,
  ribbon,
  leaf,
  roundel,
  rules,
  sun,
  diamond,
  initial
};
constexpr std::array<std::string_view, 12> names_of(MarkShape) {
  return {"wordmark",
          "swoosh",
          "oval",
          "block",
          "shield",
          "ribbon",
          "leaf",
          "roundel",
          "rules",
          "sun",
          "diamond",
          "initial"};
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

}  // namespace marketgen
