// The products of a scene: SKU columns hold rows of the whole catalogue while it is made, and rows
// of the scene's own slice when it is done.
#pragma once
#include "catalog/catalog.h"
#include "scene/scene.h"

namespace marketgen::scene {

// Keeps the products that occur, sorted by SKU, and renumbers every reference.
void take_catalog_slice(Scene& scene, const catalog::Catalog& catalog);

// The way back: references to rows of the whole catalogue, and no slice. The catalogue must have
// every product of the scene.
void give_up_catalog_slice(Scene& scene, const catalog::Catalog& catalog);

}  // namespace marketgen::scene
