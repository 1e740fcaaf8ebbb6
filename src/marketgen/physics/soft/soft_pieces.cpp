#include "physics/soft/soft_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace marketgen::physics {
namespace {

constexpr int cylinder_sides = 16;
constexpr double min_piece_m = 0.001;  // MuJoCo refuses flat meshes
constexpr double endless = std::numeric_limits<double>::max();

// Unit, from the base towards the flap.
Vec3 along_pack(const SoftPack& pack) {
  const Vec3 way = pack.parts[1].center - pack.parts[0].center;
  return way / length(way);
}

PieceCorners corners_of(const assets::ContactPiece& piece) {
  PieceCorners corners;
  if (piece.shape == assets::PieceShape::hull) {
    for (const Vec3f& point : piece.points)
      corners.push_back(to_double(point));
    return corners;
  }
  const Vec3 center = to_double(piece.center), half = to_double(piece.half_size);
  const bool box = piece.shape == assets::PieceShape::box;
  for (const double end : {-1.0, 1.0}) {
    for (int i = 0; i < (box ? 4 : cylinder_sides); ++i) {
      const double turn = 2 * std::numbers::pi * i / cylinder_sides;
      const Vec3 round{half.x * std::cos(turn), half.y * std::sin(turn), end * half.z};
      const Vec3 square{
          (i % 2 != 0 ? 1 : -1) * half.x, (i / 2 != 0 ? 1 : -1) * half.y, end * half.z};
      const Vec3 lying{round.z, round.y, -round.x};  // Z onto X
      corners.push_back(center + (box ? square : piece.lying ? lying : round));
    }
  }
  return corners;
}

// What of a convex piece lies where `dot(way, point)` is at most `most`.
PieceCorners cut(const PieceCorners& corners, Vec3 way, double most) {
  PieceCorners kept;
  for (const Vec3& a : corners) {
    const double at_a = dot(way, a);
    if (at_a > most) continue;
    kept.push_back(a);
    for (const Vec3& b : corners) {
      const double at_b = dot(way, b);
      if (at_b > most) kept.push_back(a + (b - a) * ((most - at_a) / (at_b - at_a)));
    }
  }
  return kept;
}

bool long_enough(const PieceCorners& corners, Vec3 way) {
  double least = endless, most = -endless;
  for (const Vec3& corner : corners)
    least = std::min(least, dot(way, corner)), most = std::max(most, dot(way, corner));
  return most - least >= min_piece_m;
}

}  // namespace

std::array<std::vector<PieceCorners>, SoftPack::part_count> cut_at_hinges(
    const assets::ProductBody& body, const SoftPack& pack, Vec3 middle) {
  const Vec3 way = along_pack(pack);
  const std::array<double, SoftPack::part_count + 1> ends{
      -endless, dot(way, pack.hinges[0].at), dot(way, pack.hinges[1].at), endless};
  std::array<std::vector<PieceCorners>, SoftPack::part_count> parts;
  for (const assets::ContactPiece& piece : body.pieces) {
    PieceCorners corners = corners_of(piece);
    for (Vec3& corner : corners)
      corner = corner - middle;
    for (std::size_t part = 0; part < parts.size(); ++part) {
      const PieceCorners kept = cut(cut(corners, way, ends[part + 1]), -way, -ends[part]);
      if (long_enough(kept, way)) parts[part].push_back(kept);
    }
  }
  return parts;
}

int part_at(const SoftPack& pack, Vec3 point) {
  const Vec3 way = along_pack(pack);
  const double at = dot(way, point);
  return at > dot(way, pack.hinges[1].at) ? 2 : at > dot(way, pack.hinges[0].at) ? 1 : 0;
}

Pose bent_part(const SoftPack& pack, int part, const std::array<double, 2>& angles_rad) {
  Pose bent;
  for (std::size_t i = 0; i < static_cast<std::size_t>(part); ++i) {
    const SoftHinge& hinge = pack.hinges[i];
    bent = bent * Pose{hinge.at, rotation_about(hinge.axis, angles_rad[i])} * Pose{-hinge.at, {}};
  }
  return bent;
}

}  // namespace marketgen::physics
