// The smaller metrics of a store; docs/metrics.md defines them.
#pragma once
#include "catalog/catalog.h"
#include "scene/scene.h"

namespace marketgen::audit {

// Width of the stocked blocks over the usable width of all shelves.
double shelf_fill(const scene::Scene& scene);
// Floor open to shoppers: the room without backroom, checkout, customer-service and cafe zones.
double selling_area_m2(const scene::Scene& scene);
// Aisles as shoppers count them: the most gaps between stocked fixtures that a straight line across
// the free-standing runs crosses.
int shopping_aisles(const scene::Scene& scene);

}  // namespace marketgen::audit
