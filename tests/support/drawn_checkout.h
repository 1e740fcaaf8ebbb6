// Episodes of Checkout Unloading over the committed catalogue.
#pragma once
#include <algorithm>
#include <array>
#include <filesystem>
#include <vector>

#include "episodes/checkout/sample_checkout.h"
#include "support/committed_catalog.h"

namespace marketgen {

inline std::filesystem::path data_rows() {
  return std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data";
}

// Packs of narrower sides and rounds of two inches and more, which tests have their baskets of:
// some are written for what one of them holds.
inline bool is_of_tests_baskets(const catalog::Product& product) {
  std::array<int, 3> size = product.size_mm;
  std::ranges::sort(size);
  const bool round = product.orientation == catalog::Orientation::any;
  return product.rigidity != catalog::Rigidity::soft && size[1] <= 68 && (!round || size[0] >= 55);
}

inline const std::vector<catalog::Product>& checkout_goods_rows() {
  static const std::vector<catalog::Product> chosen = [] {
    std::vector<catalog::Product> goods;
    for (const catalog::Product& product : committed_catalog().products)
      if (episodes::is_checkout_item(product) && is_of_tests_baskets(product))
        goods.push_back(product);
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
