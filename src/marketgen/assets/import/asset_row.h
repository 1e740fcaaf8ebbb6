// The row of an imported asset, as far as it follows from what a person says, what an annotator
// says and what the catalogue knows of its like.
#pragma once
#include <optional>
#include <string>

#include "assets/import/asset_annotator.h"
#include "base/result.h"
#include "catalog/asset_file.h"

namespace marketgen::assets {

// What a person knows better than the annotator: empty or absent means "find out".
struct StatedRow {
  std::string name, category, subcategory, material;
  std::optional<double> mass_kg;
};

// Error usage.bad_flag for a mass that no row may have.
Result<void> check_stated(const StatedRow& stated);

// Fills in name, SKU, EAN, category, subcategory, material and the like of `asset.product` from
// `stated` and `asset.annotation`; SKU and EAN from `asset.source.sha256` too. `like`: the shape of
// ours whose usual material is taken where nobody says one. `where` is the place in errors:
// catalog.unknown_kind for a category that is none, or when nothing says one.
Result<void> name_row(catalog::AssetFile& asset,
                      const StatedRow& stated,
                      const std::string& like,
                      const catalog::Catalog& catalog,
                      const std::string& where);

// Mass and friction of the named row, with where they come from, for a pack of that volume.
void estimate_row(catalog::AssetFile& asset,
                  const StatedRow& stated,
                  double volume_m3,
                  const catalog::Catalog& catalog);

// What is written is what --catalog takes. Errors: json.*, catalog.bad_row.
Result<void> check_asset(const catalog::AssetFile& asset, const catalog::Catalog& catalog);

constexpr std::string_view asset_file_name = "asset.json";

}  // namespace marketgen::assets
