// The catalogue: every row the generator may use, read once, checked, immutable.
//
// Rows are JSON arrays under data/: products/*.json, fixtures.json, categories.json,
// zone_types.json, materials.json, profiles.json, styles.json, friction.json with
// friction_sources.json, heaps.json. A user's file (`--catalog F`) adds products beside ours.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "catalog/fixture_kind.h"
#include "catalog/heap.h"
#include "catalog/product.h"
#include "catalog/rows.h"
#include "catalog/search_lexicon.h"

namespace marketgen::catalog {

struct Catalog {
  std::vector<Product> products;           // sorted by sku
  std::vector<FixtureKind> fixture_kinds;  // file order
  std::vector<CategoryRow> categories;
  std::vector<ZoneTypeRow> zone_types;
  std::vector<MaterialRow> materials;
  std::vector<ProfileRow> profiles;
  std::vector<StyleRow> styles;
  std::vector<FrictionRow> frictions;
  std::vector<FrictionSource> friction_sources;
  std::vector<HeapRow> heaps;
  std::vector<std::string>
      own;  // SKUs of the user's own files, sorted; their rows stand in products
  SearchLexicon search_lexicon;  // how free text is understood; no row
  std::string content_hash;      // of all rows: changes when any row does

  // Each returns null when there is no such row.
  const Product* product(std::string_view sku) const;
  const FixtureKind* fixture_kind(std::string_view kind) const;
  const CategoryRow* category(std::string_view id) const;
  const ZoneTypeRow* zone_type(std::string_view type) const;
  const MaterialRow* material(std::string_view id) const;
  const ProfileRow* profile(std::string_view id) const;
  const StyleRow* style(std::string_view id) const;
  const HeapRow* heap(const Product& product) const;  // of pieces of its shape and size
};

// Reads every row under `data` (usually data_folder()), then `extra` product files. Errors:
// catalog.*, json.*, input.*.
Result<Catalog> load_catalog(const std::filesystem::path& data,
                             const std::vector<std::filesystem::path>& extra = {});

// The row as a line of JSON without what is only seen behind glass: studies of rows and rows that
// travel with episodes are told apart by it.
std::string line_without_contents(Product product);

// The rows' own rules: unique ids, EAN check digits and prefixes, known categories and kinds,
// plausible density. Returns the first fault with the row's place.
Result<void> check_catalog(const Catalog& catalog);

// The error for a name that is in none of `known`: code catalog.unknown_kind or the given one, with
// the nearest name.
Error unknown_name(std::string code,
                   std::string where,
                   std::string_view what,
                   std::string_view name,
                   const std::vector<std::string_view>& known);

}  // namespace marketgen::catalog
