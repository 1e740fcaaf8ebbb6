// The changes that repair_plan may try on a plan, each bound to a broken rule.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "layout/layout.h"
#include "layout/layout_rules.h"

namespace marketgen::layout {

// A changed plan, not yet known to be better or even valid.
struct RepairCandidate {
  plan::Plan plan;
  std::string change;              // one sentence
  std::vector<std::string> paths;  // JSON pointers of what changed
};

// What a move knows of the fault it shall mend.
struct RepairTask {
  const plan::Plan& plan;
  const Layout& layout;
  const Violation& violation;
  const catalog::Catalog& catalog;
};

// "makes the aisle between two halves of the floor wider"
std::string_view words_of(RepairMove move);

// At most six candidates, the gentlest first.
std::vector<RepairCandidate> propose(RepairMove move, const RepairTask& task);

}  // namespace marketgen::layout
