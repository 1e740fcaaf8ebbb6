#include "server/store_search.h"

#include <algorithm>
#include <utility>

#include "catalog/country.h"
#include "catalog/full_name.h"
#include "scene/query.h"

namespace marketgen::server {
namespace {

constexpr std::size_t max_items = 200;  // of one SKU: what a page can highlight at once

std::vector<std::uint32_t> items_of(const scene::Scene& scene, std::uint32_t sku) {
  std::vector<std::uint32_t> rows;
  for (std::uint32_t row = 0; row < scene.products.size(); ++row) {
    if (scene.products[row].sku == sku) rows.push_back(row);
  }
  std::ranges::stable_partition(rows, [&](std::uint32_t row) {
    return (scene.products[row].flags & scene::product_front_row) != 0;
  });
  if (rows.size() > max_items) rows.resize(max_items);
  return rows;
}

}  // namespace

Result<std::unique_ptr<StoreSearch>> StoreSearch::open(const catalog::Catalog& catalog) {
  MARKETGEN_TRY(catalog::AssetDatabase database, catalog::AssetDatabase::open(catalog));
  return std::unique_ptr<StoreSearch>(new StoreSearch(catalog, std::move(database)));
}

Result<SearchAnswer> StoreSearch::find(const scene::Scene& scene,
                                       const std::string& words,
                                       std::size_t max_hits) const {
  const std::scoped_lock lock(mutex_);
  MARKETGEN_TRY(const std::vector<catalog::AssetHit> found,
                database_.find({.text = words, .kinds = {catalog::AssetKind::goods}}));
  SearchAnswer answer{words, {}};
  for (const catalog::AssetHit& hit : found) {
    if (answer.hits.size() >= max_hits) break;
    const catalog::Product& product = catalog_.products[hit.row];
    const auto row =
        std::ranges::lower_bound(scene.catalog, product.sku, {}, &catalog::Product::sku);
    if (row == scene.catalog.end() || row->sku != product.sku) continue;
    SearchHit line{static_cast<std::uint32_t>(row - scene.catalog.begin()),
                   product.sku,
                   catalog::full_name(product),
                   hit.score,
                   row->price,
                   std::string(catalog::country_of(*row).currency),
                   {}};
    line.products = items_of(scene, line.sku_row);
    if (!line.products.empty()) answer.hits.push_back(std::move(line));
  }
  return answer;
}

}  // namespace marketgen::server
