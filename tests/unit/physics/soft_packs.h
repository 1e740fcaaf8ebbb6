// The soft packs of the committed catalogue.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "physics/soft/soft_pack.h"
#include "support/committed_catalog.h"
#include "support/hand_made_scene.h"

namespace marketgen {

struct SoftRow {
  const catalog::Product* product;
  physics::SoftPack pack;
};

// Made once.
inline const std::vector<SoftRow>& soft_rows() {
  static const std::vector<SoftRow> rows = [] {
    std::vector<SoftRow> made;
    for (const catalog::Product& product : committed_catalog().products) {
      const Result<std::optional<physics::SoftPack>> pack = physics::soft_pack_of(product);
      if (!pack.ok()) fatal(to_string(pack.error()).c_str());
      if (*pack) made.push_back({&product, **pack});
    }
    return made;
  }();
  return rows;
}

inline const SoftRow& soft_row(const std::string& sku) {
  const auto found = std::ranges::find_if(
      soft_rows(), [&](const SoftRow& row) { return row.product->sku == sku; });
  if (found == soft_rows().end()) fatal(("no soft pack " + sku).c_str());
  return *found;
}

}  // namespace marketgen
