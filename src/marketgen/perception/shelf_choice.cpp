#include "perception/shelf_choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "base/progress.h"

namespace marketgen::perception {
namespace {

constexpr std::size_t sweep_surfels = 150, fit_surfels = 700;
constexpr std::size_t max_fitted = 10;  // of the spots, those that agree best
constexpr double min_swept = 0.12;      // score of a spot that is worth a closer look
constexpr double min_found = 0.30;      // score of what is taken for the product
constexpr double min_shelf_fit = 0.85;  // of packs found rightly on 11 shelves the lowest had 0.98
constexpr double apart_share = 0.6;     // of a pack's width, between two that are looked at
constexpr double first_step_m = 0.004, last_step_m = 0.0006;
constexpr double step_rad_per_m = 12;  // of the turn, for each metre of the step
constexpr double worth_a_turn = 1.04;
constexpr double again_m = 0.04;  // from where it was found, before a second look
constexpr double rival_better = 1.0;
constexpr std::array over_top_m{0.008, 0.014, 0.020};
constexpr float flush_m = 0.010F;  // along the view, between what goes on and what does not
constexpr double mostly = 0.6;
constexpr int max_stacked = 6;
constexpr double alike_share = 0.75;  // of the score of the pack under it

// The middle of its front, at the bottom, in its own frame.
Vec3 front_of(const ProductLook& look) {
  return {0.5 * static_cast<double>(look.low().x + look.high().x),
          static_cast<double>(look.low().y),
          0};
}

// The product with the middle of its front on the spot.
Pose pose_on(const ShelfSpot& spot, const BoardAhead& board, const ProductLook& look) {
  return board.base_from_board * Pose{Vec3{spot.x_m, spot.front_m, 0} - front_of(look), {}};
}

ShelfSpot spot_of(const Pose& pose,
                  std::size_t number,
                  const BoardAhead& board,
                  const ProductLook& look) {
  const Vec3 at = (inverse(board.base_from_board) * pose).position + front_of(look);
  return {number, at.x, at.y};
}

// A board as wide and deep as a product may stand elsewhere than it was found, with the product in
// its middle.
BoardAhead board_around(const ProductLook& look, const Pose& base_from_product) {
  const Vec3f size = look.high() - look.low();
  return {base_from_product * Pose{front_of(look), {}},
          static_cast<double>(size.x) + 2 * again_m,
          again_m,
          static_cast<double>(size.z)};
}

// From there along the board and into it, and about the upright where it may turn: it goes on
// standing.
FittedPose moved_best(const ProductLook& look,
                      const Pose& from,
                      const std::vector<ViewCloud>& views,
                      bool may_turn) {
  const SurfacePatch none;
  FittedPose best{from, evidence_of(look, from, none, views, fit_surfels)};
  for (double step = first_step_m; step > last_step_m; step /= 2) {
    for (bool moved = true; moved;) {
      moved = false;
      const double turn = step * step_rad_per_m;
      const std::array moves{Pose{{step, 0, 0}, {}},
                             Pose{{-step, 0, 0}, {}},
                             Pose{{0, step, 0}, {}},
                             Pose{{0, -step, 0}, {}},
                             Pose{{}, rotation_about({0, 0, 1}, turn)},
                             Pose{{}, rotation_about({0, 0, 1}, -turn)}};
      for (const Pose& move : std::span(moves).first(may_turn ? moves.size() : moves.size() - 2)) {
        const Pose pose = best.base_from_product * move;
        const PoseEvidence e = evidence_of(look, pose, none, views, fit_surfels);
        if (e.score <= best.evidence.score * 1.001) continue;
        best = {pose, e};
        moved = true;
      }
    }
  }
  return best;
}

FittedPose stood_best(const ProductLook& look,
                      const Pose& near,
                      const std::vector<ViewCloud>& views) {
  return moved_best(look, near, views, true);
}

// Faced as `straight` is, unless it fits clearly better as it was found: a narrow front or a round
// one says little of how it is turned, and goods are faced straight. Which product it is has been
// told before, by the turn that fits each best.
FittedPose faced(const ProductLook& look,
                 const FittedPose& found,
                 const Quaternion& straight,
                 const std::vector<ViewCloud>& views) {
  const FittedPose there =
      moved_best(look, {found.base_from_product.position, straight}, views, false);
  return found.evidence.score > worth_a_turn * there.evidence.score ? found : there;
}

// Of what is measured right over its front, the share that goes on in the same surface: the front
// of something taller, or what stands on it.
double flush_above(const ProductLook& look, const Pose& pose, const std::vector<ViewCloud>& views) {
  const Vec3 low = to_double(look.low()), high = to_double(look.high());
  double flush = 0, seen = 0;
  for (const ViewCloud& view : views) {
    for (const double across : {-0.2, 0.0, 0.2}) {
      for (const double above : over_top_m) {
        const Vec3 point =
            pose * Vec3{(low.x + high.x) / 2 + across * (high.x - low.x), low.y, high.z + above};
        const auto at = view.project(to_float(point));
        if (!at || !view.has(at->pixel)) continue;
        const float off = view.view().depth_m[at->pixel] - at->depth_m;
        if (off < -flush_m) continue;  // something before it: nothing is known
        ++seen;
        if (off < flush_m) ++flush;
      }
    }
  }
  return seen > 0 ? flush / seen : 0;
}

bool is_there(const FittedPose& pose) {
  return pose.evidence.score >= min_found && pose.evidence.fit >= min_shelf_fit;
}

// From a pack up to the one that stands on all others: that one can be taken.
FittedPose top_of_stack(const ProductLook& look,
                        FittedPose found,
                        const std::vector<ViewCloud>& views) {
  const auto height = static_cast<double>(look.high().z);
  for (int level = 1; level < max_stacked; ++level) {
    if (flush_above(look, found.base_from_product, views) < mostly) break;
    const Pose up = found.base_from_product * Pose{{0, 0, height}, {}};
    const FittedPose above = stood_best(look, up, views);
    if (!is_there(above) || above.evidence.score < alike_share * found.evidence.score) break;
    found = above;
  }
  return found;
}

struct Swept {
  ShelfSpot spot;
  double score = 0;
};

// `there`: where a rival would stand.
template <typename Place>
bool is_rival(const WantedProduct& wanted,
              const FittedPose& found,
              const std::vector<ViewCloud>& views,
              const Place& there) {
  return std::ranges::any_of(wanted.rivals, [&](const ProductLook* rival) {
    const double score = stood_best(*rival, there(*rival), views).evidence.score;
    const bool better = score > found.evidence.score * rival_better;
    if (better)
      log_debug(fmt::format("{} explains {:.2f} better ({:.2f}) than {}",
                            rival->sku(),
                            found.evidence.score,
                            score,
                            wanted.look->sku()));
    return better;
  });
}

}  // namespace

double apart_on_shelf(const ProductLook& look) {
  return apart_share * static_cast<double>(look.high().x - look.low().x);
}

std::vector<ShelfSpot> likely_spots(const ProductLook& look,
                                    const std::vector<ViewCloud>& views,
                                    const std::vector<BoardAhead>& boards,
                                    const std::vector<ShelfSpot>& spots,
                                    std::size_t max_spots) {
  std::vector<Swept> swept;
  for (const ShelfSpot& spot : spots) {
    const Pose pose = pose_on(spot, boards[spot.board], look);
    const double score = evidence_of(look, pose, {}, views, sweep_surfels).score;
    if (score >= min_swept) swept.push_back({spot, score});
  }
  std::ranges::stable_sort(swept, std::greater<>{}, &Swept::score);
  std::vector<ShelfSpot> best;
  for (const auto& [candidate, score] : swept) {
    if (best.size() >= max_spots) break;
    const bool taken = std::ranges::any_of(best, [&](const ShelfSpot& other) {
      return other.board == candidate.board &&
             std::abs(other.x_m - candidate.x_m) < apart_on_shelf(look);
    });
    if (!taken) best.push_back(candidate);
  }
  return best;
}

std::vector<FoundOnShelf> UprightMatching::find(const WantedProduct& wanted,
                                                const std::vector<ViewCloud>& views,
                                                const std::vector<BoardAhead>& boards,
                                                const std::vector<ShelfSpot>& spots) const {
  const ProductLook& look = *wanted.look;
  std::vector<FoundOnShelf> found;
  for (const ShelfSpot& spot : likely_spots(look, views, boards, spots, max_fitted)) {
    const Pose pose = pose_on(spot, boards[spot.board], look);
    FoundOnShelf there{spot, stood_best(look, pose, views)};
    if (!is_there(there.pose)) continue;
    there.spot = spot_of(there.pose.base_from_product, spot.board, boards[spot.board], look);
    there.pose = top_of_stack(look, there.pose, views);
    if (flush_above(look, there.pose.base_from_product, views) > mostly) continue;
    const auto rival_there = [&](const ProductLook& rival) {
      return pose_on(there.spot, boards[spot.board], rival);
    };
    if (is_rival(wanted, there.pose, views, rival_there)) continue;
    there.pose = faced(look, there.pose, boards[spot.board].base_from_board.rotation, views);
    found.push_back(there);
  }
  std::ranges::stable_sort(
      found, std::greater<>{}, [](const FoundOnShelf& f) { return f.pose.evidence.score; });
  return found;
}

FittedPose UprightMatching::again(const WantedProduct& wanted,
                                  const std::vector<ViewCloud>& views,
                                  const Pose& base_from_product) const {
  const ProductLook& look = *wanted.look;
  FittedPose best{base_from_product,
                  evidence_of(look, base_from_product, {}, views, sweep_surfels)};
  const BoardAhead around = board_around(look, base_from_product);
  for (const ShelfSpot& spot : SweptSpots().spots(views, {around}, look.high() - look.low())) {
    const Pose pose = pose_on(spot, around, look);
    const PoseEvidence e = evidence_of(look, pose, {}, views, sweep_surfels);
    if (e.score > best.evidence.score) best = {pose, e};
  }
  if (best.evidence.score <= 0) return best;
  best = stood_best(look, best.base_from_product, views);
  const auto rival_there = [&](const ProductLook& rival) {
    return best.base_from_product * Pose{front_of(look) - front_of(rival), {}};
  };
  if (is_rival(wanted, best, views, rival_there)) return {};
  return faced(look, best, base_from_product.rotation, views);
}

}  // namespace marketgen::perception
