// What the look does to fixtures that stand.
#pragma once
#include "layout/layout.h"

namespace marketgen::layout {

// The finish of shelving, from one look to another. Cabinets, counters and fixtures whose finish
// was asked for keep theirs.
void change_finish(Fixture& fixture,
                   const plan::Look& from,
                   const plan::Look& to,
                   const catalog::Catalog& catalog);

}  // namespace marketgen::layout
