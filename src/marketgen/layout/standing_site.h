// A site on which fixtures stand already.
#pragma once
#include <vector>

#include "layout/site.h"

namespace marketgen::layout {

// Puts fixtures where they stood, in their order, and keeps free before and behind them what was
// when they were placed; of the profile's clearance before and after tills, `line_share`.
void stand_again(Site& site,
                 const Design& design,
                 const std::vector<Fixture>& fixtures,
                 double line_share = 1);

}  // namespace marketgen::layout
