#include "catalog/full_name.h"

namespace marketgen::catalog {

std::string full_name(const Product& product) {
  std::string name = product.brand;
  for (const std::string* part : {&product.name, &product.variant})
    if (!part->empty()) name += (name.empty() ? "" : " ") + *part;
  return name;
}

}  // namespace marketgen::catalog
