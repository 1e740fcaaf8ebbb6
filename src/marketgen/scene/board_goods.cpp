#include "scene/board_goods.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

namespace marketgen::scene {
namespace {

// From here on goods go low (as in scene/brand_blocks.h, but for what is merely large).
constexpr double low_kg = 1.4;
// Packs whose heights differ by no more share a board.
constexpr double same_height_m = 0.03;
// Facings that a board may have of one product where nothing else is there to fill it.
constexpr int max_gap_facings = 12;

// Gaps are filled with goods that are high rather than with wide ones.
constexpr double usual_gap_m = 0.1;
// A block has so many facings at most, a product with more has two and more blocks.
constexpr int max_block_facings = 6;
// Heaps from here on are filled up before they run out, unless the plan wants more sold out than
// usual.
constexpr double never_empty_m = 0.7;

double pitch_of(const BoardPiece& piece, const catalog::Catalog& catalog) {
  return facing_pitch_m(catalog.products[piece.product]);
}

// What may fill a gap.
struct Candidate {
  std::size_t turn = 0;
  std::uint32_t product = 0;
  bool ranged = false;
};

// A bay's boards while goods are put on them.
class RangePlan {
 public:
  RangePlan(const Bay& bay,
            const BayRange& range,
            const std::vector<std::uint32_t>& assortment,
            const plan::StockSpec& stock,
            const catalog::Catalog& catalog,
            const std::vector<std::uint32_t>& certain)
      : bay_(bay), range_(range), stock_(stock), catalog_(catalog), certain_(certain) {
    extend_range(assortment);
    for (const ShelfRoom& room : bay.shelves) {
      free_m_.push_back(room.width_m * stock.fill);
      front_m_ += free_m_.back();
    }
    boards_.resize(bay.shelves.size());
  }

  std::vector<PlannedShelf> plan() {
    for (const std::uint32_t row : certain_)
      put_certain(row);
    std::size_t from = 0;
    for (const BoardPiece& piece : in_board_order(range_, front_m_, catalog_))
      put(piece, from);
    for (std::size_t board = 0; board < boards_.size(); ++board)
      top_up(board);
    return ordered();
  }

 private:
  const catalog::Product& product_of(const BoardPiece& piece) const {
    return catalog_.products[piece.product];
  }

  // Goods of the assortment that may stand here, each after those of the range that it comes after.
  void extend_range(const std::vector<std::uint32_t>& assortment) {
    std::set<std::pair<std::string_view, std::string_view>> kinds;
    std::map<std::uint32_t, std::size_t> turns;
    for (std::size_t i = 0; i < range_.size(); ++i) {
      const catalog::Product& p = catalog_.products[range_[i].product];
      kinds.insert({p.category, p.subcategory});
      turns[range_[i].product] = i;
    }
    std::size_t turn = 0;
    for (const std::uint32_t row : assortment) {
      const catalog::Product& p = catalog_.products[row];
      const auto ranged = turns.find(row);
      if (ranged != turns.end()) turn = ranged->second;
      if (kinds.contains({p.category, p.subcategory}))
        candidates_.push_back({turn, row, ranged != turns.end()});
    }
  }

  bool takes(std::size_t board, const BoardPiece& piece) const {
    return free_m_[board] >= pitch_of(piece, catalog_) &&
           fits(product_of(piece), bay_.shelves[board]);
  }

  void add(std::size_t board, BoardPiece piece) {
    free_m_[board] -= piece.facings * pitch_of(piece, catalog_);
    const auto same = std::ranges::find(boards_[board], piece.product, &BoardPiece::product);
    if (same == boards_[board].end()) {
      boards_[board].push_back(piece);
    } else {
      same->facings += piece.facings;
    }
  }

  void put_certain(std::uint32_t row) {
    const auto found = std::ranges::find(range_, row, &RangedGoods::product);
    const BoardPiece piece{static_cast<std::size_t>(found - range_.begin()), row, 1, true};
    for (std::size_t board = 0; board < boards_.size(); ++board) {
      if (!takes(board, piece)) continue;
      add(board, piece);
      return;
    }
  }

  int room_for(std::size_t board, const BoardPiece& piece) const {
    return static_cast<int>(free_m_[board] / pitch_of(piece, catalog_));
  }

  bool heaps(std::size_t board) const { return bay_.shelves[board].use == assets::ShelfUse::heap; }

  // Of one block on that board.
  int min_facings(std::size_t board, const catalog::Product& product) const {
    if (!heaps(board)) return 1;
    const double facings = min_heap_front_m(product) / facing_pitch_m(product);
    return std::max(1, static_cast<int>(std::ceil(facings - 1e-9)));
  }

  // On the board that goods have come to, or on that and those above; on any other that holds it
  // where these do not. A single facing, or less than a heap, is left to others.
  void put(BoardPiece piece, std::size_t& from) {
    const std::size_t first = from;
    for (std::size_t board = first; board < boards_.size(); ++board) {
      const int fewest = min_facings(board, product_of(piece));
      piece.facings = std::max(piece.facings, fewest);
      if (!takes(board, piece)) continue;
      const int here = std::min(piece.facings, room_for(board, piece));
      if (here < piece.facings && here < std::max(2, fewest)) continue;
      BoardPiece part = piece;
      part.facings = here;
      add(board, part);
      piece.facings -= here;
      from = board;
      if (piece.facings < std::max(2, fewest)) return;
    }
    for (std::size_t board = 0; board < boards_.size(); ++board) {
      if (!takes(board, piece)) continue;
      const int here = std::min(piece.facings, room_for(board, piece));
      if (here < min_facings(board, product_of(piece))) continue;
      piece.facings = here;
      add(board, piece);
      return;
    }
  }

  void top_up(std::size_t board) {
    while (widen(board, std::max(stock_.facings[1], 2))) {
    }
    while (add_other(board, true)) {
    }
    while (add_other(board, false)) {
    }
    while (widen(board, heaps(board) ? 2 * max_gap_facings : max_gap_facings)) {
    }
  }

  bool widen(std::size_t board, int limit) {
    BoardPiece* best = nullptr;
    for (BoardPiece& piece : boards_[board]) {
      if (piece.facings >= limit || pitch_of(piece, catalog_) > free_m_[board]) continue;
      if (best == nullptr || piece.facings < best->facings) best = &piece;
    }
    if (best == nullptr) return false;
    ++best->facings;
    free_m_[board] -= pitch_of(*best, catalog_);
    return true;
  }

  // What shows the most in the gap: of the range, or else of its kinds.
  bool add_other(std::size_t board, bool ranged) {
    const Candidate* best = nullptr;
    double most = 0;
    for (const Candidate& goods : candidates_) {
      const catalog::Product& p = catalog_.products[goods.product];
      const double needed_m = min_facings(board, p) * facing_pitch_m(p);
      if (goods.ranged != ranged || needed_m > free_m_[board] || stands_on(board, goods)) continue;
      const double shown = stack_height(p, bay_.shelves[board]) * p.height_m() *
                           std::min(facing_pitch_m(p), usual_gap_m);
      if (shown > most && fits(p, bay_.shelves[board]))
        std::tie(best, most) = std::pair(&goods, shown);
    }
    if (best == nullptr) return false;
    BoardPiece piece{best->turn, best->product, 1, false};
    const int fewest = min_facings(board, product_of(piece));
    piece.facings = std::clamp(room_for(board, piece), fewest, std::max(fewest, stock_.facings[0]));
    add(board, piece);
    return true;
  }

  bool stands_on(std::size_t board, const Candidate& goods) const {
    return std::ranges::find(boards_[board], goods.product, &BoardPiece::product) !=
           boards_[board].end();
  }

  static void add_blocks(PlannedShelf& shelf, const BoardPiece& piece) {
    const int blocks = (piece.facings + max_block_facings - 1) / max_block_facings;
    for (int i = 0; i < blocks; ++i) {
      const int facings = piece.facings * (i + 1) / blocks - piece.facings * i / blocks;
      shelf.push_back({piece.product, facings, piece.certain});
    }
  }

  void add_heap(PlannedShelf& shelf, const BoardPiece& piece) const {
    const bool filled_up = stock_.out_of_stock <= plan::StockSpec{}.out_of_stock &&
                           piece.facings * pitch_of(piece, catalog_) >= never_empty_m;
    shelf.push_back({piece.product, piece.facings, piece.certain || filled_up});
  }

  std::vector<PlannedShelf> ordered() {
    std::vector<PlannedShelf> shelves;
    for (BoardGoods& board : boards_) {
      std::ranges::stable_sort(board, {}, &BoardPiece::turn);
      PlannedShelf shelf;
      for (const BoardPiece& piece : board) {
        if (bay_.shelves.front().use == assets::ShelfUse::stand)
          add_blocks(shelf, piece);
        else
          add_heap(shelf, piece);
      }
      shelves.push_back(std::move(shelf));
    }
    return shelves;
  }

  const Bay& bay_;
  const BayRange& range_;
  const plan::StockSpec& stock_;
  const catalog::Catalog& catalog_;
  const std::vector<std::uint32_t>& certain_;
  std::vector<Candidate> candidates_;  // for gaps
  double front_m_ = 0;                 // of all boards
  std::vector<double> free_m_;         // per board
  std::vector<BoardGoods> boards_;     // per board
};

}  // namespace

bool stands_low(const catalog::Product& product) {
  return product.mass_kg >= low_kg;
}

std::vector<BoardPiece> in_board_order(const BayRange& range,
                                       double front_m,
                                       const catalog::Catalog& catalog) {
  double ranged_m = 0;
  for (const RangedGoods& goods : range)
    ranged_m += goods.front_m;
  std::vector<BoardPiece> pieces;
  for (std::size_t i = 0; i < range.size(); ++i) {
    const double pitch_m = facing_pitch_m(catalog.products[range[i].product]);
    const double facings = range[i].front_m * front_m / ranged_m / pitch_m;
    pieces.push_back(
        {i, range[i].product, std::max(1, static_cast<int>(std::lround(facings))), false});
  }
  std::ranges::stable_sort(pieces, {}, [&](const BoardPiece& piece) {
    const catalog::Product& p = catalog.products[piece.product];
    return std::tuple(!stands_low(p), -std::lround(p.height_m() / same_height_m), piece.turn);
  });
  return pieces;
}

std::vector<BoardGoods> deal_out(const std::vector<BoardPiece>& pieces,
                                 std::size_t boards,
                                 double board_m,
                                 const catalog::Catalog& catalog) {
  std::vector<BoardGoods> dealt(boards);
  std::size_t board = 0;
  double free_m = board_m;
  for (BoardPiece piece : pieces) {
    const double pitch_m = pitch_of(piece, catalog);
    while (piece.facings > 0 && board < boards) {
      const int here = std::min(piece.facings, static_cast<int>(free_m / pitch_m));
      const bool is_fresh = free_m == board_m;
      if (here == piece.facings || here >= 2 || (is_fresh && here == 1)) {
        dealt[board].push_back({piece.turn, piece.product, here, false});
        piece.facings -= here;
        free_m -= here * pitch_m;
        if (piece.facings < 2) break;
      } else if (is_fresh) {
        break;  // wider than the board
      }
      ++board;
      free_m = board_m;
    }
    if (board == boards) break;
  }
  return dealt;
}

std::vector<PlannedShelf> plan_range(const Bay& bay,
                                     const BayRange& range,
                                     const std::vector<std::uint32_t>& assortment,
                                     const plan::StockSpec& stock,
                                     const catalog::Catalog& catalog,
                                     const std::vector<std::uint32_t>& certain) {
  if (range.empty() && certain.empty()) return std::vector<PlannedShelf>(bay.shelves.size());
  return RangePlan(bay, range, assortment, stock, catalog, certain).plan();
}

}  // namespace marketgen::scene
