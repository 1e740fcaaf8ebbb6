#include "catalog/complete_contents.h"

namespace marketgen::catalog {

void complete_contents(std::vector<Product>& rows, const Catalog& catalog) {
  for (Product& row : rows) {
    if (row.contents) continue;
    if (const Product* now = catalog.product(row.sku)) row.contents = now->contents;
  }
}

}  // namespace marketgen::catalog
