#include "catalog/heap.h"

#include <cmath>

namespace marketgen::catalog {
namespace {

constexpr std::size_t numbers_a_piece = 7;
constexpr double length_unit_m = 1e-4, rotation_unit = 1e-4;

Pose pose_of(const int* n) {
  Quaternion q{
      n[3] * rotation_unit, n[4] * rotation_unit, n[5] * rotation_unit, n[6] * rotation_unit};
  const double norm = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  if (norm < 0.5) return {{}, {}};
  q = {q.w / norm, q.x / norm, q.y / norm, q.z / norm};
  return {{n[0] * length_unit_m, n[1] * length_unit_m, n[2] * length_unit_m}, q};
}

int units(double value, double unit) {
  return static_cast<int>(std::lround(value / unit));
}

}  // namespace

std::vector<HeapPiece> pieces_of(const HeapRow& row) {
  if (row.poses.size() % numbers_a_piece != 0) return {};
  std::vector<HeapPiece> pieces(row.poses.size() / numbers_a_piece);
  std::size_t at = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    pieces[i].pose = pose_of(&row.poses[i * numbers_a_piece]);
    if (at >= row.supports.size()) return {};
    for (int left = row.supports[at++]; left > 0; --left) {
      if (at >= row.supports.size()) return {};
      const int below = row.supports[at++];
      if (below < 0 || static_cast<std::size_t>(below) >= i) return {};
      pieces[i].lies_on.push_back(static_cast<std::uint32_t>(below));
    }
  }
  return at == row.supports.size() ? pieces : std::vector<HeapPiece>{};
}

HeapRow heap_row(const std::string& archetype,
                 const std::array<int, 3>& size_mm,
                 const std::array<int, 2>& footprint_mm,
                 const std::vector<HeapPiece>& pieces) {
  HeapRow row{archetype, size_mm, footprint_mm[0], footprint_mm[1], {}, {}};
  for (const HeapPiece& piece : pieces) {
    for (const double v : {piece.pose.position.x, piece.pose.position.y, piece.pose.position.z})
      row.poses.push_back(units(v, length_unit_m));
    const Quaternion& q = piece.pose.rotation;
    for (const double v : {q.w, q.x, q.y, q.z})
      row.poses.push_back(units(v, rotation_unit));
    row.supports.push_back(static_cast<int>(piece.lies_on.size()));
    row.supports.insert(row.supports.end(), piece.lies_on.begin(), piece.lies_on.end());
  }
  return row;
}

}  // namespace marketgen::catalog
