#include "catalog/catalog.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/hash.h"
#include "base/text.h"
#include "catalog/user_products.h"
#include "io/file.h"
#include "io/json.h"

namespace marketgen::catalog {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t max_row_bytes = 64U << 20;

template <class Row>
Result<void> read_rows(const fs::path& file, std::vector<Row>& rows) {
  MARKETGEN_TRY(const std::string text, io::read_file(file, max_row_bytes));
  MARKETGEN_TRY(std::vector<Row> read,
                io::read_json<std::vector<Row>>(text, file.filename().string()));
  std::move(read.begin(), read.end(), std::back_inserter(rows));
  return {};
}

Result<void> read_products(const fs::path& folder, std::vector<Product>& rows) {
  std::error_code failed;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failed)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  if (failed)
    return Error{"catalog.missing_data",
                 folder.string(),
                 "the product rows cannot be listed: " + failed.message()};
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files)
    MARKETGEN_CHECK(read_rows(file, rows));
  return {};
}

Result<void> read_lexicon(const fs::path& file, SearchLexicon& lexicon) {
  MARKETGEN_TRY(const std::string text, io::read_file(file, max_row_bytes));
  MARKETGEN_TRY(lexicon, io::read_json<SearchLexicon>(text, file.filename().string()));
  return {};
}

Result<void> add_own_products(const std::vector<fs::path>& files, Catalog& catalog) {
  std::vector<Product> all;
  for (const fs::path& file : files) {
    MARKETGEN_TRY(std::vector<Product> own, read_user_products(file));
    for (Product& product : own) {
      fill_in(product, catalog.products, catalog.frictions);
      catalog.own.push_back(product.sku);
      all.push_back(std::move(product));
    }
  }
  std::ranges::move(all, std::back_inserter(catalog.products));
  return {};
}

template <class Row>
void add_rows(Hasher& hash, const std::vector<Row>& rows) {
  hash.add(static_cast<std::int64_t>(rows.size()));
  for (const Row& row : rows)
    hash.add(io::write_json_line(row));
}

std::string hash_of(const Catalog& c) {
  Hasher hash;
  add_rows(hash, c.products);
  add_rows(hash, c.fixture_kinds);
  add_rows(hash, c.categories);
  add_rows(hash, c.zone_types);
  add_rows(hash, c.materials);
  add_rows(hash, c.profiles);
  add_rows(hash, c.styles);
  add_rows(hash, c.frictions);
  add_rows(hash, c.heaps);
  return hash.hex();
}

void sort_products(Catalog& catalog) {
  std::ranges::stable_sort(catalog.products, {}, &Product::sku);
  std::ranges::sort(catalog.own);
}

template <class Row>
const Row* find_row(const std::vector<Row>& rows, std::string Row::*key, std::string_view wanted) {
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.*key == wanted; });
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace

const Product* Catalog::product(std::string_view sku) const {
  const auto found = std::lower_bound(
      products.begin(), products.end(), sku, [](const Product& p, std::string_view wanted) {
        return p.sku < wanted;
      });
  return found != products.end() && found->sku == sku ? &*found : nullptr;
}
const FixtureKind* Catalog::fixture_kind(std::string_view kind) const {
  return find_row(fixture_kinds, &FixtureKind::kind, kind);
}
const CategoryRow* Catalog::category(std::string_view id) const {
  return find_row(categories, &CategoryRow::id, id);
}
const ZoneTypeRow* Catalog::zone_type(std::string_view type) const {
  return find_row(zone_types, &ZoneTypeRow::type, type);
}
const MaterialRow* Catalog::material(std::string_view id) const {
  return find_row(materials, &MaterialRow::id, id);
}
const ProfileRow* Catalog::profile(std::string_view id) const {
  return find_row(profiles, &ProfileRow::id, id);
}
const StyleRow* Catalog::style(std::string_view id) const {
  return find_row(styles, &StyleRow::id, id);
}

const HeapRow* Catalog::heap(const Product& product) const {
  const auto found = std::find_if(heaps.begin(), heaps.end(), [&](const HeapRow& row) {
    return row.archetype == product.archetype && row.size_mm == product.size_mm;
  });
  return found == heaps.end() ? nullptr : &*found;
}

std::string line_without_contents(Product product) {
  product.contents.reset();
  return io::write_json_line(product);
}

Result<Catalog> load_catalog(const fs::path& data, const std::vector<fs::path>& extra) {
  Catalog catalog;
  MARKETGEN_CHECK(read_products(data / "products", catalog.products));
  MARKETGEN_CHECK(read_rows(data / "fixtures.json", catalog.fixture_kinds));
  MARKETGEN_CHECK(read_rows(data / "categories.json", catalog.categories));
  MARKETGEN_CHECK(read_rows(data / "zone_types.json", catalog.zone_types));
  MARKETGEN_CHECK(read_rows(data / "materials.json", catalog.materials));
  MARKETGEN_CHECK(read_rows(data / "profiles.json", catalog.profiles));
  MARKETGEN_CHECK(read_rows(data / "styles.json", catalog.styles));
  MARKETGEN_CHECK(read_rows(data / "friction.json", catalog.frictions));
  MARKETGEN_CHECK(read_rows(data / "friction_sources.json", catalog.friction_sources));
  MARKETGEN_CHECK(read_rows(data / "heaps.json", catalog.heaps));
  MARKETGEN_CHECK(add_own_products(extra, catalog));
  MARKETGEN_CHECK(read_lexicon(data / "asset_intents.json", catalog.search_lexicon));
  sort_products(catalog);
  MARKETGEN_CHECK(check_catalog(catalog));
  catalog.content_hash = hash_of(catalog);
  return catalog;
}

Catalog with_own_products(Catalog catalog, const std::vector<Product>& own) {
  std::vector<Product> added;
  for (const Product& product : own) {
    if (catalog.product(product.sku) == nullptr) added.push_back(product);
  }
  for (Product& product : added) {
    catalog.own.push_back(product.sku);
    catalog.products.push_back(std::move(product));
  }
  sort_products(catalog);
  catalog.content_hash = hash_of(catalog);
  return catalog;
}

Error unknown_name(std::string code,
                   std::string where,
                   std::string_view what,
                   std::string_view name,
                   const std::vector<std::string_view>& known) {
  const std::string hint = did_you_mean(name, known);
  std::string message = fmt::format("there is no {} \"{}\"", what, name);
  constexpr std::size_t max_listed = 30;
  if (!hint.empty())
    message += hint;
  else if (known.size() <= max_listed)
    message += fmt::format("; known are: {}", fmt::join(known, ", "));
  return {std::move(code), std::move(where), std::move(message)};
}

}  // namespace marketgen::catalog
