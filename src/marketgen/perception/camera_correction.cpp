#include "perception/camera_correction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <Eigen/Dense>

#include "perception/view_cloud.h"

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

using Normal3 = Eigen::Matrix3d;

// Solves for three small unknowns, of which the first `lengths` are metres, the others radians.
Eigen::Vector3d solved(Normal3 a, const Eigen::Vector3d& b, int lengths) {
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
    Normal3 a = Normal3::Zero();
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
struct OverCounter {
  double x_m = 0, y_m = 0, turn_rad = 0;
  Pose about(Vec3 pivot, double share) const {
    const Quaternion turn = rotation_about({0, 0, 1}, share * turn_rad);
    return {pivot - rotate(turn, pivot) + Vec3{share * x_m, share * y_m, 0}, turn};
  }
};

OverCounter agreement(const ViewCloud& still, const ViewCloud& moved, Vec3 pivot) {
  OverCounter way;
  for (int round = 0; round < pair_rounds; ++round) {
    const Pose pose = way.about(pivot, 1);
    Normal3 a = Normal3::Zero();
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

std::vector<agent::View> corrected_views(std::vector<agent::View> views,
                                         const agent::Workplace& place) {
  for (agent::View& view : views)
    view.base_from_camera = levelled(ViewCloud(view), place) * view.base_from_camera;
  std::vector<ViewCloud> clouds(views.begin(), views.end());
  const Vec3 pivot = place.base_from_basket.position;
  // Against the first; then all go back by the mean of how far they came.
  std::vector<OverCounter> ways(views.size());
  OverCounter mean;
  for (std::size_t v = 1; v < views.size(); ++v) {
    ways[v] = agreement(clouds[0], clouds[v], pivot);
    const auto count = static_cast<double>(views.size());
    mean.x_m += ways[v].x_m / count;
    mean.y_m += ways[v].y_m / count;
    mean.turn_rad += ways[v].turn_rad / count;
  }
  for (std::size_t v = 0; v < views.size(); ++v) {
    const OverCounter way{
        ways[v].x_m - mean.x_m, ways[v].y_m - mean.y_m, ways[v].turn_rad - mean.turn_rad};
    views[v].base_from_camera = way.about(pivot, 1) * views[v].base_from_camera;
  }
  return views;
}

}  // namespace marketgen::perception
