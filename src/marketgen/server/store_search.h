// Goods of a store by words, ranked as the catalogue ranks them (catalog/asset_database.h).
#pragma once
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "catalog/asset_database.h"
#include "scene/scene.h"

namespace marketgen::server {

struct SearchHit {
  std::uint32_t sku_row = 0;
  std::string sku, name;
  double score = 0, price = 0;
  std::string currency;
  std::vector<std::uint32_t> products;
  static constexpr auto fields =
      field_list(field("sku_row", &SearchHit::sku_row, "row of the SKU"),
                 field("sku", &SearchHit::sku, "SKU"),
                 field("name", &SearchHit::name, "brand, name and variant"),
                 field("score", &SearchHit::score, "the higher the better"),
                 field("price", &SearchHit::price, "in `currency`"),
                 field("currency", &SearchHit::currency, "ISO 4217"),
                 field("products", &SearchHit::products, "rows of its items, front ones first"));
};

struct SearchAnswer {
  std::string query;
  std::vector<SearchHit> hits;
  static constexpr auto fields = field_list(field("query", &SearchAnswer::query, "what was asked"),
                                            field("hits", &SearchAnswer::hits, "best first"));
};

// Thread-safe.
class StoreSearch {
 public:
  // Errors: those of AssetDatabase::open. `catalog` must outlive it.
  static Result<std::unique_ptr<StoreSearch>> open(const catalog::Catalog& catalog);

  // At most `max_hits` SKUs that stand in the store. Errors: those of AssetDatabase::find.
  Result<SearchAnswer> find(const scene::Scene& scene,
                            const std::string& words,
                            std::size_t max_hits) const;

 private:
  StoreSearch(const catalog::Catalog& catalog, catalog::AssetDatabase database)
      : catalog_(catalog), database_(std::move(database)) {}

  const catalog::Catalog& catalog_;
  mutable std::mutex mutex_;  // the database belongs to one thread at a time
  catalog::AssetDatabase database_;
};

}  // namespace marketgen::server
