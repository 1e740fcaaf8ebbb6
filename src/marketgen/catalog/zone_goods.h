// What belongs where: which goods a zone sells and which fixtures keep them.
#pragma once
#include <string>
#include <vector>

#include "catalog/catalog.h"

namespace marketgen::catalog {

// True when goods of storage `product` may stand in a fixture of storage `fixture`. A cooler also
// takes ambient goods (drinks); nothing else takes what is not its own.
bool keeps(Storage fixture, Storage product);

// True when the product is of one of `categories` and of one of `subcategories`; an empty list
// allows all.
bool sold_in(const Product& product,
             const std::vector<std::string>& categories,
             const std::vector<std::string>& subcategories);

// What a shop finds when it furnishes a zone of this type. Goods: those that it sells and its
// temperature keeps, where its fixture is shelving or it names categories. Facilities: its own
// fixture, and every shelving of its temperature when it sells goods.
bool belongs_to(const ZoneTypeRow& zone, const Product& product, const Catalog& catalog);
bool belongs_to(const ZoneTypeRow& zone, const FixtureKind& kind, const Catalog& catalog);

}  // namespace marketgen::catalog
