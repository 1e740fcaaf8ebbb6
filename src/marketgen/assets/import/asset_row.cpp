#include "assets/import/asset_row.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "assets/import/asset_estimates.h"
#include "base/text.h"
#include "catalog/gtin.h"
#include "catalog/product_check.h"
#include "catalog/usual_pack.h"
#include "io/field_check.h"

namespace marketgen::assets {
namespace {

std::string slug_of(std::string_view name) {
  std::string slug;
  for (const char c : lower_ascii(name)) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    if (plain)
      slug += c;
    else if (!slug.empty() && slug.back() != '-')
      slug += '-';
  }
  while (slug.ends_with('-'))
    slug.pop_back();
  return slug.empty() ? "model" : slug.substr(0, 80);
}

// A number from GS1's restricted prefix 299 that the file's content decides.
std::string own_ean(const std::string& sha256) {
  constexpr std::uint64_t billion = 1'000'000'000;
  const std::uint64_t number = std::stoull(sha256.substr(0, 15), nullptr, 16) % billion;
  const std::string digits = fmt::format("299{:09}", number);
  for (char check = '0'; check <= '9'; ++check) {
    if (catalog::is_ean13(digits + check)) return digits + check;
  }
  fatal("no digit is a check digit");
}

Result<void> check_category(const std::string& category,
                            const catalog::Catalog& catalog,
                            const std::string& where) {
  if (catalog.category(category) != nullptr) return {};
  std::vector<std::string_view> known;
  for (const catalog::CategoryRow& row : catalog.categories)
    known.push_back(row.id);
  if (category.empty()) {
    return Error{"catalog.unknown_kind",
                 where,
                 fmt::format("its names do not say what it is; give --category, one of: {}",
                             fmt::join(known, ", "))};
  }
  return catalog::unknown_name("catalog.unknown_kind", "--category", "category", category, known);
}

const std::string& chosen(const std::string& given, const std::string& found) {
  return given.empty() ? found : given;
}

}  // namespace

Result<void> check_stated(const StatedRow& stated) {
  if (!stated.mass_kg) return {};
  const auto fault = io::fault_of_field<catalog::Product>("mass_kg", *stated.mass_kg);
  if (!fault) return {};
  return Error{"usage.bad_flag", "--mass-kg", fault->message + " kg"};
}

Result<void> name_row(catalog::AssetFile& asset,
                      const StatedRow& stated,
                      const std::string& like,
                      const catalog::Catalog& catalog,
                      const std::string& where) {
  const catalog::AssetAnnotation& said = asset.annotation;
  catalog::Product& row = asset.product;
  row.name = chosen(stated.name, said.name);
  if (row.name.empty()) row.name = "Imported model";
  row.sku = "own-" + slug_of(row.name) + "-" + asset.source.sha256.substr(0, 8);
  row.ean = own_ean(asset.source.sha256);
  row.category = chosen(stated.category, said.category);
  MARKETGEN_CHECK(check_category(row.category, catalog, where));
  const bool as_said = row.category == said.category;
  row.subcategory = chosen(stated.subcategory, as_said ? said.subcategory : "");
  if (row.subcategory.empty()) row.subcategory = row.category;
  row.keywords = said.keywords;
  row.material = chosen(stated.material, said.material);
  if (row.material.empty()) {
    catalog::Product alike = row;
    alike.archetype = like;
    row.material = catalog::usual_material(catalog.products, alike);
    asset.notes.push_back(
        fmt::format("nothing says what it is made of: {}, as most rows like it", row.material));
  }
  row.rigidity = said.rigidity;
  row.storage = said.storage;
  row.unit_of_measure = "piece";
  if (!asset.look.colors.empty()) row.label.primary = asset.look.colors[0].color;
  asset.notes.emplace_back(
      "price, net quantity and shelf life are placeholders: set them in asset.json");
  return {};
}

void estimate_row(catalog::AssetFile& asset,
                  const StatedRow& stated,
                  double volume_m3,
                  const catalog::Catalog& catalog) {
  catalog::AssetEstimates& estimates = asset.estimates;
  estimates.volume_m3 = volume_m3;
  const Estimate mass = estimated_mass(asset.product, volume_m3, catalog);
  asset.product.mass_kg = stated.mass_kg.value_or(mass.value);
  estimates.mass_from = stated.mass_kg ? "--mass-kg" : mass.from;
  const Estimate friction = estimated_friction(asset.product.material, catalog);
  asset.product.friction = friction.value;
  estimates.friction_from = friction.from;
}

Result<void> check_asset(const catalog::AssetFile& asset, const catalog::Catalog& catalog) {
  MARKETGEN_CHECK(io::check_fields(asset, std::string(asset_file_name)));
  return catalog::check_product(asset.product, catalog);
}

}  // namespace marketgen::assets
