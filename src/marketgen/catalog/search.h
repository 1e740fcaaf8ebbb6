// Free-text search over the products.
#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include "catalog/catalog.h"

namespace marketgen {

struct SearchHit {
  std::uint32_t product = 0;  // row of catalog.products
  double score = 0;
};

// Products that match at least one word of `text`, best first. Ranking: every word scores its best
// field (name 4, variant and brand 3, keyword 3, subcategory 2, category 1, description 1; half of
// that when only the beginning matches) and a tenth of what the others score; the sum is multiplied
// by the share of words that matched. Ties are broken by SKU.
std::vector<SearchHit> search_products(const Catalog& catalog, std::string_view text);

}  // namespace marketgen
