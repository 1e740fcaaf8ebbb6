#include "catalog/zone_goods.h"

#include <algorithm>

namespace marketgen::catalog {
namespace {

bool allows(const std::vector<std::string>& list, const std::string& name) {
  return list.empty() || std::find(list.begin(), list.end(), name) != list.end();
}

bool sells_goods(const ZoneTypeRow& zone, const Catalog& catalog) {
  const FixtureKind* fixture = catalog.fixture_kind(zone.fixture);
  return !zone.categories.empty() || (fixture != nullptr && fixture->role == FixtureRole::shelving);
}

}  // namespace

bool keeps(Storage fixture, Storage product) {
  return product == fixture || (fixture == Storage::chilled && product == Storage::ambient);
}

bool sold_in(const Product& product,
             const std::vector<std::string>& categories,
             const std::vector<std::string>& subcategories) {
  return allows(categories, product.category) && allows(subcategories, product.subcategory);
}

bool belongs_to(const ZoneTypeRow& zone, const Product& product, const Catalog& catalog) {
  return sells_goods(zone, catalog) && keeps(zone.temperature, product.storage) &&
         sold_in(product, zone.categories, zone.subcategories);
}

bool belongs_to(const ZoneTypeRow& zone, const FixtureKind& kind, const Catalog& catalog) {
  if (kind.kind == zone.fixture) return true;
  return kind.role == FixtureRole::shelving && kind.temperature == zone.temperature &&
         sells_goods(zone, catalog);
}

}  // namespace marketgen::catalog
