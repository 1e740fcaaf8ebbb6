// The relations of a plan, measured on its layout (plan/relation.h).
#pragma once
#include "layout/layout.h"
#include "plan/relation.h"

namespace marketgen::layout {

// The layout's floor with its zones and openings. Views of the layout.
plan::NamedFloor named_floor(const Layout& layout);

// The slack that the layout rules ask for. None: the audit measures these very zones.
constexpr double layout_margin_m = 0;

}  // namespace marketgen::layout
