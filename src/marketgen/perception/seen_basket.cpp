#include "perception/seen_basket.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>

namespace marketgen::perception {
namespace {

constexpr double wall_spacing_m = 0.015;  // of the pieces of a wall that are looked at
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

int pieces_along(double half_m) {
  return std::max(2, static_cast<int>(std::ceil(2 * half_m / wall_spacing_m)));
}

// The rim, and the inner and outer sides, of all walls.
std::vector<WallPiece> wall_pieces(const agent::Workplace& place) {
  std::vector<WallPiece> pieces;
  for (const agent::WorkBox& wall : place.walls) {
    const Vec3 half = wall.half_size;
    const auto add = [&](Vec3 at, Vec3 normal) {
      pieces.push_back({to_float(wall.pose * at), to_float(rotate(wall.pose.rotation, normal))});
    };
    const int along = pieces_along(half.y), down = pieces_along(half.z);
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

// How it stands against where it is said to.
struct Shift {
  double x_m = 0, y_m = 0, turn_rad = 0;
  Pose of(const Pose& nominal) const {
    return {nominal.position + Vec3{x_m, y_m, 0},
            rotation_about({0, 0, 1}, turn_rad) * nominal.rotation};
  }
};

class BasketFit {
 public:
  BasketFit(const std::vector<ViewCloud>& views, const agent::Workplace& place)
      : views_(views), nominal_(place.base_from_basket), pieces_(wall_pieces(place)) {}

  // Pieces that are where they should be less those that should be seen and are not.
  double score(const Shift& shift, float tolerance_m) const {
    const Matrix34 m = matrix_of(shift.of(nominal_));
    double sum = 0;
    for (const ViewCloud& view : views_)
      for (const WallPiece& piece : pieces_)
        sum += piece_score(piece, m, view, tolerance_m);
    return sum;
  }
  double max_score() const { return static_cast<double>(pieces_.size() * views_.size()); }
  Pose pose(const Shift& shift) const { return shift.of(nominal_); }

  Shift refined(Shift best) const {
    double best_score = score(best, fine_tolerance_m);
    for (double step = basket_step_m; step > min_basket_step_m; step /= 2) {
      bool better = true;
      for (int round = 0; better && round < 8; ++round) {
        better = false;
        for (const double s : {step, -step}) {
          for (const Shift& move : {Shift{s, 0, 0}, {0, s, 0}, {0, 0, s / turn_arm_m}}) {
            const Shift moved{
                best.x_m + move.x_m, best.y_m + move.y_m, best.turn_rad + move.turn_rad};
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
  static Vec3f turned(const Matrix34& m, Vec3f v) {
    return {static_cast<float>(m.m[0][0]) * v.x + static_cast<float>(m.m[0][1]) * v.y +
                static_cast<float>(m.m[0][2]) * v.z,
            static_cast<float>(m.m[1][0]) * v.x + static_cast<float>(m.m[1][1]) * v.y +
                static_cast<float>(m.m[1][2]) * v.z,
            static_cast<float>(m.m[2][0]) * v.x + static_cast<float>(m.m[2][1]) * v.y +
                static_cast<float>(m.m[2][2]) * v.z};
  }

  static double piece_score(const WallPiece& piece,
                            const Matrix34& m,
                            const ViewCloud& view,
                            float tolerance_m) {
    const Vec3f point = turned(m, piece.point) + Vec3f{static_cast<float>(m.m[0][3]),
                                                       static_cast<float>(m.m[1][3]),
                                                       static_cast<float>(m.m[2][3])};
    const Vec3f normal = turned(m, piece.normal);
    const float facing = dot(normal, normalized(view.eye() - point));
    if (facing < min_wall_facing) return 0;
    const auto seen = view.project(point);
    if (!seen || !view.has(seen->pixel)) return 0;
    const float off = seen->depth_m - view.view().depth_m[seen->pixel];
    const float slope = std::sqrt(1 - facing * facing) / facing;
    const float tolerance = tolerance_m + view.pixel_m(seen->depth_m) * slope;
    if (off < -2 * tolerance) return -1;
    const double near = std::clamp(2.0 - static_cast<double>(std::abs(off) / tolerance), 0.0, 1.0);
    const Vec3f measured = view.normal(seen->pixel);
    const bool has_normal = dot(measured, measured) > 0;
    if (has_normal && dot(measured, normal) < min_wall_normals) return 0;
    return off < 0 ? near - (1 - near) : near;
  }

  const std::vector<ViewCloud>& views_;
  Pose nominal_;
  std::vector<WallPiece> pieces_;
};

// The best of a grid, best first.
std::vector<Shift> coarse_shifts(const BasketFit& fit, double off_m, double off_rad) {
  const int sides = static_cast<int>(std::ceil(off_m / shift_step_m));
  const int turns = static_cast<int>(std::ceil(off_rad / shift_step_rad));
  std::vector<std::pair<double, Shift>> all;
  for (int x = -sides; x <= sides; ++x) {
    for (int y = -sides; y <= sides; ++y) {
      for (int t = -turns; t <= turns; ++t) {
        const Shift shift{x * shift_step_m, y * shift_step_m, t * shift_step_rad};
        all.emplace_back(fit.score(shift, coarse_tolerance_m), shift);
      }
    }
  }
  std::ranges::stable_sort(all, std::greater<>{}, [](const auto& entry) { return entry.first; });
  std::vector<Shift> best;
  for (std::size_t i = 0; i < std::min(kept_shifts, all.size()); ++i)
    best.push_back(all[i].second);
  return best;
}

}  // namespace

std::optional<Pose> seen_basket(const std::vector<ViewCloud>& views,
                                const agent::Workplace& place,
                                double off_m,
                                double off_rad) {
  const BasketFit fit(views, place);
  std::optional<Shift> best;
  double best_score = min_supported * fit.max_score();
  for (const Shift& begun : coarse_shifts(fit, off_m, off_rad)) {
    const Shift shift = fit.refined(begun);
    const double score = fit.score(shift, fine_tolerance_m);
    if (score > best_score) best = shift, best_score = score;
  }
  if (!best) return std::nullopt;
  return fit.pose(*best);
}

}  // namespace marketgen::perception
