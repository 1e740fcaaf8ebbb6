// The smaller metrics of a store; docs/metrics.md defines them.
#pragma once
#include "catalog/catalog.h"
#include "scene/scene.h"

namespace marketgen {

// Width of the stocked blocks over the usable width of all shelves.
double shelf_fill(const Scene& scene);
// Floor open to shoppers: the room without backroom, checkout, customer-service and cafe zones.
double selling_area_m2(const Scene& scene);
// Aisles with shelving on both sides, or with shelving on one and a wall of goods on the other: what shoppers count.
int shopping_aisles(const Scene& scene);

}  // namespace marketgen
