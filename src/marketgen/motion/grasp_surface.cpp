#include "motion/grasp_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/convex_hull.h"

namespace marketgen::motion {
namespace {

constexpr double parallel = 1e-12;      // a ray whose cosine with a face is less runs along it
constexpr int pad_samples = 5;          // along each side of a pad
constexpr double pad_yield_m = 0.0003;  // rubber gives way by so much: what is nearer is touched
constexpr int lip_samples = 16;         // round a cup's lip, and half as many half-way in

// Where a ray is inside a convex piece: from `enter` to `leave`.
struct Inside {
  double enter = -std::numeric_limits<double>::infinity();
  double leave = std::numeric_limits<double>::infinity();
  Vec3 normal{};  // where it enters

  // Narrows it to the half space dot(n, p) <= offset.
  void clip(Vec3 n, double offset, Vec3 origin, Vec3 direction) {
    const double rate = dot(n, direction), above = dot(n, origin) - offset;
    if (std::abs(rate) < parallel) {
      if (above > 0) leave = -std::numeric_limits<double>::infinity();
      return;
    }
    const double at = -above / rate;
    if (rate > 0) {
      leave = std::min(leave, at);
    } else if (at > enter) {
      enter = at;
      normal = n;
    }
  }
};

// The ray against |p / half| = 1 in the axes that `half` counts (others infinite).
void clip_round(Inside& inside, Vec3 center, Vec3 inverse_half, Vec3 origin, Vec3 direction) {
  const Vec3 o = (origin - center) * inverse_half, d = direction * inverse_half;
  const double a = dot(d, d), b = dot(o, d), c = dot(o, o) - 1;
  if (a < parallel) {
    if (c > 0) inside.leave = -std::numeric_limits<double>::infinity();
    return;
  }
  const double root = b * b - a * c;
  if (root < 0) {
    inside.leave = -std::numeric_limits<double>::infinity();
    return;
  }
  const double enter = (-b - std::sqrt(root)) / a;
  inside.leave = std::min(inside.leave, (-b + std::sqrt(root)) / a);
  if (enter > inside.enter) {
    inside.enter = enter;
    inside.normal = normalized((o + d * enter) * inverse_half);
  }
}

// Whether a ray surely passes by a ball. `direction` is a unit vector.
bool passes_by(Vec3 center, double radius, Vec3 origin, Vec3 direction) {
  constexpr double rounding_m = 1e-9;
  const Vec3 o = origin - center;
  const double along = dot(o, direction), r = radius + rounding_m;
  return dot(o, o) - along * along > r * r || along > r;
}

constexpr std::array<Vec3, 3> own_axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};

}  // namespace

GraspSurface::GraspSurface(const std::vector<assets::ContactPiece>& pieces) {
  for (const assets::ContactPiece& from : pieces) {
    Piece piece{
        from.shape, to_double(from.center), to_double(from.half_size), from.lying, {}, {}, 0};
    if (from.shape == assets::PieceShape::cylinder && from.lying)
      piece.half = {piece.half.z, piece.half.x, piece.half.x};
    for (const Vec3f& point : from.points)
      piece.points.push_back(to_double(point));
    for (const auto& [a, b, c] : convex_hull(from.points).triangles) {
      const Vec3 n =
          normalized(cross(piece.points[b] - piece.points[a], piece.points[c] - piece.points[a]));
      piece.faces.push_back({n, dot(n, piece.points[a])});
    }
    piece.radius = length(piece.half);
    for (const Vec3& point : piece.points)
      piece.radius = std::max(piece.radius, length(point - piece.center));
    for (const Vec3 axis : own_axes) {
      const Vec3 high = axis * reach(piece, axis), low = -axis * reach(piece, -axis);
      const Vec3 keep = Vec3{1, 1, 1} - axis;
      bounds_.include(to_float(piece.center * keep + high));
      bounds_.include(to_float(piece.center * keep + low));
    }
    pieces_.push_back(std::move(piece));
  }
}

// How far the piece reaches along a unit direction, from the product's origin.
double GraspSurface::reach(const Piece& piece, Vec3 d) {
  const Vec3& h = piece.half;
  const double middle = dot(piece.center, d);
  switch (piece.shape) {
    case assets::PieceShape::box:
      return middle + h.x * std::abs(d.x) + h.y * std::abs(d.y) + h.z * std::abs(d.z);
    case assets::PieceShape::cylinder:
      return piece.lying ? middle + h.x * std::abs(d.x) + h.y * std::hypot(d.y, d.z)
                         : middle + h.z * std::abs(d.z) + h.x * std::hypot(d.x, d.y);
    case assets::PieceShape::ellipsoid:
      return middle + length(h * d);
    default: {
      double most = -std::numeric_limits<double>::infinity();
      for (const Vec3& point : piece.points)
        most = std::max(most, dot(point, d));
      return most;
    }
  }
}

std::optional<SurfaceHit> GraspSurface::hit(const Piece& piece, Vec3 origin, Vec3 direction) {
  Inside inside;
  const Vec3& h = piece.half;
  const auto slab = [&](Vec3 axis, double half) {
    const double middle = dot(piece.center, axis);
    inside.clip(axis, middle + half, origin, direction);
    inside.clip(-axis, half - middle, origin, direction);
  };
  switch (piece.shape) {
    case assets::PieceShape::box:
      slab({1, 0, 0}, h.x);
      slab({0, 1, 0}, h.y);
      slab({0, 0, 1}, h.z);
      break;
    case assets::PieceShape::cylinder:
      if (piece.lying) {
        slab({1, 0, 0}, h.x);
        clip_round(inside, piece.center, {0, 1 / h.y, 1 / h.z}, origin, direction);
      } else {
        slab({0, 0, 1}, h.z);
        clip_round(inside, piece.center, {1 / h.x, 1 / h.y, 0}, origin, direction);
      }
      break;
    case assets::PieceShape::ellipsoid:
      clip_round(inside, piece.center, {1 / h.x, 1 / h.y, 1 / h.z}, origin, direction);
      break;
    default:
      for (const Face& face : piece.faces) {
        inside.clip(face.normal, face.offset, origin, direction);
        if (!(inside.enter < inside.leave)) return std::nullopt;
      }
  }
  if (!(inside.enter < inside.leave) || inside.enter < 0) return std::nullopt;
  return SurfaceHit{inside.enter, inside.normal};
}

std::optional<SurfaceHit> GraspSurface::first_hit(Vec3 origin, Vec3 direction) const {
  std::optional<SurfaceHit> first;
  for (const Piece& piece : pieces_) {
    if (passes_by(piece.center, piece.radius, origin, direction)) continue;
    const std::optional<SurfaceHit> found = hit(piece, origin, direction);
    if (found && (!first || found->distance_m < first->distance_m)) first = found;
  }
  return first;
}

std::optional<PadContact> GraspSurface::pad_contact(
    Vec3 middle, Vec3 travel, Vec3 x, Vec3 z, double half_x, double half_z) const {
  struct Sample {
    Vec3 at;
    SurfaceHit hit;
  };
  std::vector<Sample> samples;
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < pad_samples; ++i) {
    for (int k = 0; k < pad_samples; ++k) {
      const auto side = [](int n) { return 2.0 * n / (pad_samples - 1) - 1; };
      const Vec3 from = middle + x * (half_x * side(i)) + z * (half_z * side(k));
      const std::optional<SurfaceHit> found = first_hit(from, travel);
      if (!found) continue;
      samples.push_back({from + travel * found->distance_m, *found});
      nearest = std::min(nearest, found->distance_m);
    }
  }
  if (samples.empty()) return std::nullopt;
  PadContact contact;
  contact.height_m = -nearest;
  std::erase_if(
      samples, [&](const Sample& sample) { return sample.hit.distance_m > nearest + pad_yield_m; });
  const auto touched = static_cast<double>(samples.size());
  for (const Sample& sample : samples) {
    contact.center += sample.at / touched;
    contact.normal += sample.hit.normal;
  }
  contact.normal = normalized(contact.normal);
  for (const Sample& sample : samples) {
    const Vec3 off = sample.at - contact.center;
    contact.spread_x_m += dot(off, x) * dot(off, x) / touched;
    contact.spread_z_m += dot(off, z) * dot(off, z) / touched;
  }
  contact.spread_x_m = std::sqrt(contact.spread_x_m);
  contact.spread_z_m = std::sqrt(contact.spread_z_m);
  contact.share = touched / (pad_samples * pad_samples);
  return contact;
}

std::optional<CupContact> GraspSurface::cup_contact(Vec3 origin,
                                                    Vec3 travel,
                                                    double radius_m) const {
  const std::optional<SurfaceHit> middle = first_hit(origin, travel);
  if (!middle) return std::nullopt;
  const Vec3 aside = std::abs(travel.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  const Vec3 x = normalized(cross(aside, travel)), y = cross(travel, x);
  CupContact contact;
  contact.center = origin + travel * middle->distance_m;
  Vec3 normals = middle->normal;
  double least = middle->distance_m, most = middle->distance_m;
  for (const double share : {1.0, 0.5}) {
    const int count = share == 1.0 ? lip_samples : lip_samples / 2;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * i / count;
      const Vec3 from = origin + (x * std::cos(angle) + y * std::sin(angle)) * (radius_m * share);
      const std::optional<SurfaceHit> found = first_hit(from, travel);
      const double at = found ? found->distance_m : std::numeric_limits<double>::infinity();
      least = std::min(least, at);
      most = std::max(most, at);
      if (found) normals += found->normal;
    }
  }
  contact.normal = normalized(normals);
  contact.unevenness_m = most - least;
  return contact;
}

double GraspSurface::TurnedBox::reach(Vec3 direction) const {
  return half.x * std::abs(dot(axes[0], direction)) + half.y * std::abs(dot(axes[1], direction)) +
         half.z * std::abs(dot(axes[2], direction));
}

double GraspSurface::gap(const Piece& piece, const TurnedBox& box, double enough_m) {
  double most = -std::numeric_limits<double>::infinity();
  // `d` looks from the piece, which reaches `out` along it, to the box. True when that is enough.
  const auto apart_along = [&](Vec3 d, double out) {
    most = std::max(most, dot(box.middle, d) - box.reach(d) - out);
    return most >= enough_m;
  };
  const auto apart = [&](Vec3 d) { return apart_along(d, reach(piece, d)); };
  const Vec3 to_box = box.middle - piece.center;
  const Vec3 ahead = normalized(to_box);
  if (length(ahead) > 0.5 && apart(ahead)) return most;
  // Primitives are alike on both sides: only the nearer one can look at the box.
  const bool both_sides = piece.shape == assets::PieceShape::hull;
  const auto apart_on_axis = [&](Vec3 axis) {
    const double side = dot(to_box, axis) < 0 ? -1.0 : 1.0;
    return apart(axis * side) || (both_sides && apart(axis * -side));
  };
  for (const Vec3 axis : own_axes) {
    if (apart_on_axis(axis)) return most;
  }
  for (const Vec3 axis : box.axes) {
    if (apart_on_axis(axis)) return most;
  }
  for (const Face& face : piece.faces) {
    if (apart_along(face.normal, face.offset)) return most;
  }
  if (piece.shape == assets::PieceShape::cylinder) {
    const Vec3 out =
        normalized(piece.lying ? Vec3{0, to_box.y, to_box.z} : Vec3{to_box.x, to_box.y, 0});
    if (length(out) > 0.5) apart(out);
  }
  return most;
}

double GraspSurface::gap_to_box(const Pose& product_from_box,
                                Vec3 half_size,
                                double enough_m) const {
  TurnedBox box{product_from_box.position, half_size, {}};
  for (std::size_t i = 0; i < 3; ++i)
    box.axes[i] = rotate(product_from_box.rotation, own_axes[i]);
  const double radius = length(half_size);
  double least = std::numeric_limits<double>::infinity();
  for (const Piece& piece : pieces_) {
    const double between_balls = length(box.middle - piece.center) - piece.radius - radius;
    if (between_balls >= std::min(least, enough_m))
      least = std::min(least, between_balls);
    else
      least = std::min(least, gap(piece, box, std::min(least, enough_m)));
  }
  return least;
}

}  // namespace marketgen::motion
