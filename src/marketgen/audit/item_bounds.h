// Where every item is: its contact primitive's box in the store frame.
#pragma once
#include <vector>

#include "base/result.h"
#include "geometry/mesh.h"
#include "scene/scene.h"

namespace marketgen::audit {

// Axis-aligned store-frame bounds of each product's contact primitive. Exact for upright cylinders
// and turned boxes. Error: assets.bad_row.
Result<std::vector<Bounds3>> item_bounds(const scene::Scene& scene);

// Bounds of one primitive under a pose.
Bounds3 bounds_of(const assets::CollisionPrimitive& primitive, const Pose& target_from_item);

}  // namespace marketgen::audit
