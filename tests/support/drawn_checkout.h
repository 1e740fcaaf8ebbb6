// Episodes of Checkout Unloading over the committed catalogue.
#pragma once
#include <filesystem>
#include <vector>

#include "episodes/checkout/sample_checkout.h"
#include "support/committed_catalog.h"

namespace marketgen {

inline std::filesystem::path data_rows() {
  return std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data";
}

inline const std::vector<Product>& checkout_goods_rows() {
  static const std::vector<Product> chosen = [] {
    std::vector<Product> goods;
    for (const Product& product : committed_catalog().products)
      if (is_checkout_item(product)) goods.push_back(product);
    return goods;
  }();
  return chosen;
}

// The episodes of two small stores that come with the program.
inline EpisodeFile pool_file() {
  auto read = read_episode_file(data_rows() / "benchmark" / "pool" / "checkout.jsonl");
  if (!read.ok()) fatal(to_string(read.error()).c_str());
  return std::move(read).value();
}

inline EpisodeSpec drawn(std::uint64_t seed, int index) {
  auto spec = sample_checkout(data_rows(),
                              checkout_goods_rows(),
                              committed_catalog().frictions,
                              {"corner", "s", "p"},
                              Seed(seed),
                              index);
  if (!spec.ok()) fatal(to_string(spec.error()).c_str());
  return std::move(spec).value();
}

}  // namespace marketgen
