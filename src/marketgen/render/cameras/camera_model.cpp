#include "render/cameras/camera_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>

namespace marketgen::render {
namespace {

constexpr int max_newton_steps = 40;
constexpr double newton_tolerance = 1e-12;  // of the plane at distance 1
constexpr double min_stretch = 1e-3;        // of an area of the image plane: below, it folds
constexpr double farthest_tangent = 11.43;  // tan(85 degrees)

struct Stretch {
  double xx, xy, yx, yy;  // derivatives of the distorted point: d(x') / dx, d(x') / dy, ...
  double area() const { return xx * yy - xy * yx; }
};

Stretch stretch_at(const LensDistortion& lens, Vec2 p) {
  const double r2 = p.x * p.x + p.y * p.y;
  const double radial = 1 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
  const double slope =
      2 * (lens.k1 + r2 * (2 * lens.k2 + r2 * 3 * lens.k3));  // d(radial) / d(r2) * 2
  const double mixed = p.x * p.y * slope + 2 * lens.p1 * p.x + 2 * lens.p2 * p.y;
  return {radial + p.x * p.x * slope + 2 * lens.p1 * p.y + 6 * lens.p2 * p.x,
          mixed,
          mixed,
          radial + p.y * p.y * slope + 6 * lens.p1 * p.y + 2 * lens.p2 * p.x};
}

// The ideal point that falls on `seen`, from a guess.
std::optional<Vec2> solved(const LensDistortion& lens, Vec2 seen, Vec2 guess) {
  Vec2 p = guess;
  for (int step = 0; step < max_newton_steps; ++step) {
    const Vec2 off = seen - distorted(lens, p);
    if (std::fabs(off.x) < newton_tolerance && std::fabs(off.y) < newton_tolerance) return p;
    const Stretch s = stretch_at(lens, p);
    const double area = s.area();
    if (!(std::fabs(area) > 1e-9)) return std::nullopt;  // false for NaN too
    p = p + Vec2{(s.yy * off.x - s.xy * off.y) / area, (s.xx * off.y - s.yx * off.x) / area};
  }
  return std::nullopt;
}

// The same from the middle of the picture outwards, step by step: it cannot jump over a fold.
std::optional<Vec2> followed(const LensDistortion& lens, Vec2 seen) {
  constexpr int steps = 24;
  Vec2 p{0, 0};
  for (int step = 1; step <= steps; ++step) {
    const auto next = solved(lens, seen * (double(step) / steps), p);
    if (!next || stretch_at(lens, *next).area() < min_stretch) return std::nullopt;
    if (std::hypot(next->x, next->y) > farthest_tangent) return std::nullopt;
    p = *next;
  }
  return p;
}

// Whether the plane folds on the way from the picture's middle to a point.
bool is_folded(const LensDistortion& lens, Vec2 ideal) {
  constexpr int steps = 8;
  for (int step = 1; step <= steps; ++step) {
    if (stretch_at(lens, ideal * (double(step) / steps)).area() < min_stretch) return true;
  }
  return false;
}

Vec2 image_plane_point(const Intrinsics& k, double x, double y) {
  return {(x - k.cx) / k.fx, (y - k.cy) / k.fy};
}

bool sees_one_direction_at(const Intrinsics& k, double x, double y) {
  const Vec2 seen = image_plane_point(k, x, y);
  const auto ideal = followed(k.distortion, seen);
  if (!ideal) return false;
  const auto direct = undistorted(k.distortion, seen);  // as rays find it
  return direct && std::hypot(direct->x - ideal->x, direct->y - ideal->y) < 1e-6;
}

Error bad_lens(const std::string& where, const std::string& message) {
  return {"camera.bad_lens", where, message};
}

}  // namespace

Intrinsics centred_pinhole(int width, int height, double fov_deg) {
  const double focal = height / (2 * std::tan(fov_deg * std::numbers::pi / 360));
  return {focal, focal, (width - 1) / 2.0, (height - 1) / 2.0, {}};
}

Vec2 distorted(const LensDistortion& lens, Vec2 p) {
  const double r2 = p.x * p.x + p.y * p.y;
  const double radial = 1 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
  return {p.x * radial + 2 * lens.p1 * p.x * p.y + lens.p2 * (r2 + 2 * p.x * p.x),
          p.y * radial + lens.p1 * (r2 + 2 * p.y * p.y) + 2 * lens.p2 * p.x * p.y};
}

std::optional<Vec2> undistorted(const LensDistortion& lens, Vec2 seen) {
  if (lens.none()) return seen;
  return solved(lens, seen, seen);
}

std::optional<Vec2> project(const Intrinsics& k, Vec3 p) {
  if (!(p.z > 0)) return std::nullopt;
  const Vec2 ideal{p.x / p.z, p.y / p.z};
  if (!k.distortion.none() && is_folded(k.distortion, ideal)) return std::nullopt;
  const Vec2 seen = distorted(k.distortion, ideal);
  return Vec2{k.fx * seen.x + k.cx, k.fy * seen.y + k.cy};
}

Result<void> check_lens(const Intrinsics& k, int width, int height, const std::string& where) {
  const LensDistortion& d = k.distortion;
  for (const double number : {k.fx, k.fy, k.cx, k.cy, d.k1, d.k2, d.p1, d.p2, d.k3}) {
    if (!std::isfinite(number)) return bad_lens(where, "a number of its lens is not finite");
  }
  if (!(k.fx > 0 && k.fy > 0))
    return bad_lens(where,
                    fmt::format("its focal lengths are {} and {} pixels; both must be positive "
                                "(width / 2 / tan(half the horizontal field of view))",
                                k.fx,
                                k.fy));
  constexpr int cells = 16;  // across the picture, and down
  for (int row = 0; row <= cells; ++row) {
    for (int column = 0; column <= cells; ++column) {
      const double x = width * double(column) / cells - 0.5, y = height * double(row) / cells - 0.5;
      const Vec2 seen = image_plane_point(k, x, y);
      if (d.none() && std::hypot(seen.x, seen.y) <= farthest_tangent) continue;
      if (!d.none() && sees_one_direction_at(k, x, y)) continue;
      return bad_lens(
          where,
          fmt::format("no single direction within 85 degrees of its axis falls on picture point "
                      "({:.0f}, {:.0f}); check the focal length in pixels, and that the distortion "
                      "is k1, k2, p1, p2, k3 of a calibration at this picture size",
                      x,
                      y));
    }
  }
  return {};
}

}  // namespace marketgen::render
