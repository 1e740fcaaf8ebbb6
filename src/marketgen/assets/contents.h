// What is seen through the clear wall of a pack, as the product's row says it.
#pragma once
#include "assets/product_model.h"
#include "base/result.h"
#include "catalog/rows.h"

namespace marketgen::assets {

// The wall of a clear pack with the row's contents behind it; `otherwise` when the row has none.
// Errors: assets.bad_row.
Result<Surface> contents_wall(const catalog::Product& product, float roughness, Surface otherwise);

// The material of a surface whose texture is "contents": pieces of one colour in another. Equal
// ones have one id. Precondition: the row has particles.
catalog::MaterialRow contents_material(const catalog::Contents& contents);

// Parts the clear walls at the level of what they hold: the wall above it becomes a surface of its
// own, `empty`. Textures of pieces are tiled from the foot on. The outline stays as it is; a model
// that shows no contents, too.
void part_at_level(ProductModel& model, const catalog::Product& product);

}  // namespace marketgen::assets
