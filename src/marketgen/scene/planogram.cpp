#include "scene/planogram.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

namespace marketgen::scene {
namespace {

// What a shopper should not have to lift high: mass first, then bulk.
double heaviness(const catalog::Product& product) {
  return product.mass_kg + 4.0 * product.width_m() * product.height_m();
}

// Offers stand in piles that are seen from afar: this high, or this share of the room.
constexpr double pile_m = 0.35, pile_share = 0.45;
// How far the next bay of offers moves on in the assortment, in shares of it: the golden section
// comes to new goods every time.
constexpr double offer_stride = 0.381966;

constexpr int min_heaped = 4;  // pieces across: fewer make a row, not a heap

bool piles_up(const catalog::Product& product, const ShelfRoom& room) {
  return fits(product, room) && stack_height(product, room) * product.height_m() >=
                                    std::min(pile_m, pile_share * room.clearance_m);
}

// One bay while it is being planned. Products are named by their place in the assortment.
class BayPlan {
 public:
  BayPlan(const Bay& bay,
          const std::vector<std::uint32_t>& assortment,
          const plan::StockSpec& stock,
          const catalog::Catalog& catalog,
          Stream draw,
          const std::vector<std::uint32_t>& certain)
      : bay_(bay),
        assortment_(assortment),
        stock_(stock),
        catalog_(catalog),
        draw_(draw),
        certain_(certain),
        piles_only_(bay.promotion && std::ranges::any_of(assortment, [&](std::uint32_t row) {
                      return piles_up_somewhere(catalog.products[row]);
                    })) {
    for (const ShelfRoom& room : bay.shelves)
      free_m_.push_back(room.width_m * stock.fill);
    blocks_.resize(bay.shelves.size());
  }

  std::vector<PlannedShelf> plan(AssortmentCursor& cursor) {
    place_certain();
    place(take_slice(cursor));
    for (std::size_t level = 0; level < bay_.shelves.size(); ++level)
      top_up(level);
    return ordered();
  }

 private:
  struct Block {
    std::size_t place;  // in the assortment
    int facings;
  };

  const catalog::Product& product(std::size_t place) const {
    return catalog_.products[assortment_[place]];
  }

  int wanted_facings() {
    if (bay_.promotion) return max_facings;
    if (bay_.shelves.front().use == assets::ShelfUse::heap)
      return draw_.integer(min_heaped, max_facings);
    return draw_.integer(stock_.facings[0], std::max(stock_.facings[0], stock_.facings[1]));
  }

  bool fits_somewhere(const catalog::Product& p) const {
    return std::any_of(bay_.shelves.begin(), bay_.shelves.end(), [&](const ShelfRoom& room) {
      return fits(p, room);
    });
  }

  bool piles_up_somewhere(const catalog::Product& p) const {
    return std::any_of(bay_.shelves.begin(), bay_.shelves.end(), [&](const ShelfRoom& room) {
      return piles_up(p, room);
    });
  }

  bool suits(const catalog::Product& p, const ShelfRoom& room) const {
    return piles_only_ ? piles_up(p, room) : fits(p, room);
  }

  bool is_certain(std::size_t place) const {
    return std::ranges::find(certain_, assortment_[place]) != certain_.end();
  }

  // One facing each before any of them has more, in their order: what stood here stays.
  void place_certain() {
    for (const std::uint32_t row : certain_) {
      const auto found = std::ranges::find(assortment_, row);
      if (found == assortment_.end()) continue;
      const auto place = static_cast<std::size_t>(found - assortment_.begin());
      const catalog::Product& p = product(place);
      for (std::size_t level = 0; level < free_m_.size(); ++level) {
        if (facing_pitch_m(p) > free_m_[level] || !fits(p, bay_.shelves[level])) continue;
        blocks_[level].push_back({place, 1});
        free_m_[level] -= facing_pitch_m(p);
        break;
      }
    }
    if (certain_.empty()) return;
    const int wanted = wanted_facings();
    for (std::size_t level = 0; level < free_m_.size(); ++level) {
      while (widen(level, wanted)) {
      }
    }
  }

  // The next products of the assortment, until their blocks fill the bay.
  std::vector<Block> take_slice(AssortmentCursor& cursor) {
    double capacity = 0;
    for (const double width : free_m_)
      capacity += width;
    std::vector<Block> slice;
    double taken = 0;
    std::size_t looked = 0;
    for (; looked < assortment_.size() && taken < capacity; ++looked) {
      const std::size_t place = (cursor.next + looked) % assortment_.size();
      if (!fits_somewhere(product(place)) || is_certain(place)) continue;
      if (piles_only_ && !piles_up_somewhere(product(place))) continue;
      slice.push_back({place, wanted_facings()});
      taken += slice.back().facings * facing_pitch_m(product(place));
    }
    if (bay_.promotion)
      looked += static_cast<std::size_t>(offer_stride * static_cast<double>(assortment_.size()));
    cursor.next = (cursor.next + looked) % assortment_.size();
    return slice;
  }

  // Heaviest first, each on the lowest level that still has room; a block too wide for any level is
  // narrowed.
  void place(std::vector<Block> slice) {
    std::stable_sort(slice.begin(), slice.end(), [&](const Block& a, const Block& b) {
      return heaviness(product(a.place)) > heaviness(product(b.place));
    });
    for (Block block : slice) {
      while (block.facings > 0 && !put_lowest(block))
        --block.facings;
    }
  }

  bool put_lowest(const Block& block) {
    const catalog::Product& p = product(block.place);
    for (std::size_t level = 0; level < free_m_.size(); ++level) {
      const double width = block.facings * facing_pitch_m(p);
      if (width > free_m_[level] || !suits(p, bay_.shelves[level])) continue;
      blocks_[level].push_back(block);
      free_m_[level] -= width;
      return true;
    }
    return false;
  }

  // Uses what is left of a level: more facings of the narrowest blocks first, then other products
  // that fit, then blocks of the same products again.
  void top_up(std::size_t level) {
    while (widen(level, std::max(stock_.facings[1], 2))) {
    }
    while (add_other(level)) {
    }
    while (widen(level, max_facings)) {
    }
    while (add_again(level)) {
    }
  }

  bool widen(std::size_t level, int limit) {
    Block* best = nullptr;
    for (Block& block : blocks_[level]) {
      if (block.facings >= limit || facing_pitch_m(product(block.place)) > free_m_[level]) continue;
      if (best == nullptr || block.facings < best->facings) best = &block;
    }
    if (best == nullptr) return false;
    ++best->facings;
    free_m_[level] -= facing_pitch_m(product(best->place));
    return true;
  }

  bool stands_on(std::size_t level, std::size_t place) const {
    return std::any_of(blocks_[level].begin(), blocks_[level].end(), [&](const Block& b) {
      return b.place == place;
    });
  }

  bool add_other(std::size_t level) {
    if (assortment_.empty() || (bay_.promotion && !blocks_[level].empty())) return false;
    const auto start =
        static_cast<std::size_t>(draw_.integer(0, static_cast<int>(assortment_.size()) - 1));
    for (std::size_t i = 0; i < assortment_.size(); ++i) {
      const std::size_t place = (start + i) % assortment_.size();
      const catalog::Product& p = product(place);
      if (facing_pitch_m(p) > free_m_[level] || !suits(p, bay_.shelves[level]) ||
          stands_on(level, place))
        continue;
      const int room = static_cast<int>(free_m_[level] / facing_pitch_m(p));
      const Block block{place, std::clamp(wanted_facings(), 1, room)};
      blocks_[level].push_back(block);
      free_m_[level] -= block.facings * facing_pitch_m(p);
      return true;
    }
    return false;
  }

  bool add_again(std::size_t level) {
    const std::size_t before = blocks_[level].size();
    for (std::size_t i = 0; i < before; ++i) {
      const Block again{
          blocks_[level][i].place,
          std::min(
              max_facings,
              static_cast<int>(free_m_[level] / facing_pitch_m(product(blocks_[level][i].place))))};
      if (again.facings < 1) continue;
      blocks_[level].push_back(again);
      free_m_[level] -= again.facings * facing_pitch_m(product(again.place));
      return true;
    }
    return false;
  }

  std::vector<PlannedShelf> ordered() {
    std::vector<PlannedShelf> shelves;
    for (std::vector<Block>& level : blocks_) {
      std::stable_sort(level.begin(), level.end(), [](const Block& a, const Block& b) {
        return a.place < b.place;
      });
      PlannedShelf shelf;
      for (const Block& block : level)
        shelf.push_back({assortment_[block.place], block.facings, is_certain(block.place)});
      shelves.push_back(std::move(shelf));
    }
    return shelves;
  }

  const Bay& bay_;
  const std::vector<std::uint32_t>& assortment_;
  const plan::StockSpec& stock_;
  const catalog::Catalog& catalog_;
  Stream draw_;
  const std::vector<std::uint32_t>& certain_;
  bool piles_only_ = false;                 // offers, and some of the assortment piles up
  std::vector<double> free_m_;              // per level
  std::vector<std::vector<Block>> blocks_;  // per level
};

}  // namespace

double facing_pitch_m(const catalog::Product& product) {
  return product.width_m() + pack_gap_m;
}

double highest_rest_m(double mass_kg) {
  if (mass_kg > heavy_lift_kg) return heavy_board_m;
  return mass_kg >= stretch_kg ? stretch_m : std::numeric_limits<double>::infinity();
}

bool fits(const catalog::Product& product, const ShelfRoom& room) {
  return stack_height(product, room) > 0 && product.depth_m() <= room.depth_m &&
         facing_pitch_m(product) <= room.width_m;
}

std::string too_large_for(const catalog::Product& product,
                          const std::vector<ShelfRoom>& rooms,
                          std::string_view takes) {
  double height_m = 0, depth_m = 0, width_m = 0;
  for (const ShelfRoom& room : rooms) {
    height_m = std::max(height_m, room.clearance_m - finger_room_m);
    depth_m = std::max(depth_m, room.depth_m);
    width_m = std::max(width_m, room.width_m - pack_gap_m);
  }
  const auto too = [takes](std::string_view what, double has_m, double max_m) {
    return fmt::format("it is {:.0f} mm {}; {} {:.0f} mm", has_m * 1e3, what, takes, max_m * 1e3);
  };
  if (product.height_m() > height_m) return too("tall", product.height_m(), height_m);
  if (product.depth_m() > depth_m) return too("deep", product.depth_m(), depth_m);
  if (product.width_m() > width_m) return too("wide", product.width_m(), width_m);
  return {};
}

int stack_height(const catalog::Product& product, const ShelfRoom& room) {
  const double usable = room.clearance_m - finger_room_m;
  const double below = highest_rest_m(product.mass_kg) - room.board_m;
  if (product.height_m() > usable || below <= 0) return 0;
  const double resting = std::ceil(below / product.height_m());  // packs that rest below it
  return static_cast<int>(
      std::min({static_cast<double>(product.stack_max), usable / product.height_m(), resting}));
}

std::vector<PlannedShelf> plan_bay(const Bay& bay,
                                   const std::vector<std::uint32_t>& assortment,
                                   const plan::StockSpec& stock,
                                   const catalog::Catalog& catalog,
                                   AssortmentCursor& cursor,
                                   Stream draw,
                                   const std::vector<std::uint32_t>& certain) {
  if (assortment.empty()) return std::vector<PlannedShelf>(bay.shelves.size());
  return BayPlan(bay, assortment, stock, catalog, draw, certain).plan(cursor);
}

}  // namespace marketgen::scene
