#include "scene/fitted_boards.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "scene/board_goods.h"

namespace marketgen::scene {
namespace {

// Boards run through neighbouring bays where they show no less than this share of what boards of
// each bay's own would; photos of shops have from two to five bays alike.
constexpr double nearly = 0.9;
constexpr std::size_t max_alike = 5;
// Over the top edge of an open bay its goods may rise by so much.
constexpr double over_edge_m = 0.10;
// A board is raised for one more layer where that fills no less than this share of what it is
// raised by: over goods that do not stack there is only air then.
constexpr double raised_share = 0.45;
// A board takes some of what it could show: of two ways that show as much, the one with fewer.
constexpr double board_cost_m = 0.02;

struct FittedBoards {
  std::vector<double> pitches_m;
  double shown_m2 = -1;  // goods' fronts, seen from before the bays
};

// The boards that bays beside one another have in common.
class BoardFit {
 public:
  BoardFit(std::span<const FitBay> bays,
           const plan::StockSpec& stock,
           const catalog::Catalog& catalog)
      : bays_(bays), opening_(*bays.front().opening), catalog_(catalog), fill_(stock.fill) {
    for (const FitBay& bay : bays)
      width_m_ += bay.opening->width_m;
  }

  FittedBoards best() const {
    FittedBoards best;
    for (int levels = opening_.levels[0]; levels <= opening_.levels[1]; ++levels) {
      FittedBoards fitted = with_levels(levels);
      if (fitted.shown_m2 > best.shown_m2) best = std::move(fitted);
    }
    return best;
  }

 private:
  // Of all bays together, board by board.
  std::vector<BoardGoods> dealt(std::size_t levels) const {
    std::vector<BoardGoods> boards(levels);
    for (const FitBay& bay : bays_) {
      const double board_m = bay.opening->width_m * fill_;
      const double front_m = board_m * static_cast<double>(levels);
      const std::vector<BoardGoods> own =
          deal_out(in_board_order(*bay.range, front_m, catalog_), levels, board_m, catalog_);
      for (std::size_t i = 0; i < levels; ++i)
        boards[i].insert(boards[i].end(), own[i].begin(), own[i].end());
    }
    return boards;
  }

  const catalog::Product& product_of(const BoardPiece& piece) const {
    return catalog_.products[piece.product];
  }

  double needed_clearance_m(const BoardGoods& board) const {
    double tallest_m = 0;
    for (const BoardPiece& piece : board)
      tallest_m = std::max(tallest_m, product_of(piece).height_m());
    return std::max(min_opening_m, tallest_m + hand_room_m);
  }

  double clearance_m(const std::vector<double>& pitches_m, std::size_t board) const {
    if (board + 1 < pitches_m.size()) return pitches_m[board] - opening_.lost_m;
    return opening_.open_top ? std::min(open_top_m, pitches_m[board] + over_edge_m)
                             : pitches_m[board];
  }

  double in_slots(double pitch_m) const {
    return std::ceil(pitch_m / opening_.slot_m - 1e-9) * opening_.slot_m;
  }

  double shown_m2(const BoardGoods& board, double clearance) const {
    double sum = 0;
    for (const BoardPiece& piece : board) {
      const catalog::Product& p = product_of(piece);
      const double usable = clearance - finger_room_m;
      const int stack = std::min(p.stack_max, static_cast<int>(usable / p.height_m()));
      sum += piece.facings * facing_pitch_m(p) * std::max(0, stack) * p.height_m();
    }
    return sum;
  }

  double shown_m2(const std::vector<BoardGoods>& boards,
                  const std::vector<double>& pitches_m) const {
    double sum = -board_cost_m * width_m_ * static_cast<double>(boards.size());
    for (std::size_t i = 0; i < boards.size(); ++i)
      sum += shown_m2(boards[i], clearance_m(pitches_m, i));
    return sum;
  }

  // The lowest boards for the goods, then what height is left where it shows the most.
  FittedBoards with_levels(int levels) const {
    const std::vector<BoardGoods> boards = dealt(static_cast<std::size_t>(levels));
    FittedBoards fitted;
    double left_m = opening_.height_m;
    for (std::size_t i = 0; i < boards.size(); ++i) {
      const bool last = i + 1 == boards.size();
      const double needed_m = needed_clearance_m(boards[i]);
      double pitch_m = in_slots(needed_m + opening_.lost_m);
      if (last)
        pitch_m = opening_.open_top ? std::max(min_opening_m, needed_m - over_edge_m) : needed_m;
      fitted.pitches_m.push_back(pitch_m);
      left_m -= pitch_m;
    }
    if (left_m < -1e-9) return {};
    raise(fitted.pitches_m, boards, left_m);
    spread(fitted.pitches_m, left_m);
    fitted.shown_m2 = shown_m2(boards, fitted.pitches_m);
    return fitted;
  }

  // Board by board as many slots as let the most goods stand on others, for each slot.
  void raise(std::vector<double>& pitches_m,
             const std::vector<BoardGoods>& boards,
             double& left_m) const {
    while (left_m >= opening_.slot_m - 1e-9) {
      double most = raised_share * width_m_ * fill_ * opening_.slot_m;  // for a slot
      std::size_t at = 0;
      int by = 0;
      for (std::size_t i = 0; i < boards.size(); ++i) {
        const double now = shown_m2(boards[i], clearance_m(pitches_m, i));
        std::vector<double> higher = pitches_m;
        for (int slots = 1; slots * opening_.slot_m <= left_m + 1e-9; ++slots) {
          higher[i] = pitches_m[i] + slots * opening_.slot_m;
          const double gain = (shown_m2(boards[i], clearance_m(higher, i)) - now) / slots;
          if (gain > most + 1e-9) most = gain, at = i, by = slots;
        }
      }
      if (by == 0) return;
      pitches_m[at] += by * opening_.slot_m;
      left_m -= by * opening_.slot_m;
    }
  }

  // What nothing needs, slot by slot over each board but the last, the lowest first.
  void spread(std::vector<double>& pitches_m, double& left_m) const {
    const std::size_t boards = pitches_m.size() - 1;
    for (std::size_t i = 0; boards > 0 && left_m >= opening_.slot_m - 1e-9; i = (i + 1) % boards) {
      pitches_m[i] += opening_.slot_m;
      left_m -= opening_.slot_m;
    }
    pitches_m.back() += left_m;
    left_m = 0;
  }

  std::span<const FitBay> bays_;
  const BayOpening& opening_;  // the bays differ in their widths alone
  const catalog::Catalog& catalog_;
  double fill_;
  double width_m_ = 0;  // of all bays
};

std::vector<int> in_mm(const std::vector<double>& pitches_m) {
  std::vector<int> spacings;
  for (const double pitch : pitches_m)
    spacings.push_back(static_cast<int>(std::floor(pitch * 1e3 + 1e-6)));
  return spacings;
}

}  // namespace

std::vector<std::vector<int>> fitted_spacings(const std::vector<FitBay>& bays,
                                              const plan::StockSpec& stock,
                                              const catalog::Catalog& catalog) {
  const auto best_of = [&](std::size_t from, std::size_t count) {
    return BoardFit(std::span(bays).subspan(from, count), stock, catalog).best();
  };
  std::vector<FittedBoards> own;
  for (std::size_t i = 0; i < bays.size(); ++i)
    own.push_back(bays[i].range->empty() ? FittedBoards{} : best_of(i, 1));
  std::vector<std::vector<int>> spacings;
  while (spacings.size() < bays.size()) {
    const std::size_t from = spacings.size();
    FittedBoards best = own[from];
    double own_m2 = best.shown_m2;
    std::size_t count = 1;
    for (; from + count < bays.size() && count < max_alike; ++count) {
      if (best.pitches_m.empty() || own[from + count].pitches_m.empty()) break;
      own_m2 += own[from + count].shown_m2;
      FittedBoards alike = best_of(from, count + 1);
      if (alike.pitches_m.empty() || alike.shown_m2 < nearly * own_m2) break;
      best = std::move(alike);
    }
    spacings.insert(spacings.end(), count, in_mm(best.pitches_m));
  }
  return spacings;
}

}  // namespace marketgen::scene
