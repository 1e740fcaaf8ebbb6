// The rows under data/, as every user gets them.
#pragma once
#include <filesystem>

#include "catalog/catalog.h"

namespace marketgen {

// Read once.
inline const catalog::Catalog& committed_catalog() {
  static const catalog::Catalog catalog = [] {
    auto loaded = catalog::load_catalog(std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data");
    if (!loaded.ok()) fatal(to_string(loaded.error()).c_str());
    return std::move(loaded).value();
  }();
  return catalog;
}

}  // namespace marketgen
