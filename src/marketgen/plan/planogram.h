// What single shelves of a plan hold, block by block, instead of what their zone would put there.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"

namespace marketgen::plan {

enum class ShelfSide { front, back };
constexpr std::array<std::string_view, 2> names_of(ShelfSide) {
  return {"front", "back"};
}

// A block of one product on a shelf that is stocked by a planogram.
struct ShelfBlock {
  std::string sku;
  int facings = 1;
  std::optional<int> x_mm, facings_high, facings_deep;

  static constexpr auto fields = field_list(
      field("sku", &ShelfBlock::sku, "product", required(), reference()),
      field("facings", &ShelfBlock::facings, "packs side by side", range(1, 200), required()),
      field("x_mm",
            &ShelfBlock::x_mm,
            "its left edge from the left of its bay; left out: beside the block before it",
            range(-500, 10000)),
      field("facings_high",
            &ShelfBlock::facings_high,
            "packs on one another; left out: as many as fit",
            range(1, 100)),
      field("facings_deep",
            &ShelfBlock::facings_deep,
            "packs one behind another; left out: as many as the zone's stock says",
            range(1, 200)));
};

// What one shelf holds instead of what its zone would put there.
struct StockedShelf {
  std::string fixture;
  ShelfSide side = ShelfSide::front;
  int shelf = 1;
  std::vector<ShelfBlock> blocks;

  static constexpr auto fields = field_list(
      field("fixture", &StockedShelf::fixture, "fixture id in the layout", required(), reference()),
      field("side", &StockedShelf::side, "of the fixture"),
      field("shelf", &StockedShelf::shelf, "from the floor up", range(1, 100), required()),
      field("blocks",
            &StockedShelf::blocks,
            "from left to right; none: the shelf stays empty",
            required(),
            at_most_items(200)));
};

constexpr std::size_t max_planogram_shelves = 20'000;

}  // namespace marketgen::plan
