// layout.png: the labelled plan of a layout, drawn with Cairo.
#pragma once
#include "catalog/catalog.h"
#include "geometry/image.h"
#include "layout/layout.h"

namespace marketgen::layout {

// North up; zones in their palette with names and areas, fixtures with front arrows, openings,
// aisles with widths, the path from entrance to checkout to exit, violations numbered, a scale bar.
// `size_px` is the longer side. Deterministic.
Image draw_layout(const Layout& layout, const catalog::Catalog& catalog, int size_px = 1600);

}  // namespace marketgen::layout
