#include "perception/grasp_source.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <unordered_set>

namespace marketgen {
namespace {

constexpr std::size_t most_grasps = 48;
constexpr double open_on_each_side_m = 0.005;
constexpr double firmness = 2, least_grip_n = 30, most_grip_n = 60;  // as the oracle's
// Where the open hand is looked at on its way: so far back.
constexpr std::array hand_back_m{0.0, 0.015, 0.03, 0.05, 0.08, 0.12};
constexpr float own_m = 0.007F;          // points so near to a product are its own
constexpr float least_x_m = 0.2F;        // before the arm's own body
constexpr std::size_t stray_points = 2;  // that do not count

// ---- Weights of the score, as the oracle's: room, straight down, near the middle of mass.
constexpr double most_room_m = 0.015;
constexpr double of_room = 1000, of_tilt_deg = 0.2, of_offset = 250;

double tilt_from_down_deg(const Quaternion& base_from_tip) {
  const Vec3 ahead = rotate(base_from_tip, {0, 0, 1});
  return std::acos(std::clamp(-ahead.z, -1.0, 1.0)) * 180 / std::numbers::pi;
}

// Depths of points within a box, station axes; those outside are left out.
void add_depths(const Pose& base_from_box,
                Vec3 half,
                const std::vector<Vec3f>& points,
                std::vector<double>& depths) {
  const Pose box_from_base = inverse(base_from_box);
  const double reach = length(half);
  for (const Vec3f& point : points) {
    const Vec3 p = to_double(point);
    if (length(p - base_from_box.position) > reach) continue;
    const Vec3 at = box_from_base * p;
    const double depth =
        std::min({half.x - std::abs(at.x), half.y - std::abs(at.y), half.z - std::abs(at.z)});
    if (depth > 0) depths.push_back(depth);
  }
}

// Those in a box, along the tool's axes, round its solids there and on their way.
std::vector<Vec3f> points_near(const Pose& base_from_tip,
                               const std::vector<ToolSolid>& solids,
                               const std::vector<Vec3f>& points) {
  Vec3 low{1e9, 1e9, 1e9}, high = -low;
  for (const ToolSolid& solid : solids) {
    const Vec3 at = solid.tool_from_solid.position;
    const double reach = length(solid.half_size);
    low = {std::min(low.x, at.x - reach),
           std::min(low.y, at.y - reach),
           std::min(low.z, at.z - reach - hand_back_m.back())};
    high = {std::max(high.x, at.x + reach),
            std::max(high.y, at.y + reach),
            std::max(high.z, at.z + reach)};
  }
  const Matrix34 m = matrix_of(inverse(base_from_tip));
  std::vector<Vec3f> near;
  for (const Vec3f& p : points) {
    const auto along = [&](int row) {
      return m.m[row][0] * p.x + m.m[row][1] * p.y + m.m[row][2] * p.z + m.m[row][3];
    };
    const double x = along(0), y = along(1), z = along(2);
    if (x > low.x && x < high.x && y > low.y && y < high.y && z > low.z && z < high.z)
      near.push_back(p);
  }
  return near;
}

}  // namespace

double hand_intrusion(const GraspTool& tool,
                      const Pose& base_from_tip,
                      double opening_m,
                      const std::vector<Vec3f>& points) {
  std::vector<ToolSolid> solids = opened(tool, opening_m);
  solids.insert(solids.end(), tool.body.begin(), tool.body.end());
  const std::vector<Vec3f> near = points_near(base_from_tip, solids, points);
  double most = 0;
  std::vector<double> depths;
  for (const double back : hand_back_m) {
    const Pose tip = base_from_tip * Pose{{0, 0, -back}, {}};
    for (const ToolSolid& solid : solids) {
      depths.clear();
      add_depths(tip * solid.tool_from_solid, solid.half_size, near, depths);
      if (depths.size() <= stray_points) continue;
      std::ranges::nth_element(
          depths, depths.begin() + static_cast<std::ptrdiff_t>(stray_points), std::greater<>{});
      most = std::max(most, depths[stray_points]);
    }
  }
  return most;
}

std::vector<Vec3f> thinned_points(const std::vector<ViewCloud>& views,
                                  double spacing_m,
                                  double most_z) {
  std::vector<Vec3f> kept;
  std::unordered_set<std::uint64_t> taken;
  const auto cell = [&](float v) {
    return static_cast<std::uint64_t>(std::lround(static_cast<double>(v) / spacing_m) + (1 << 20)) &
           0x1fffff;
  };
  for (const ViewCloud& cloud : views) {
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      if (!cloud.has(i)) continue;
      const Vec3f p = cloud.point(i);
      if (p.x < least_x_m || static_cast<double>(p.z) > most_z || p.z < -0.05F) continue;
      if (taken.insert((cell(p.x) << 42) | (cell(p.y) << 21) | cell(p.z)).second) kept.push_back(p);
    }
  }
  return kept;
}

std::vector<Vec3f> other_points(const std::vector<Vec3f>& points,
                                const ProductLook& look,
                                const Pose& base_from_product) {
  const Pose product_from_base = inverse(base_from_product);
  std::vector<Vec3f> others;
  for (const Vec3f& point : points) {
    const Vec3f at = to_float(product_from_base * to_double(point));
    const int nearest = look.nearest(at);
    if (nearest >= 0) {
      const Surfel& surfel = look.surfels()[static_cast<std::size_t>(nearest)];
      const Vec3f off = at - surfel.point;
      if (length(off) < own_m || dot(off, surfel.normal) < 0) continue;
    }
    others.push_back(point);
  }
  return others;
}

Result<std::vector<SeenGrasp>> FittedGrasps::grasps(const GraspQuestion& question) const {
  const Vec3 middle = question.base_from_product * to_double(question.known.body.center_of_mass);
  const Vec3 in_basket = inverse(question.base_from_basket) * middle;
  const bool inside =
      std::abs(in_basket.x) < place_.inner_half.x && std::abs(in_basket.y) < place_.inner_half.y;
  GraspQuery query;
  query.friction = question.known.pad_friction;
  query.finger_gap_m = open_on_each_side_m;
  query.most = most_grasps;
  query.from_above = true;
  query.world_from_product = question.base_from_product;
  const double floor = inside ? question.base_from_basket.position.z : 0.0;
  query.world_from_product.position.z -= floor;
  for (const auto* boxes : {&place_.walls, &place_.ledges}) {
    for (const WorkBox& box : *boxes) {
      query.walls.push_back({question.base_from_basket * box.pose, box.half_size});
      query.walls.back().world_from_box.position.z -= floor;
    }
  }
  MARKETGEN_TRY(const GraspCandidates candidates,
                grasp_candidates(question.known.product, question.known.body, tool_, query));
  std::vector<SeenGrasp> grasps;
  for (const GraspCandidate& candidate : candidates.found) {
    SeenGrasp grasp;
    grasp.base_from_tip = question.base_from_product * candidate.grasp.product_from_tool;
    grasp.opening_m = candidate.grasp.opening_m;
    grasp.force_n = std::clamp(candidate.grasp.force_n * firmness, least_grip_n, most_grip_n);
    grasp.width_m = candidate.width_m;
    grasp.intrusion_m =
        hand_intrusion(tool_, grasp.base_from_tip, grasp.opening_m, question.others);
    grasp.score = of_room * (std::min(candidate.clearance_m, most_room_m) -
                             1.5 * std::min(grasp.intrusion_m, 2 * most_room_m)) -
                  of_tilt_deg * tilt_from_down_deg(grasp.base_from_tip.rotation) -
                  of_offset * length(grasp.base_from_tip.position - middle);
    grasps.push_back(grasp);
  }
  std::ranges::stable_sort(grasps, std::greater<>{}, &SeenGrasp::score);
  return grasps;
}

}  // namespace marketgen
