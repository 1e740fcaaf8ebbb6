// What a pack is usually made of and how it rubs, for rows that do not say.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "catalog/product.h"
#include "catalog/rows.h"

namespace marketgen::catalog {

// The contact material that most of `rows` with the product's archetype have, else most of its
// subcategory, else most of its category; ties by name. "cardboard" when no row is like it.
std::string usual_material(const std::vector<Product>& rows, const Product& product);

// Of the material on painted steel; null when data/friction.json has no such pair.
const FrictionRow* friction_on_steel(const std::vector<FrictionRow>& rows,
                                     std::string_view material);

}  // namespace marketgen::catalog
