// What every step of the layout works from: the plan, the rows it refers to, and the bare room.
#pragma once
#include <algorithm>

#include "catalog/catalog.h"
#include "layout/floor.h"
#include "layout/makes.h"
#include "plan/plan.h"

namespace marketgen::layout {

struct Design {
  const plan::Plan& plan;
  const catalog::Catalog& catalog;
  catalog::ProfileRow profile;  // defaults when the plan names none
  Floor floor;
  Makes makes = {};  // of a store with full outfit, while it is furnished

  // The least free floor before a stocked front. A grid cell is added to the wheelchair's width:
  // paths are checked on a 50 mm grid, which sees a passage only when it is that much wider.
  int min_aisle_mm() const {
    return std::max(profile.minimum_aisle_mm, profile.wheelchair_mm + 50);
  }
};

Design make_design(const plan::Plan& plan, const catalog::Catalog& catalog);

// The free floor a zone's runs want before them: aisle_mm, else by temperature and profile.
int wanted_aisle_mm(const Design& design, const plan::Zone& zone);

bool is_cold(const plan::Zone& zone, const catalog::Catalog& catalog);

}  // namespace marketgen::layout
