#include "scene/brand_blocks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "scene/demand.h"
#include "scene/shelf_fill.h"
#include "scene/shelf_worth.h"

namespace marketgen::scene {
namespace {

bool orders_brands_by_demand(const plan::StockSpec& stock) {
  return stock.block == plan::BlockPattern::brand_columns ||
         stock.block == plan::BlockPattern::brand_horizontal;
}

// A brand's column is no narrower: two facings of a bottle. Brands with less share one.
constexpr double min_column_m = 0.22;
// From here on goods go low, whatever they are asked for.
constexpr double bulky_kg = 1.5, bulky_m3 = 0.004;
constexpr double half_pack_m = 0.12;  // what is looked at is above the board

bool is_bulky(const catalog::Product& product) {
  return product.mass_kg >= bulky_kg ||
         product.width_m() * product.depth_m() * product.height_m() >= bulky_m3;
}

using BrandOfShelf = std::tuple<std::string_view, std::string_view, std::string_view>;

BrandOfShelf brand_of(const catalog::Product& product) {
  return {product.category, product.subcategory, product.brand};
}

// Goods of one column: a brand, or several small ones.
struct Piece {
  std::size_t place = 0;  // in the assortment
  int facings = 1;
};

struct Column {
  std::vector<Piece> pieces;
  double front_m = 0;  // of its facings, all boards together
  double widest_m = 0;
  double x_m = 0, width_m = 0;
};

class BlockedBay {
 public:
  BlockedBay(const Bay& bay,
             const std::vector<std::uint32_t>& assortment,
             const plan::StockSpec& stock,
             const catalog::Catalog& catalog,
             const std::vector<std::uint32_t>& certain)
      : bay_(bay),
        assortment_(assortment),
        stock_(stock),
        catalog_(catalog),
        certain_(certain),
        own_brand_(own_brand_of(catalog)),
        width_m_(std::ranges::min_element(bay.shelves, {}, &ShelfRoom::width_m)->width_m),
        by_eye_(bay.shelves.size()),
        shelves_(bay.shelves.size()) {
    std::iota(by_eye_.begin(), by_eye_.end(), std::size_t{0});
    std::ranges::stable_sort(
        by_eye_, {}, [&](std::size_t level) { return from_eye_level_m(level); });
  }

  std::vector<PlannedShelf> plan(AssortmentCursor& cursor) {
    std::vector<Column> columns = columns_of(take_slice(cursor));
    share_width(columns);
    for (const Column& column : columns)
      fill(column);
    return std::move(shelves_);
  }

 private:
  using Levels = std::vector<std::vector<Piece>>;  // of one column, per board

  const catalog::Product& product(std::size_t place) const {
    return catalog_.products[assortment_[place]];
  }
  double pitch_m(const Piece& piece) const { return facing_pitch_m(product(piece.place)); }
  double from_eye_level_m(std::size_t level) const {
    return std::abs(bay_.shelves[level].board_m + half_pack_m - eye_level_m);
  }
  bool is_certain(std::size_t place) const {
    return std::ranges::find(certain_, assortment_[place]) != certain_.end();
  }

  // From the fewest of the zone, for what is hardly asked for, to the most, for the first eighth;
  // in columns of brands as many as take what the shelf should have room for, if these are more.
  int wanted_facings(const catalog::Product& product) const {
    const double share = std::clamp(demand_of(product) - 0.3, 0.0, 1.0);
    const int most = std::min(max_facings, std::max(stock_.facings[0], stock_.facings[1]));
    const int fewest = std::min(stock_.facings[0], most);
    const int asked = fewest + static_cast<int>(std::lround(share * (most - fewest)));
    const auto board = std::ranges::find_if(
        by_eye_, [&](std::size_t level) { return fits(product, bay_.shelves[level]); });
    const bool upright = stock_.block == plan::BlockPattern::brand_columns;
    if (!upright || board == by_eye_.end()) return asked;
    const ShelfRoom& room = bay_.shelves[*board];
    const int deep = rows_that_fit(product, room, stock_.depth_fill) * stack_height(product, room);
    const double usual_packs = 0.5 * (fewest + most) * deep;
    const int needed = (min_packs(product, usual_packs) + deep - 1) / deep;
    return std::clamp(needed, asked, max_facings);
  }

  bool fits_somewhere(const catalog::Product& product) const {
    return std::ranges::any_of(bay_.shelves,
                               [&](const ShelfRoom& room) { return fits(product, room); });
  }

  // What must stand here, and the next of the assortment, until their facings fill the boards.
  std::vector<Piece> take_slice(AssortmentCursor& cursor) const {
    std::vector<Piece> slice;
    double taken_m = 0;
    const double room_m = width_m_ * stock_.fill * static_cast<double>(bay_.shelves.size());
    const auto take = [&](std::size_t place) {
      slice.push_back({place, wanted_facings(product(place))});
      taken_m += slice.back().facings * pitch_m(slice.back());
    };
    for (std::size_t place = 0; place < assortment_.size(); ++place)
      if (is_certain(place) && fits_somewhere(product(place))) take(place);
    std::size_t looked = 0;
    for (; looked < assortment_.size() && taken_m < room_m; ++looked) {
      const std::size_t place = (cursor.next + looked) % assortment_.size();
      if (fits_somewhere(product(place)) && !is_certain(place)) take(place);
    }
    std::ranges::sort(slice, {}, [&](const Piece& piece) {  // brands together
      return (piece.place + assortment_.size() - cursor.next) % assortment_.size();
    });
    cursor.next = (cursor.next + looked) % assortment_.size();
    return slice;
  }

  // Neighbours of one brand together; what would make too narrow a column goes into the next.
  std::vector<Column> columns_of(const std::vector<Piece>& slice) const {
    const double min_front_m = min_column_m * static_cast<double>(bay_.shelves.size());
    const bool upright = stock_.block == plan::BlockPattern::brand_columns;
    std::vector<Column> columns;
    for (std::size_t i = 0; i < slice.size(); ++i) {
      const bool new_brand =
          i == 0 || brand_of(product(slice[i].place)) != brand_of(product(slice[i - 1].place));
      if (columns.empty() || (upright && new_brand && columns.back().front_m >= min_front_m))
        columns.emplace_back();
      Column& column = columns.back();
      column.pieces.push_back(slice[i]);
      column.front_m += slice[i].facings * pitch_m(slice[i]);
      column.widest_m = std::max(column.widest_m, pitch_m(slice[i]));
    }
    while (columns.size() > 1 && !has_room(columns))
      join_narrowest(columns);
    return columns;
  }

  double width_of(const Column& column, const std::vector<Column>& all) const {
    double front_m = 0;
    for (const Column& other : all)
      front_m += other.front_m;
    return width_m_ * column.front_m / front_m;
  }

  // Each column takes its widest pack, and none is too narrow.
  bool has_room(const std::vector<Column>& columns) const {
    return std::ranges::all_of(columns, [&](const Column& column) {
      const double width_m = width_of(column, columns);
      return width_m * stock_.fill >= column.widest_m &&
             width_m >= std::min(min_column_m, width_m_);
    });
  }

  // That with the least front, with the lesser of its neighbours.
  static void join_narrowest(std::vector<Column>& columns) {
    const auto least = std::ranges::min_element(columns, {}, &Column::front_m);
    auto left = least;
    const bool is_last = least + 1 == columns.end();
    if (is_last || (least != columns.begin() && (least - 1)->front_m < (least + 1)->front_m))
      left = least - 1;
    const auto right = left + 1;
    left->pieces.insert(left->pieces.end(), right->pieces.begin(), right->pieces.end());
    left->front_m += right->front_m;
    left->widest_m = std::max(left->widest_m, right->widest_m);
    columns.erase(right);
  }

  void share_width(std::vector<Column>& columns) const {
    double x_m = 0;
    for (Column& column : columns) {
      column.x_m = x_m;
      column.width_m = width_of(column, columns);
      x_m += column.width_m;
    }
  }

  // ---- A column. ----

  void fill(const Column& column) {
    Levels levels(bay_.shelves.size());
    free_m_.assign(bay_.shelves.size(), column.width_m * stock_.fill);
    for (const Piece& piece : in_turn(column))
      put(levels, piece);
    for (const std::size_t level : by_eye_)
      top_up(levels, level, column);
    for (std::size_t level = 0; level < levels.size(); ++level)
      lay_out(levels[level], level, column);
  }

  // Who chooses a board first. In boards of brands: brand after brand, heavy ones first.
  std::vector<Piece> in_turn(const Column& column) const {
    std::vector<Piece> pieces = column.pieces;
    std::ranges::stable_sort(pieces, {}, [&](const Piece& piece) {
      const catalog::Product& p = product(piece.place);
      const bool bulky = is_bulky(p);
      const double worth = bulky ? p.mass_kg : earnings_of(p, own_brand_);
      return std::tuple(!is_certain(piece.place), !bulky, -worth);
    });
    if (stock_.block == plan::BlockPattern::brand_columns) return pieces;
    std::map<BrandOfShelf, double> mass;
    std::map<BrandOfShelf, int> count;
    for (const Piece& piece : pieces) {
      mass[brand_of(product(piece.place))] += product(piece.place).mass_kg;
      ++count[brand_of(product(piece.place))];
    }
    std::ranges::stable_sort(pieces, {}, [&](const Piece& piece) {
      const BrandOfShelf brand = brand_of(product(piece.place));
      return std::pair(-mass[brand] / count[brand], brand);
    });
    return pieces;
  }

  // Boards in the order in which the piece would have them.
  std::vector<std::size_t> boards_for(const Piece& piece) const {
    std::vector<std::size_t> boards = by_eye_;
    if (stock_.block == plan::BlockPattern::brand_horizontal || is_bulky(product(piece.place)))
      std::ranges::sort(boards);
    return boards;
  }

  // As many facings as wanted on the board that it likes best, or fewer on any.
  void put(Levels& levels, Piece piece) {
    for (; piece.facings > 0; --piece.facings) {
      for (const std::size_t level : boards_for(piece)) {
        if (piece.facings * pitch_m(piece) > free_m_[level] ||
            !fits(product(piece.place), bay_.shelves[level]))
          continue;
        levels[level].push_back(piece);
        free_m_[level] -= piece.facings * pitch_m(piece);
        return;
      }
    }
  }

  // What is left of the board goes to what is asked for most beside its facings, then to goods of
  // the column that stand on other boards.
  void top_up(Levels& levels, std::size_t level, const Column& column) {
    std::vector<Piece>& board = levels[level];
    while (widen(board, level, std::max(stock_.facings[1], 2))) {
    }
    while (repeat(board, level, column)) {
    }
    while (widen(board, level, max_facings)) {
    }
  }

  bool widen(std::vector<Piece>& board, std::size_t level, int limit) {
    Piece* best = nullptr;
    double most = 0;
    for (Piece& piece : board) {
      if (piece.facings >= limit || pitch_m(piece) > free_m_[level]) continue;
      const double asked = demand_of(product(piece.place)) / piece.facings;
      if (asked > most) std::tie(best, most) = std::pair(&piece, asked);
    }
    if (best == nullptr) return false;
    ++best->facings;
    free_m_[level] -= pitch_m(*best);
    return true;
  }

  bool repeat(std::vector<Piece>& board, std::size_t level, const Column& column) {
    const bool high = bay_.shelves[level].board_m + half_pack_m > eye_level_m;
    const Piece* best = nullptr;
    double most = 0;
    for (const Piece& piece : column.pieces) {
      const catalog::Product& p = product(piece.place);
      if (high && is_bulky(p)) continue;
      if (std::ranges::find(board, piece.place, &Piece::place) != board.end() ||
          pitch_m(piece) > free_m_[level] || !fits(p, bay_.shelves[level]))
        continue;
      if (demand_of(p) > most) std::tie(best, most) = std::pair(&piece, demand_of(p));
    }
    if (best == nullptr) return false;
    const int room = static_cast<int>(free_m_[level] / pitch_m(*best));
    board.push_back({best->place, std::clamp(best->facings, 1, room)});
    free_m_[level] -= board.back().facings * pitch_m(*best);
    return true;
  }

  // In the assortment's order (brand, family, small to large), the free room spread between them.
  void lay_out(std::vector<Piece>& board, std::size_t level, const Column& column) {
    std::ranges::stable_sort(board, {}, &Piece::place);
    double used_m = 0;
    std::vector<PlannedBlock> blocks;
    for (const Piece& piece : board) {
      blocks.push_back({assortment_[piece.place], piece.facings, is_certain(piece.place)});
      used_m += block_width_m(blocks.back(), catalog_);
    }
    const double gap_m = (column.width_m - used_m) / static_cast<double>(board.size() + 1);
    double x_m = column.x_m + gap_m;
    for (PlannedBlock& block : blocks) {
      block.x_m = x_m;
      x_m += block_width_m(block, catalog_) + gap_m;
      shelves_[level].push_back(block);
    }
  }

  const Bay& bay_;
  const std::vector<std::uint32_t>& assortment_;
  const plan::StockSpec& stock_;
  const catalog::Catalog& catalog_;
  const std::vector<std::uint32_t>& certain_;
  std::string_view own_brand_;
  double width_m_;                   // of the narrowest board
  std::vector<std::size_t> by_eye_;  // boards, the nearest to eye level first
  std::vector<double> free_m_;       // of the column that is being filled, per board
  std::vector<PlannedShelf> shelves_;
};

// ---- The order of an assortment. ----

// Of each row its category and subcategory, numbered as the assortment comes to them.
std::vector<std::size_t> shelf_groups_of(const std::vector<std::uint32_t>& assortment,
                                         const catalog::Catalog& catalog) {
  std::map<std::pair<std::string_view, std::string_view>, std::size_t> known;
  std::vector<std::size_t> groups;
  for (const std::uint32_t row : assortment) {
    const catalog::Product& product = catalog.products[row];
    groups.push_back(
        known.try_emplace({product.category, product.subcategory}, known.size()).first->second);
  }
  return groups;
}

// Which brand comes when within its subcategory.
class BrandTurns {
 public:
  BrandTurns(const std::vector<std::uint32_t>& assortment, const catalog::Catalog& catalog)
      : own_(own_brand_of(catalog)) {
    for (const std::uint32_t row : assortment)
      demand_[brand_of(catalog.products[row])] += demand_of(catalog.products[row]);
    for (const auto& [brand, demand] : demand_) {
      const auto& [category, subcategory, name] = brand;
      double& most = leader_demand_[{category, subcategory}];
      if (name != own_) most = std::max(most, demand);
    }
  }

  double demand_of_brand(const catalog::Product& product) const {
    return demand_.at(brand_of(product));
  }

  // The leader, the shop's own brand, all others.
  int of(const catalog::Product& product) const {
    if (product.brand == own_) return 1;
    return demand_of_brand(product) >= leader_demand_.at({product.category, product.subcategory})
               ? 0
               : 2;
  }

 private:
  std::string_view own_;
  std::map<BrandOfShelf, double> demand_;
  std::map<std::pair<std::string_view, std::string_view>, double> leader_demand_;
};

}  // namespace

bool has_brand_blocks(const Bay& bay, const plan::StockSpec& stock) {
  return orders_brands_by_demand(stock) && !bay.promotion &&
         std::ranges::all_of(bay.shelves, [](const ShelfRoom& room) {
           return room.use == assets::ShelfUse::stand;
         });
}

void order_by_demand(std::vector<std::uint32_t>& assortment,
                     const plan::StockSpec& stock,
                     const catalog::Catalog& catalog) {
  if (stock.block == plan::BlockPattern::brand_vertical) return;
  const std::vector<std::size_t> groups = shelf_groups_of(assortment, catalog);
  using Turn = std::tuple<std::size_t, int, double, std::string_view>;
  std::vector<std::pair<Turn, std::uint32_t>> keyed;
  const auto order_by = [&](auto turn_of) {
    for (std::size_t i = 0; i < assortment.size(); ++i)
      keyed.emplace_back(turn_of(groups[i], catalog.products[assortment[i]]), assortment[i]);
  };
  if (orders_brands_by_demand(stock)) {
    const BrandTurns turns(assortment, catalog);
    order_by([&](std::size_t group, const catalog::Product& product) {
      return Turn(group, turns.of(product), -turns.demand_of_brand(product), product.brand);
    });
  } else {
    order_by([](std::size_t group, const catalog::Product& product) {
      return Turn(group, 0, -demand_of(product), "");
    });
  }
  std::ranges::stable_sort(keyed, {}, [](const auto& row) { return row.first; });
  std::ranges::transform(keyed, assortment.begin(), [](const auto& row) { return row.second; });
}

std::vector<PlannedShelf> plan_brand_blocks(const Bay& bay,
                                            const std::vector<std::uint32_t>& assortment,
                                            const plan::StockSpec& stock,
                                            const catalog::Catalog& catalog,
                                            AssortmentCursor& cursor,
                                            Stream draw,
                                            const std::vector<std::uint32_t>& certain) {
  if (assortment.empty()) return std::vector<PlannedShelf>(bay.shelves.size());
  AssortmentCursor moved = cursor;
  std::vector<PlannedShelf> shelves =
      BlockedBay(bay, assortment, stock, catalog, certain).plan(moved);
  std::set<std::uint32_t> stand;
  for (const PlannedShelf& shelf : shelves)
    for (const PlannedBlock& block : shelf)
      stand.insert(block.product);
  const bool all =
      std::ranges::all_of(certain, [&](std::uint32_t row) { return stand.contains(row); });
  if (!all) return plan_bay(bay, assortment, stock, catalog, cursor, draw, certain);
  cursor = moved;
  return shelves;
}

}  // namespace marketgen::scene
