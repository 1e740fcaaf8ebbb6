#include "perception/camera_correction.h"

#include <array>
#include <cmath>
#include <cstddef>

#include <Eigen/Dense>

#include "perception/over_counter.h"

namespace marketgen::perception {
namespace {

// One sigma of how far off a camera may be; of a measured point; points of one picture err alike
// over so many pixels.
constexpr double camera_off_m = 0.004, camera_off_rad = 0.006, point_off_m = 0.003;
constexpr double alike_px = 49;
constexpr std::size_t taken_every_px = 3;
constexpr std::array level_gates_m{0.015, 0.008, 0.005};  // of points taken for the counter's
constexpr double round_basket_m = 0.09;
constexpr float pair_gate_m = 0.012F, min_pair_normals = 0.85F;
constexpr int pair_rounds = 8;
constexpr float min_upright = 0.9F;  // of a level surface's normal

// Solves for three small unknowns, of which the first `lengths` are metres, the others radians.
Eigen::Vector3d solved(Eigen::Matrix3d a, const Eigen::Vector3d& b, int lengths) {
  a /= alike_px * point_off_m * point_off_m;
  for (int i = 0; i < 3; ++i) {
    const double off = i < lengths ? camera_off_m : camera_off_rad;
    a(i, i) += 1 / (off * off);
  }
  return a.ldlt().solve(b / (alike_px * point_off_m * point_off_m));
}

bool is_beside_basket(Vec3 p, const agent::Workplace& place) {
  const Vec3 at = inverse(place.base_from_basket) * p;
  return std::abs(at.x) > place.inner_half.x + round_basket_m ||
         std::abs(at.y) > place.inner_half.y + round_basket_m;
}

// Raises and tilts what the view shows so that the counter is level at 0: base_from_base.
Pose levelled(const ViewCloud& cloud, const agent::Workplace& place) {
  const Vec3 pivot = place.base_from_basket.position;
  Eigen::Vector3d fit = Eigen::Vector3d::Zero();  // height over the pivot, slopes along x and y
  for (const double gate : level_gates_m) {
    Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < cloud.size(); i += taken_every_px) {
      if (!cloud.has(i) || cloud.normal(i).z < min_upright) continue;
      const Vec3 p = to_double(cloud.point(i));
      if (!place.counter.holds(p.x, p.y) || !is_beside_basket(p, place)) continue;
      const Eigen::Vector3d row(1, p.x - pivot.x, p.y - pivot.y);
      if (std::abs(p.z - row.dot(fit)) > gate) continue;
      a += row * row.transpose();
      b += row * p.z;
    }
    fit = solved(a, b, 1);
  }
  const Quaternion turn =
      rotation_about({0, 1, 0}, std::atan(fit[1])) * rotation_about({1, 0, 0}, -std::atan(fit[2]));
  const Vec3 about{pivot.x, pivot.y, 0};
  return {about - rotate(turn, about + Vec3{0, 0, fit[0]}), turn};
}

// How far `moved` must go over the counter to agree with `still`, about a pivot.
OverCounter agreement(const ViewCloud& still, const ViewCloud& moved, Vec3 pivot) {
  OverCounter way;
  for (int round = 0; round < pair_rounds; ++round) {
    const Pose pose = way.about(pivot);
    Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < moved.size(); i += taken_every_px) {
      const Vec3f own = moved.normal(i);
      if (dot(own, own) == 0) continue;
      const Vec3 p = pose * to_double(moved.point(i));
      const auto seen = still.project(to_float(p));
      if (!seen || !still.has(seen->pixel)) continue;
      const Vec3f normal = still.normal(seen->pixel);
      const Vec3f off = to_float(p) - still.point(seen->pixel);
      if (dot(normal, own) < min_pair_normals || length(off) > pair_gate_m) continue;
      const Vec3 n = to_double(normal);
      const Eigen::Vector3d row(n.x, n.y, (p.x - pivot.x) * n.y - (p.y - pivot.y) * n.x);
      a += row * row.transpose();
      b -= row * static_cast<double>(dot(off, normal));
    }
    // Measured from where it stands now; what holds it back is how far it is from the beginning.
    const Eigen::Vector3d so_far(way.x_m, way.y_m, way.turn_rad);
    const Eigen::Vector3d whole = solved(a, b + a * so_far, 2);
    way = {whole[0], whole[1], whole[2]};
  }
  return way;
}

}  // namespace

void correct_cameras(std::vector<ViewCloud>& views, const agent::Workplace& place) {
  for (ViewCloud& view : views)
    view.move(levelled(view, place));
  const Vec3 pivot = place.base_from_basket.position;
  // Against the first; then all go back by the mean of how far they came.
  std::vector<OverCounter> ways(views.size());
  OverCounter back;
  for (std::size_t v = 1; v < views.size(); ++v) {
    ways[v] = agreement(views[0], views[v], pivot);
    back = back + ways[v] * (-1.0 / static_cast<double>(views.size()));
  }
  for (std::size_t v = 0; v < views.size(); ++v)
    views[v].move((ways[v] + back).about(pivot));
}

}  // namespace marketgen::perception
