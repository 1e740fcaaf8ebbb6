#include "skills/hand_room.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace marketgen::skills {
namespace {

// Where the open hand is looked at on its way: so far back.
constexpr std::array on_the_way_m{0.0, 0.02, 0.04, 0.07, 0.1, 0.14};
constexpr std::size_t stray_points = 2;  // that do not count

// Depths of points within a box; those outside are left out.
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
                               const std::vector<robots::ToolSolid>& solids,
                               const std::vector<Vec3f>& points) {
  Vec3 low{1e9, 1e9, 1e9}, high = -low;
  for (const robots::ToolSolid& solid : solids) {
    const Vec3 at = solid.tool_from_solid.position;
    const double reach = length(solid.half_size);
    low = {std::min(low.x, at.x - reach),
           std::min(low.y, at.y - reach),
           std::min(low.z, at.z - reach - on_the_way_m.back())};
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

BasketWalls::BasketWalls(const agent::Workplace& place) {
  for (const auto* boxes : {&place.walls, &place.ledges}) {
    for (const agent::WorkBox& box : *boxes) {
      assets::ContactPiece piece;
      piece.half_size = to_float(box.half_size);
      surfaces_.emplace_back(std::vector{piece});
      basket_from_box_.push_back(box.pose);
    }
  }
}

std::vector<PlacedBody> BasketWalls::at(const Pose& base_from_basket) const {
  std::vector<PlacedBody> walls;
  for (std::size_t i = 0; i < surfaces_.size(); ++i)
    walls.push_back({&surfaces_[i], base_from_basket * basket_from_box_[i]});
  return walls;
}

std::vector<robots::ToolSolid> open_hand(const robots::GraspTool& tool, double opening_m) {
  std::vector<robots::ToolSolid> solids = robots::opened(tool, opening_m);
  solids.insert(solids.end(), tool.body.begin(), tool.body.end());
  return solids;
}

double box_overlap(const PlacedBody& body, const Pose& base_from_box, Vec3 half) {
  const Pose pose = inverse(body.base_from_body) * base_from_box;
  const Bounds3& bounds = body.surface->bounds();
  const double reach = length(half);
  const Vec3 low = to_double(bounds.low), high = to_double(bounds.high), at = pose.position;
  if (at.x < low.x - reach || at.x > high.x + reach || at.y < low.y - reach ||
      at.y > high.y + reach || at.z < low.z - reach || at.z > high.z + reach)
    return 0;
  return std::max(0.0, -body.surface->gap_to_box(pose, half, 0));
}

double hand_overlap(const std::vector<robots::ToolSolid>& hand,
                    const Pose& base_from_tip,
                    const PlacedBody& body) {
  double deepest = 0;
  for (const double back : on_the_way_m) {
    const Pose tip = base_from_tip * Pose{{0, 0, -back}, {}};
    for (const robots::ToolSolid& solid : hand)
      deepest = std::max(deepest, box_overlap(body, tip * solid.tool_from_solid, solid.half_size));
  }
  return deepest;
}

double hand_overlap(const std::vector<robots::ToolSolid>& hand,
                    const Pose& base_from_tip,
                    const std::vector<Vec3f>& points) {
  const std::vector<Vec3f> near = points_near(base_from_tip, hand, points);
  double deepest = 0;
  std::vector<double> depths;
  for (const double back : on_the_way_m) {
    const Pose tip = base_from_tip * Pose{{0, 0, -back}, {}};
    for (const robots::ToolSolid& solid : hand) {
      depths.clear();
      add_depths(tip * solid.tool_from_solid, solid.half_size, near, depths);
      if (depths.size() <= stray_points) continue;
      std::ranges::nth_element(
          depths, depths.begin() + static_cast<std::ptrdiff_t>(stray_points), std::greater<>{});
      deepest = std::max(deepest, depths[stray_points]);
    }
  }
  return deepest;
}

bool is_near(const std::vector<robots::ToolSolid>& hand,
             const Pose& base_from_tip,
             std::span<const PlacedBody> bodies,
             double gap_m) {
  return std::ranges::any_of(bodies, [&](const PlacedBody& body) {
    const Pose body_from_tip = inverse(body.base_from_body) * base_from_tip;
    return std::ranges::any_of(hand, [&](const robots::ToolSolid& solid) {
      return body.surface->gap_to_box(
                 body_from_tip * solid.tool_from_solid, solid.half_size, gap_m) < gap_m;
    });
  });
}

}  // namespace marketgen::skills
