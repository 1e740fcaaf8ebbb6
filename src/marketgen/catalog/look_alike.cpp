#include "catalog/look_alike.h"

#include <algorithm>
#include <cstdlib>

namespace marketgen::catalog {
namespace {

constexpr double near_size = 0.1;  // of the larger one

bool is_near_in_size(const Product& a, const Product& b) {
  for (std::size_t side = 0; side < 3; ++side)
    if (std::abs(a.size_mm[side] - b.size_mm[side]) >
        near_size * std::max(a.size_mm[side], b.size_mm[side]))
      return false;
  return true;
}

}  // namespace

bool are_look_alikes(const Product& a, const Product& b) {
  if (a.sku == b.sku) return false;
  if (!a.family.empty() && a.family == b.family) return true;
  return a.subcategory == b.subcategory && a.archetype == b.archetype && is_near_in_size(a, b);
}

}  // namespace marketgen::catalog
