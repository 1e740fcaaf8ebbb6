// A store's boards fitted to its goods: plan::ShelfPitch::fitted.
#pragma once
#include "base/seed.h"
#include "catalog/catalog.h"
#include "layout/layout.h"
#include "plan/plan.h"
#include "scene/bays.h"
#include "scene/scene.h"

namespace marketgen::scene {

struct FittedShelves {
  layout::Layout layout;  // fixtures whose boards can be moved have spacings
  BayRanges ranges;       // of all bays but those of offers
};

// The layout with boards that nobody has fitted.
layout::Layout with_even_boards(layout::Layout layout);

// As it was before its boards were fitted: also as many as the fixture's row has, where the plan
// does not say how many.
layout::Layout before_fitting(layout::Layout layout,
                              const plan::Plan& plan,
                              const catalog::Catalog& catalog);

// Whether two layouts differ in nothing but how boards were fitted.
bool same_but_for_boards(const layout::Layout& a, const layout::Layout& b);

// `bare`: the store without goods, with even boards. Boards stay where the plan says how far they
// are apart; their number stays where it says that. What a zone gets follows from its own bays,
// stock and the shop's kind alone. `seed`: that of what stands where.
FittedShelves fit_shelves(const Scene& bare,
                          const plan::Plan& plan,
                          const catalog::Catalog& catalog,
                          Seed seed);

}  // namespace marketgen::scene
