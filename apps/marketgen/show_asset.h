// `marketgen assets show`: one row of the library with what follows from it, and its pictures.
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "catalog/catalog.h"

namespace marketgen::app {

struct ShownAsset {
  std::string id;                   // SKU, fixture kind or material id
  std::string picture, label;       // PNG or JPEG files; empty: none
  std::vector<std::string> joints;  // of a fixture: "door-1=open"
  int size_px = 400;
};

// Prints JSON. Errors: catalog.unknown_sku with the nearest name; usage.bad_flag for a flag that
// the asset has no use for; assets.*, io.*.
Result<void> show_asset(const catalog::Catalog& catalog, const ShownAsset& asset);

}  // namespace marketgen::app
