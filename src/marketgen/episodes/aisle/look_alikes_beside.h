// Goods on a shelf that are easily mistaken for what stands close by.
#pragma once
#include <set>
#include <string>

#include "scene/scene.h"

namespace marketgen::episodes {

inline constexpr double alike_within_m = 1.0;  // between two items: what one arm's reach takes in

// SKUs of which some item has an item of a look-alike (catalog/look_alike.h) at most alike_within_m
// away. Looks at the first item of each facing.
std::set<std::string> skus_with_look_alikes_beside(const scene::Scene& scene);

}  // namespace marketgen::episodes
