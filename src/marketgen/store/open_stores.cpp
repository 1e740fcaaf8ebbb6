#include "store/open_stores.h"

#include <algorithm>

#include "catalog/user_products.h"

namespace marketgen::store {

Result<void> add_distinct(std::vector<std::shared_ptr<const Store>>& stores,
                          std::shared_ptr<const Store> store,
                          const std::string& named) {
  const auto same = [&](const std::shared_ptr<const Store>& other) {
    return other->manifest.scene_hash == store->manifest.scene_hash;
  };
  if (std::ranges::any_of(stores, same))
    return Error{"usage.bad_flag", named, "is the same store as another one: name each once"};
  stores.push_back(std::move(store));
  return {};
}

Result<OpenedStores> open_stores(const std::vector<std::string>& folders, catalog::Catalog rows) {
  std::vector<std::shared_ptr<const Store>> stores;
  for (const std::string& folder : folders) {
    MARKETGEN_TRY(Store store, open_store(folder, rows));
    MARKETGEN_CHECK(add_distinct(stores, std::make_shared<const Store>(std::move(store)), folder));
  }
  return opened_stores(std::move(stores), std::move(rows));
}

OpenedStores opened_stores(std::vector<std::shared_ptr<const Store>> stores,
                           catalog::Catalog rows) {
  OpenedStores opened{std::move(stores), rows, std::move(rows)};
  for (const auto& store : opened.stores)
    if (store->manifest.own)
      opened.catalog = catalog::with_own_products(std::move(opened.catalog), *store->manifest.own);
  return opened;
}

}  // namespace marketgen::store
