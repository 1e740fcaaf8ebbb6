#include "perception/seen_basket.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>

#include "perception/over_counter.h"
#include "perception/placed_surface.h"

namespace marketgen::perception {
namespace {

constexpr double wall_spacing_m = 0.015;    // of the pieces of a wall that are looked at
constexpr double coarse_spacing_m = 0.035;  // of those that choose among the shifts of the grid
constexpr double shift_step_m = 0.008, shift_step_rad = 0.045;
constexpr float coarse_tolerance_m = 0.008F, fine_tolerance_m = 0.003F;
constexpr std::size_t kept_shifts = 4;
constexpr double basket_step_m = 0.004, min_basket_step_m = 0.0002;
constexpr double turn_arm_m = 0.2;  // from the middle to a wall, about: a turn moves it so far
constexpr float min_wall_facing = 0.2F, min_wall_normals = 0.5F;
constexpr double min_supported = 0.06;  // of all pieces, in each view on average

struct WallPiece {
  Vec3f point, normal;  // basket frame
};

int pieces_along(double half_m, double spacing_m) {
  return std::max(2, static_cast<int>(std::ceil(2 * half_m / spacing_m)));
}

// The rim, and the inner and outer sides, of all walls.
std::vector<WallPiece> wall_pieces(const agent::Workplace& place, double spacing_m) {
  std::vector<WallPiece> pieces;
  for (const agent::WorkBox& wall : place.walls) {
    const Vec3 half = wall.half_size;
    const auto add = [&](Vec3 at, Vec3 normal) {
      pieces.push_back({to_float(wall.pose * at), to_float(rotate(wall.pose.rotation, normal))});
    };
    const int along = pieces_along(half.y, spacing_m), down = pieces_along(half.z, spacing_m);
    for (int i = 0; i < along; ++i) {
      const double y = half.y * ((2 * i + 1.0) / along - 1);
      for (const double side : {-0.5, 0.5})
        add({side * half.x, y, half.z}, {0, 0, 1});
      for (int j = 0; j < down; ++j)
        for (const double side : {-1.0, 1.0})
          add({side * half.x, y, half.z * ((2 * j + 1.0) / down - 1)}, {side, 0, 0});
    }
  }
  return pieces;
}

class BasketFit {
 public:
  BasketFit(const std::vector<ViewCloud>& views, const agent::Workplace& place, double spacing_m)
      : views_(views), nominal_(place.base_from_basket), pieces_(wall_pieces(place, spacing_m)) {}

  // Pieces that are where they should be less those that should be seen and are not.
  double score(const OverCounter& shift, float tolerance_m) const {
    const Placed placed(pose(shift));
    double sum = 0;
    for (const ViewCloud& view : views_)
      for (const WallPiece& piece : pieces_)
        sum += piece_score(piece, placed, view, tolerance_m);
    return sum;
  }
  double max_score() const { return static_cast<double>(pieces_.size() * views_.size()); }
  Pose pose(const OverCounter& shift) const { return shift.about(nominal_.position) * nominal_; }

  OverCounter refined(OverCounter best) const {
    double best_score = score(best, fine_tolerance_m);
    for (double step = basket_step_m; step > min_basket_step_m; step /= 2) {
      bool better = true;
      for (int round = 0; better && round < 8; ++round) {
        better = false;
        for (const double s : {step, -step}) {
          for (const OverCounter& move :
               {OverCounter{s, 0, 0}, {0, s, 0}, {0, 0, s / turn_arm_m}}) {
            const OverCounter moved = best + move;
            const double moved_score = score(moved, fine_tolerance_m);
            if (moved_score <= best_score) continue;
            best = moved, best_score = moved_score, better = true;
          }
        }
      }
    }
    return best;
  }

 private:
  static double piece_score(const WallPiece& piece,
                            const Placed& placed,
                            const ViewCloud& view,
                            float tolerance_m) {
    const Vec3f normal = placed.turned(piece.normal);
    const auto shown = shown_piece(view, placed(piece.point), normal, min_wall_facing, tolerance_m);
    if (!shown) return 0;
    if (shown->is_missing()) return -1;
    const double near = shown->agreement();
    const Vec3f measured = view.normal(shown->pixel);
    const bool has_normal = dot(measured, measured) > 0;
    if (has_normal && dot(measured, normal) < min_wall_normals) return 0;
    return shown->off_m < 0 ? near - (1 - near) : near;
  }

  const std::vector<ViewCloud>& views_;
  Pose nominal_;
  std::vector<WallPiece> pieces_;
};

// The best of a grid, best first.
std::vector<OverCounter> coarse_shifts(const BasketFit& fit, double off_m, double off_rad) {
  const int sides = static_cast<int>(std::ceil(off_m / shift_step_m));
  const int turns = static_cast<int>(std::ceil(off_rad / shift_step_rad));
  std::vector<std::pair<double, OverCounter>> all;
  for (int x = -sides; x <= sides; ++x) {
    for (int y = -sides; y <= sides; ++y) {
      for (int t = -turns; t <= turns; ++t) {
        const OverCounter shift{x * shift_step_m, y * shift_step_m, t * shift_step_rad};
        all.emplace_back(fit.score(shift, coarse_tolerance_m), shift);
      }
    }
  }
  std::ranges::stable_sort(all, std::greater<>{}, [](const auto& entry) { return entry.first; });
  std::vector<OverCounter> best;
  for (std::size_t i = 0; i < std::min(kept_shifts, all.size()); ++i)
    best.push_back(all[i].second);
  return best;
}

}  // namespace

std::optional<Pose> seen_basket(const std::vector<ViewCloud>& views,
                                const agent::Workplace& place,
                                double off_m,
                                double off_rad) {
  const BasketFit fit(views, place, wall_spacing_m), coarse(views, place, coarse_spacing_m);
  std::optional<OverCounter> best;
  double best_score = min_supported * fit.max_score();
  for (const OverCounter& begun : coarse_shifts(coarse, off_m, off_rad)) {
    const OverCounter shift = fit.refined(begun);
    const double score = fit.score(shift, fine_tolerance_m);
    if (score > best_score) best = shift, best_score = score;
  }
  if (!best) return std::nullopt;
  return fit.pose(*best);
}

}  // namespace marketgen::perception
