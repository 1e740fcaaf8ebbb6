// A changed plan laid out so that only what the change touches is furnished anew.
//
// A layout furnishes zone after zone, and what one zone gets decides what is left for the next: a
// plan that differs in one zone can move fixtures in another. Here the fixtures of zones that did
// not change stand where they stood, and the others are furnished round them.
#pragma once
#include <set>
#include <string>

#include "layout/layout.h"

namespace marketgen::layout {

// Ids of the zones of `after` that are to be furnished anew: those that are new or whose type,
// temperature, fixtures or floor changed; those at a door, window or column that changed; with an
// entrance or exit that changed also the tills; those of a fixture whose pinned value was changed
// or set free, or whose place is newly pinned. Preconditions: valid plans.
std::set<std::string> zones_to_furnish(const plan::Plan& before,
                                       const plan::Plan& after,
                                       const catalog::Catalog& catalog);

// The layout of `plan`, in which every zone but those in `furnish` has the fixtures that it has in
// `before`, bit for bit but for finishes that go with the look. Rules are checked as ever; nothing
// is repaired. Errors: of make_layout.
Result<Layout> make_layout_keeping(const plan::Plan& plan,
                                   const catalog::Catalog& catalog,
                                   Seed seed,
                                   const Layout& before,
                                   const std::set<std::string>& furnish);

}  // namespace marketgen::layout
