// Several stores that one command is about.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "store/store.h"

namespace marketgen::store {

struct OpenedStores {
  std::vector<std::shared_ptr<const Store>> stores;
  catalog::Catalog catalog;  // with the rows of the stores' own goods
  catalog::Catalog rows;     // without
};

// `rows` is what they are made of. Errors: usage.bad_flag when two folders are the same store;
// those of open_store.
Result<OpenedStores> open_stores(const std::vector<std::string>& folders, catalog::Catalog rows);

// Adds it. Error usage.bad_flag at `named` when one of `stores` is the same.
Result<void> add_distinct(std::vector<std::shared_ptr<const Store>>& stores,
                          std::shared_ptr<const Store> store,
                          const std::string& named);

// Of stores that were opened with `rows`.
OpenedStores opened_stores(std::vector<std::shared_ptr<const Store>> stores, catalog::Catalog rows);

}  // namespace marketgen::store
