// Products that may be taken for one another on a shelf. Both point into `rows`, the most alike in
// size first.
#pragma once
#include <vector>

#include "catalog/product.h"

namespace marketgen::perception {

// Of its category and much its size, at most 20: what is mistaken for it from afar.
std::vector<const catalog::Product*> rivals_of(const catalog::Product& product,
                                               const std::vector<catalog::Product>& rows);

// Of any category, from a little smaller to much larger, at most 150: of what it may be a part to
// the eye.
std::vector<const catalog::Product*> rivals_of_any_kind(const catalog::Product& product,
                                                        const std::vector<catalog::Product>& rows);

}  // namespace marketgen::perception
