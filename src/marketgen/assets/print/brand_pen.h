// What the mark shapes share: the place, the colours and the words of one mark being drawn.
#pragma once
#include <string>

#include "assets/print/brand_mark.h"
#include "assets/print/canvas.h"

namespace marketgen::assets {

// How much of a plate its words may take, and the plate's least width over its height.
struct PlateShape {
  double fill_x, fill_y, min_aspect;
};

struct MarkPen {
  Canvas& canvas;
  const BrandLook& look;
  const std::string& brand;
  Area area;
  Color ground;
  Align align;

  Color free_ink() const;   // of words on the pack's own ground
  Color free_trim() const;  // of ornaments there
  Color plate_ink() const { return readable_on(look.plate, look.trim); }

  // Words in the mark's type as large as they fit; on two lines where a long name has two words.
  Area words(const Area& at, const Color& color, Align across) const;
  // The same on one line, on the pack's ground; returns the box of the ink.
  Area line(const Area& at) const;
  void plate_words(const Area& at) const { words(at, plate_ink(), Align::center); }

  // The plate that the brand's words fill, as large as the area allows.
  Area plate(const PlateShape& shape) const;
  // Fills and outlines the path: plates carry a light outline, so that they stand off any pack.
  void fill_plate(double line_width) const;
};

#define MARK_SHAPE(name, description) void draw_mark_##name(const MarkPen& pen);
#include "assets/print/brand_shapes.inc"
#undef MARK_SHAPE

}  // namespace marketgen::assets
