// The design rules of layout_rules.inc, as data.
#pragma once
#include <string_view>
#include <vector>

#include "layout/layout.h"

namespace marketgen::layout {

// The ways in which repair_plan may change a plan: repair_moves.inc.
enum class RepairMove {
#define REPAIR_MOVE(name, what) name,
#include "layout/repair_moves.inc"
#undef REPAIR_MOVE
};

struct LayoutRule {
  std::string_view code;
  Severity severity;
  std::string_view summary;  // what must hold
  std::string_view source;   // who says so, and where the limit comes from
  std::vector<RepairMove> repairs;
};

// In the order of layout_rules.inc.
const std::vector<LayoutRule>& layout_rules();

}  // namespace marketgen::layout
