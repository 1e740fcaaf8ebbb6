// What every archetype answers, declared from archetypes.inc. The functions lie in
// archetypes/<name>.cpp.
#pragma once
#include <string_view>

#include "assets/product_model.h"
#include "base/result.h"
#include "catalog/product.h"

namespace marketgen::assets {

// make_<name>: the pack's mesh and surfaces; its bounds are the row's size. The caller has checked
// the size and adds the collision primitive. Errors: assets.bad_row for a colour that cannot be
// read. collision_<name>: the primitive that encloses it.
#define ARCHETYPE(name, description)                         \
  Result<ProductModel> make_##name(const catalog::Product&); \
  CollisionPrimitive collision_##name(const catalog::Product&);
#include "assets/shapes/archetypes.inc"
#undef ARCHETYPE

// Every size within the limits of Product::fields. Error: assets.bad_row.
Result<void> check_product_size(const catalog::Product& product);

// The catalog.unknown_kind error for an archetype that does not exist, with the nearest name.
Error unknown_archetype(std::string_view name, std::string where);

}  // namespace marketgen::assets
