// From a plan to a layout that keeps its hard rules: mended where mending helps, and where it does
// not, planned again with less.
#pragma once
#include <functional>
#include <optional>

#include "base/result.h"
#include "base/seed.h"
#include "catalog/catalog.h"
#include "intake/brief.h"
#include "layout/layout.h"

namespace marketgen::store {

struct Designed {
  intake::Planned planned;
  layout::Repaired repaired;
  layout::Layout layout;
};

// The seeds of a store's planner and of its layout: its own, or those of the axis `layout`.
Seed plan_seed(const std::optional<plan::Vary>& vary, Seed store);
Seed layout_seed(const std::optional<plan::Vary>& vary, Seed store);

bool keeps_hard_rules(const std::vector<layout::Violation>& rules);

// The layout, or one without a fixture that says so in its violations. The first takes it out of
// `repaired` where it has it.
Result<layout::Layout> layout_of(layout::Repaired& repaired,
                                 const catalog::Catalog& catalog,
                                 Seed seed);
Result<layout::Layout> layout_or_nothing(const plan::Plan& plan,
                                         const catalog::Catalog& catalog,
                                         Seed seed);

// The same brief planned again.
using PlanAgain = std::function<Result<intake::Planned>(const intake::Concessions&)>;

// The nearest store to `first` that breaks no hard rule: gives up, step by step, what stands in the
// way (lanes for a counter, tills, relations, the least important zones) and names each wish that
// was given up in planned.conflicts. The store with the fewest hard faults when none keeps them
// all. The wishes stay as they are: the audit says which were met.
Result<Designed> concede(Designed first,
                         const PlanAgain& plan_again,
                         const catalog::Catalog& catalog,
                         Seed layout_seed);

// Plan, repair and layout of a brief, conceding what must be.
Result<Designed> design_store(const intake::Brief& brief,
                              const catalog::Catalog& catalog,
                              Seed seed);

}  // namespace marketgen::store
