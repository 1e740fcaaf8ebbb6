#include "scene/board_goods.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace marketgen::scene {
namespace {

// From here on goods go low (as in scene/brand_blocks.h, but for what is merely large).
constexpr double low_kg = 1.4;
// Packs whose heights differ by no more share a board.
constexpr double same_height_m = 0.03;
// Facings that a board may have of one product where nothing else is there to fill it.
constexpr int most_facings = 12;

double pitch_of(const BoardPiece& piece, const catalog::Catalog& catalog) {
  return facing_pitch_m(catalog.products[piece.product]);
}

// A bay's boards while goods are put on them.
class RangePlan {
 public:
  RangePlan(const Bay& bay,
            const BayRange& range,
            const plan::StockSpec& stock,
            const catalog::Catalog& catalog,
            const std::vector<std::uint32_t>& certain)
      : bay_(bay), range_(range), stock_(stock), catalog_(catalog), certain_(certain) {
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

  // On the board that goods have come to, or on that and those above; on any other that holds it
  // where these do not.
  void put(BoardPiece piece, std::size_t& from) {
    const std::size_t first = from;
    for (std::size_t board = first; board < boards_.size() && piece.facings > 0; ++board) {
      if (!takes(board, piece)) continue;
      const int here = std::min(piece.facings, room_for(board, piece));
      if (here < piece.facings && here < 2) continue;  // a single facing is left to others
      BoardPiece part = piece;
      part.facings = here;
      add(board, part);
      piece.facings -= here;
      from = board;
      if (piece.facings < 2) return;
    }
    for (std::size_t board = 0; board < boards_.size() && piece.facings > 0; ++board) {
      if (!takes(board, piece)) continue;
      piece.facings = std::min(piece.facings, room_for(board, piece));
      add(board, piece);
      return;
    }
  }

  void top_up(std::size_t board) {
    const bool heap = bay_.shelves[board].use == assets::ShelfUse::heap;
    while (widen(board, max_facings)) {
    }
    while (add_other(board)) {
    }
    while (widen(board, heap ? 2 * most_facings : most_facings)) {
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

  // The tallest of the range that stands elsewhere and has room here.
  bool add_other(std::size_t board) {
    const RangedGoods* best = nullptr;
    int high = 0;
    for (const RangedGoods& goods : range_) {
      const catalog::Product& p = catalog_.products[goods.product];
      const bool stands = std::ranges::find(boards_[board], goods.product, &BoardPiece::product) !=
                          boards_[board].end();
      if (stands || facing_pitch_m(p) > free_m_[board]) continue;
      const int filled_mm = stack_height(p, bay_.shelves[board]) * p.size_mm[2];
      if (fits(p, bay_.shelves[board]) && filled_mm > high) std::tie(best, high) = std::pair(&goods, filled_mm);
    }
    if (best == nullptr) return false;
    BoardPiece piece{static_cast<std::size_t>(best - range_.data()), best->product, 1, false};
    piece.facings = std::clamp(room_for(board, piece), 1, std::max(1, stock_.facings[1]));
    add(board, piece);
    return true;
  }

  std::vector<PlannedShelf> ordered() {
    std::vector<PlannedShelf> shelves;
    for (BoardGoods& board : boards_) {
      std::ranges::stable_sort(board, {}, &BoardPiece::turn);
      PlannedShelf shelf;
      for (const BoardPiece& piece : board)
        shelf.push_back({piece.product, piece.facings, piece.certain});
      shelves.push_back(std::move(shelf));
    }
    return shelves;
  }

  const Bay& bay_;
  const BayRange& range_;
  const plan::StockSpec& stock_;
  const catalog::Catalog& catalog_;
  const std::vector<std::uint32_t>& certain_;
  double front_m_ = 0;              // of all boards
  std::vector<double> free_m_;      // per board
  std::vector<BoardGoods> boards_;  // per board
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
    pieces.push_back({i, range[i].product, std::max(1, static_cast<int>(std::lround(facings))), false});
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
      if (here == piece.facings || here >= 2) {
        dealt[board].push_back({piece.turn, piece.product, here, false});
        piece.facings -= here;
        free_m -= here * pitch_m;
        if (piece.facings < 2) break;
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
                                     const plan::StockSpec& stock,
                                     const catalog::Catalog& catalog,
                                     const std::vector<std::uint32_t>& certain) {
  if (range.empty() && certain.empty()) return std::vector<PlannedShelf>(bay.shelves.size());
  return RangePlan(bay, range, stock, catalog, certain).plan();
}

}  // namespace marketgen::scene
