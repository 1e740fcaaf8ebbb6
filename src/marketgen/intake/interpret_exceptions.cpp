// What there shall be none of, but for some of it.
#include <algorithm>
#include <set>

#include "intake/interpret.h"
#include "intake/place_nouns.h"

namespace marketgen::intake {
namespace {

using language::Meaning;
using language::MeaningPtr;
using Kind = plan::RequirementKind;

bool lists_name(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

// Subcategories of the goods that a zone of the type sells: some of its category, or all.
std::set<std::string> kinds_of_goods(const catalog::Catalog& catalog, const std::string& zone) {
  std::set<std::string> kinds;
  const catalog::ZoneTypeRow* row = catalog.zone_type(zone);
  if (row == nullptr) return kinds;
  kinds.insert(row->subcategories.begin(), row->subcategories.end());
  if (!kinds.empty()) return kinds;
  for (const catalog::Product& product : catalog.products)
    if (lists_name(row->categories, product.category)) kinds.insert(product.subcategory);
  return kinds;
}

// What a word for goods names is a subcategory, or the name of products of one.
bool is_of_kind(const catalog::Catalog& catalog,
                const std::string& goods,
                const std::string& kind) {
  return goods == kind ||
         std::ranges::any_of(catalog.products, [&](const catalog::Product& product) {
           return product.name == goods && product.subcategory == kind;
         });
}

bool stands_elsewhere(const MeaningPtr& banned, const language::Parts& except) {
  return banned->is("type", "fixture") && !except.empty() &&
         !except.front()->is("type", "fixture") && !except.front()->text("zone").empty();
}

}  // namespace

// "No alcohol except wine": wine, and no other goods of that zone. "No pallets except among the
// offers": pallets there.
bool interpret_absent_but(Reading& reading, const Meaning& statement) {
  const language::Parts& except = statement.parts("except");
  bool any = false;
  for (const MeaningPtr& banned : statement.parts("things")) {
    if (stands_elsewhere(banned, except)) {
      mention(reading, standing_in(*banned, except.front()->text("zone")));
      any = true;
      continue;
    }
    for (const std::string& kind : kinds_of_goods(reading.catalog, banned->text("zone"))) {
      const bool excepted = std::ranges::any_of(except, [&](const MeaningPtr& goods) {
        return is_of_kind(reading.catalog, goods->text("name"), kind);
      });
      if (excepted) continue;
      plan::Requirement& none = reading.add(Kind::product_absent, statement.span);
      none.subject = kind;
      none.object = banned->text("zone");
      any = true;
    }
  }
  if (!any) return false;
  for (const MeaningPtr& goods : except)
    mention(reading, *goods);
  remember(reading, except);
  return true;
}

}  // namespace marketgen::intake
