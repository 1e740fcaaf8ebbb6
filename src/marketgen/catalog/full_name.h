// What a product is called in tables.
#pragma once
#include <string>

#include "catalog/product.h"

namespace marketgen::catalog {

// "Fonda Cola Zero Sugar": brand, name and variant.
std::string full_name(const Product& product);

}  // namespace marketgen::catalog
