// Which of a store's draws follow a seed of their own: the same shop with other goods, the same
// goods as other shoppers leave them. Axes are independent: one that is named changes nothing that
// another one draws, and one that is not named follows the store's seed.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "base/seed.h"

namespace marketgen::plan {

// layout: where zones lie, and how they are furnished. planogram: which goods stand where, in how
// many facings. fill: what was taken off the shelves, and how the rest stands. disorder: which
// goods stand where others belong. prices: which price tags are offers, and which are wrong.
struct Vary {
  std::optional<std::uint64_t> layout, planogram, fill, disorder, prices;

  static constexpr auto fields = field_list(
      field("layout", &Vary::layout, "seed of zones' places, runs and what stands at the doors"),
      field("planogram", &Vary::planogram, "seed of which goods stand where, in how many facings"),
      field("fill", &Vary::fill, "seed of what was taken off shelves, and how the rest stands"),
      field("disorder", &Vary::disorder, "seed of which goods stand where others belong"),
      field("prices", &Vary::prices, "seed of offers, and of wrong and missing price tags"));
};

// The axes' names, in that order.
std::vector<std::string_view> vary_axes();

// Adds "fill=3". Error `code` at `where`: no such axis, no seed, or one that is given twice.
Result<void> add_vary(Vary& vary,
                      std::string_view text,
                      std::string code,
                      const std::string& where);

// `vary` with the axes of `over` in the place of its own.
Vary with_vary(Vary vary, const Vary& over);

// The seed of one axis: `own`, which is the store's, or that which the axis has for itself. What is
// drawn for an axis with seed N is what a store with seed N draws there.
Seed axis_seed(const std::optional<Vary>& vary,
               std::optional<std::uint64_t> Vary::*axis,
               Seed own,
               std::string_view stream);

}  // namespace marketgen::plan
