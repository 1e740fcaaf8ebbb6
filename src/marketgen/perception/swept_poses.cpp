#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Dense>

#include "perception/placed_surface.h"
#include "perception/pose_source.h"

namespace marketgen::perception {
namespace {

constexpr int directions = 72, turns = 18;  // ways round that are tried: about 20 degrees apart
constexpr std::size_t coarse_points = 50, fitted_points = 120;
constexpr std::size_t kept_coarse = 60, kept_fitted = 4;
constexpr float coarse_reach_m = 0.012F;
constexpr int fit_steps = 8;
constexpr float first_gate_m = 0.018F, last_gate_m = 0.006F;
constexpr float min_normals = 0.5F;  // cosine between a point's normal and its surfel's
constexpr double damping = 1e-3;     // of a fit in which a shape may slide along itself
constexpr std::size_t quick_surfels = 120, careful_surfels = 500;
constexpr float closely_covered_m = 0.003F;  // of the mask, in the last fit

// Directions spread evenly over the sphere (Fibonacci's lattice).
std::vector<Vec3> sphere_directions() {
  std::vector<Vec3> all;
  for (int i = 0; i < directions; ++i) {
    const double z = 1 - (2 * i + 1.0) / directions;
    const double r = std::sqrt(1 - z * z);
    const double angle = std::numbers::pi * (3 - std::sqrt(5.0)) * i;
    all.push_back({r * std::cos(angle), r * std::sin(angle), z});
  }
  return all;
}

Quaternion turn_between(Vec3 from, Vec3 to) {
  const double cosine = dot(from, to);
  if (cosine > 1 - 1e-9) return {};
  Vec3 axis = cross(from, to);
  if (cosine < -1 + 1e-9)
    axis = cross(from, std::abs(from.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0});
  return rotation_about(normalized(axis), std::acos(std::clamp(cosine, -1.0, 1.0)));
}

// Middle of what is seen of the product from a direction, product frame.
Vec3f middle_from(const ProductLook& look, Vec3f towards) {
  Vec3f sum;
  float weight = 0;
  for (const Surfel& surfel : look.surfels()) {
    const float facing = dot(surfel.normal, towards);
    if (facing < 0.1F) continue;
    sum += surfel.point * facing;
    weight += facing;
  }
  return weight > 0 ? sum / weight : look.middle();
}

// Mean distance of the patch from the product, each at most coarse_reach_m.
float coarse_distance(const ProductLook& look, const SurfacePatch& patch, const Pose& pose) {
  const Placed frame(inverse(pose));  // product frame
  const std::size_t step = std::max<std::size_t>(1, patch.points.size() / coarse_points);
  float sum = 0, count = 0;
  for (std::size_t i = 0; i < patch.points.size(); i += step, ++count) {
    const Vec3f q = frame(patch.points[i]);
    const int nearest = look.nearest(q);
    if (nearest < 0) {
      sum += coarse_reach_m;
      continue;
    }
    const Surfel& surfel = look.surfels()[static_cast<std::size_t>(nearest)];
    const bool faces = dot(surfel.normal, frame.turned(patch.normals[i])) > min_normals;
    sum += faces ? std::min(coarse_reach_m, length(surfel.point - q)) : coarse_reach_m;
  }
  return sum / count;
}

struct Guess {
  Pose pose;
  double cost = 0;
};

std::vector<Guess> coarse_guesses(const ProductLook& look, const SurfacePatch& patch) {
  static const std::vector<Vec3> all = sphere_directions();
  const Vec3 to_eye = to_double(patch.to_eye), middle = to_double(patch.middle);
  std::vector<Guess> guesses;
  for (const Vec3& direction : all) {
    const Quaternion facing = turn_between(direction, to_eye);
    const Vec3 seen = to_double(middle_from(look, to_float(direction)));
    for (int i = 0; i < turns; ++i) {
      const Quaternion turned = rotation_about(to_eye, 2 * std::numbers::pi * i / turns) * facing;
      const Pose pose{middle - rotate(turned, seen), turned};
      guesses.push_back({pose, static_cast<double>(coarse_distance(look, patch, pose))});
    }
  }
  const std::size_t kept = std::min(kept_coarse, guesses.size());
  std::ranges::partial_sort(
      guesses, guesses.begin() + static_cast<std::ptrdiff_t>(kept), {}, &Guess::cost);
  guesses.resize(kept);
  return guesses;
}

// One step of an iterative closest point fit, point to plane. False when too few points match.
bool fit_step(const ProductLook& look, const SurfacePatch& patch, float gate_m, Pose& pose) {
  const Placed frame(inverse(pose));  // product frame
  Eigen::Matrix<double, 6, 6> normal_matrix = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
  const Vec3f middle = look.middle();
  const auto scale = static_cast<double>(0.5F * look.diagonal_m());
  int matched = 0;
  const std::size_t step = std::max<std::size_t>(1, patch.points.size() / fitted_points);
  for (std::size_t i = 0; i < patch.points.size(); i += step) {
    const Vec3f q = frame(patch.points[i]);
    const int nearest = look.nearest(q);
    if (nearest < 0) continue;
    const Surfel& surfel = look.surfels()[static_cast<std::size_t>(nearest)];
    if (length(surfel.point - q) > gate_m) continue;
    if (dot(surfel.normal, frame.turned(patch.normals[i])) < min_normals) continue;
    const Vec3 n = to_double(surfel.normal), arm = to_double(q - middle);
    const Vec3 turning = cross(arm, n) / scale;
    Eigen::Matrix<double, 6, 1> row;
    row << turning.x, turning.y, turning.z, n.x, n.y, n.z;
    normal_matrix += row * row.transpose();
    right -= row * static_cast<double>(dot(q - surfel.point, surfel.normal));
    ++matched;
  }
  if (matched < 12) return false;
  normal_matrix.diagonal().array() += damping * matched;
  const Eigen::Matrix<double, 6, 1> moved = normal_matrix.ldlt().solve(right);
  const Vec3 turn = Vec3{moved[0], moved[1], moved[2]} / scale;
  const double angle = std::min(0.3, length(turn));
  // The patch moves so in the product's frame: the product moves the other way.
  const Quaternion turned =
      rotation_about(length(turn) > 0 ? normalized(turn) : Vec3{0, 0, 1}, angle);
  const Vec3 at = to_double(middle);
  const Pose step_pose{at - rotate(turned, at) + Vec3{moved[3], moved[4], moved[5]}, turned};
  pose = pose * inverse(step_pose);
  return true;
}

bool fit(const ProductLook& look, const SurfacePatch& patch, Pose& pose) {
  for (int i = 0; i < fit_steps; ++i) {
    const float share = static_cast<float>(i) / (fit_steps - 1);
    const float gate = first_gate_m + (last_gate_m - first_gate_m) * share;
    if (!fit_step(look, patch, gate, pose)) return false;
  }
  return true;
}

bool nearly_same(const Pose& a, const Pose& b) {
  constexpr double same_m = 0.006, same_half_turn = 0.12;  // 14 degrees
  const Quaternion turn = inverse(a.rotation) * b.rotation;
  return length(a.position - b.position) < same_m &&
         std::hypot(turn.x, turn.y, turn.z) < same_half_turn;
}

}  // namespace

SurfacePatch patch_of(const ViewCloud& cloud, const Mask& mask, std::size_t max_points) {
  SurfacePatch patch;
  const std::size_t step = std::max<std::size_t>(1, mask.pixels.size() / max_points);
  Vec3f low{1e9F, 1e9F, 1e9F}, high = -low;
  for (std::size_t i = 0; i < mask.pixels.size(); i += step) {
    const Vec3f p = cloud.point(mask.pixels[i]);
    patch.points.push_back(p);
    patch.normals.push_back(cloud.normal(mask.pixels[i]));
    patch.colors.push_back(cloud.color(mask.pixels[i]));
    patch.middle += p;
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  patch.middle = patch.middle / static_cast<float>(patch.points.size());
  patch.to_eye = normalized(cloud.eye() - patch.middle);
  patch.diagonal_m = length(high - low);
  return patch;
}

bool is_of_size(const SurfacePatch& patch, const ProductLook& look) {
  constexpr float size_slack = 1.1F, size_slack_m = 0.015F;
  return patch.diagonal_m <= look.diagonal_m() * size_slack + size_slack_m;
}

Vec3 middle_of(const ProductLook& look, const Pose& base_from_product) {
  return base_from_product * to_double(look.middle());
}

double lowest_z_m(const ProductLook& look, const Pose& base_from_product) {
  double lowest = std::numeric_limits<double>::max();
  for (const Surfel& surfel : look.surfels())
    lowest = std::min(lowest, (base_from_product * to_double(surfel.point)).z);
  return lowest;
}

namespace {

// The pose nearby that explains the pictures best, by what evidence_of() says closely: what else it
// bears lets surface that looks the same where it goes on slide along itself, under what hides it.
FittedPose refined_pose(const ProductLook& look,
                        const Pose& near,
                        const SurfacePatch& patch,
                        const std::vector<ViewCloud>& views) {
  const auto weigh = [&](const Pose& pose) {
    return evidence_of(look, pose, patch, views, careful_surfels, closely_covered_m);
  };
  FittedPose best{near, weigh(near)};
  const Vec3 middle = to_double(look.middle());
  for (double step_m = 0.006; step_m > 0.0007; step_m /= 2) {
    const double step_rad = step_m / (0.4 * static_cast<double>(look.diagonal_m()));
    for (int round = 0; round < 4; ++round) {
      const double before = best.evidence.score;
      for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
        for (const double sign : {1.0, -1.0}) {
          const Quaternion turned = rotation_about(axis, sign * step_rad);
          const std::array moves{Pose{axis * (sign * step_m), {}},
                                 Pose{middle - rotate(turned, middle), turned}};
          for (const Pose& move : moves) {
            const Pose pose = best.base_from_product * move;
            const PoseEvidence e = weigh(pose);
            if (e.score > best.evidence.score) best = {pose, e};
          }
        }
      }
      if (best.evidence.score < before * 1.002) break;
    }
  }
  // Products are told apart by what is borne else.
  best.evidence = evidence_of(look, best.base_from_product, patch, views, careful_surfels);
  return best;
}

}  // namespace

FittedPose SweptPoses::pose(const ProductLook& look,
                            const SurfacePatch& patch,
                            const std::vector<ViewCloud>& views) const {
  std::vector<FittedPose> fitted;
  for (const Guess& guess : coarse_guesses(look, patch)) {
    Pose pose = guess.pose;
    if (!fit(look, patch, pose)) continue;
    fitted.push_back({pose, evidence_of(look, pose, patch, views, quick_surfels)});
  }
  std::ranges::stable_sort(
      fitted, std::greater<>{}, [](const FittedPose& p) { return p.evidence.score; });
  FittedPose best;
  std::vector<Pose> begun;
  for (const FittedPose& guess : fitted) {
    const Pose& pose = guess.base_from_product;
    if (begun.size() >= kept_fitted || guess.evidence.score < 0.5 * best.evidence.score) break;
    if (std::ranges::any_of(begun, [&](const Pose& other) { return nearly_same(pose, other); }))
      continue;
    begun.push_back(pose);
    const FittedPose refined = refined_pose(look, pose, patch, views);
    if (refined.evidence.score > best.evidence.score) best = refined;
  }
  return best;
}

}  // namespace marketgen::perception
