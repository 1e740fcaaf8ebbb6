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

inline const std::vector<catalog::Product>& checkout_goods_rows() {
  static const std::vector<catalog::Product> chosen = [] {
    std::vector<catalog::Product> goods;
    for (const catalog::Product& product : committed_catalog().products)
      if (episodes::is_checkout_item(product)) goods.push_back(product);
    return goods;
  }();
  return chosen;
}

// The episodes of two small stores that come with the program.
inline episodes::EpisodeFile pool_file() {
  auto read = episodes::read_episode_file(data_rows() / "benchmark" / "pool" / "checkout.jsonl");
  if (!read.ok()) fatal(to_string(read.error()).c_str());
  return std::move(read).value();
}

inline episodes::EpisodeSpec drawn_by(const episodes::DrawRules& rules,
                                      std::uint64_t seed,
                                      int index) {
  auto spec = episodes::sample_checkout(data_rows(),
                                        checkout_goods_rows(),
                                        committed_catalog().frictions,
                                        {"corner", "s", "p"},
                                        Seed(seed),
                                        index,
                                        {},
                                        {},
                                        rules);
  if (!spec.ok()) fatal(to_string(spec.error()).c_str());
  return std::move(spec).value();
}

inline episodes::EpisodeSpec drawn(std::uint64_t seed, int index) {
  return drawn_by({}, seed, index);
}

}  // namespace marketgen
