// The contact primitives of packs. Each is as large as the row's size allows and stands on z = 0.
#pragma once
#include "assets/product_model.h"

namespace marketgen::assets {

CollisionPrimitive box_around(const catalog::Product& product);
// Upright; the box when the footprint is not round enough for a circle to fill it.
CollisionPrimitive cylinder_around(const catalog::Product& product);
// Along X; the box when depth and height differ.
CollisionPrimitive lying_cylinder_around(const catalog::Product& product);
// The same for what grew: a round thing that bends or is a little flat, up to a third, is a
// cylinder too.
CollisionPrimitive grown_cylinder_around(const catalog::Product& product);
CollisionPrimitive ellipsoid_around(const catalog::Product& product);

}  // namespace marketgen::assets
