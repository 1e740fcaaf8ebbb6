// Obstacles as they are given -> the packed form that the kernels read.
#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "geometry/convex_hull.h"
#include "motion/collision_world.h"
#include "motion/lanes.h"

namespace marketgen::motion {
namespace {

constexpr double farthest_m = 10'000;
constexpr std::size_t max_points = 5'000'000;
constexpr float cloud_cell_m = 0.03F;  // about the radius of a finger's sphere
constexpr double max_cells = 4e6;
constexpr float nowhere = 1e15F;  // farther than anything, and its square still a float

bool near_enough(Vec3 v) {  // false for NaN
  return std::abs(v.x) <= farthest_m && std::abs(v.y) <= farthest_m && std::abs(v.z) <= farthest_m;
}
bool valid(const Pose& pose) {
  const Quaternion& q = pose.rotation;
  const double norm = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
  return near_enough(pose.position) && std::abs(norm - 1) < 1e-6;
}
bool valid_size(double size) {
  return size > 0 && size <= farthest_m;
}

Error bad(const char* list, std::size_t row, const std::string& message) {
  return {"motion.bad_obstacle", fmt::format("{}/{}", list, row), message};
}

Result<void> check(const Obstacles& obstacles) {
  constexpr const char* bad_pose = "the pose is not finite, beyond 10 km or not a unit quaternion";
  constexpr const char* bad_size = "a size is not positive and finite";
  for (std::size_t i = 0; i < obstacles.boxes.size(); ++i) {
    const BoxObstacle& box = obstacles.boxes[i];
    if (!valid(box.pose)) return bad("boxes", i, bad_pose);
    for (const double half : {box.half_size.x, box.half_size.y, box.half_size.z})
      if (!valid_size(half)) return bad("boxes", i, bad_size);
  }
  for (std::size_t i = 0; i < obstacles.cylinders.size(); ++i) {
    const CylinderObstacle& cylinder = obstacles.cylinders[i];
    if (!valid(cylinder.pose)) return bad("cylinders", i, bad_pose);
    if (!valid_size(cylinder.radius) || !valid_size(cylinder.half_length))
      return bad("cylinders", i, bad_size);
  }
  for (std::size_t i = 0; i < obstacles.convex.size(); ++i) {
    if (!valid(obstacles.convex[i].pose)) return bad("convex", i, bad_pose);
    for (const Vec3f& p : obstacles.convex[i].points)
      if (!near_enough(to_double(p))) return bad("convex", i, "a point is not finite");
  }
  for (std::size_t i = 0; i < obstacles.clouds.size(); ++i) {
    const CloudObstacle& cloud = obstacles.clouds[i];
    if (!valid_size(cloud.radius)) return bad("clouds", i, bad_size);
    if (cloud.points.size() > max_points)
      return bad("clouds", i, fmt::format("more than {} points; thin it out", max_points));
    for (const Vec3f& p : cloud.points)
      if (!near_enough(to_double(p))) return bad("clouds", i, "a point is not finite");
  }
  return {};
}

// Half extents of a rotated box along the frame's axes.
Vec3 reach_of(const Pose& pose, Vec3 half) {
  const Matrix34 m = matrix_of(pose);
  const auto along = [&](int row) {
    return std::abs(m.m[row][0]) * half.x + std::abs(m.m[row][1]) * half.y +
           std::abs(m.m[row][2]) * half.z;
  };
  return {along(0), along(1), along(2)};
}

// Unit normals of the faces, and of planes that lean evenly on every edge and corner.
std::vector<Vec3> supporting_normals(const std::vector<Vec3>& points, const ConvexHull& hull) {
  std::vector<Vec3> normals;
  std::map<std::uint32_t, Vec3> at_corner;
  std::map<std::pair<std::uint32_t, std::uint32_t>, Vec3> at_edge;
  for (const auto& t : hull.triangles) {
    const Vec3 n = normalized(cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]));
    if (length(n) == 0) continue;
    normals.push_back(n);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      const Vec3 to_b = points[b] - points[a], to_c = points[t[(k + 2) % 3]] - points[a];
      const double angle = std::atan2(length(cross(to_b, to_c)), dot(to_b, to_c));
      at_corner[a] += n * angle;
      at_edge[std::minmax(a, b)] += n;
    }
  }
  for (const auto& [edge, n] : at_edge)
    normals.push_back(normalized(n));
  for (const auto& [corner, n] : at_corner)
    normals.push_back(normalized(n));
  std::vector<Vec3> distinct;
  for (const Vec3& n : normals) {
    const auto same = [&](const Vec3& other) { return dot(n, other) > 1 - 1e-9; };
    if (length(n) > 0 && std::none_of(distinct.begin(), distinct.end(), same))
      distinct.push_back(n);
  }
  return distinct;
}

}  // namespace

CollisionWorld::Frame CollisionWorld::frame_of(const Pose& pose) {
  const Matrix34 m = matrix_of(inverse(pose));
  Frame frame{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column)
      frame.rotation[3 * row + column] = static_cast<float>(m.m[row][column]);
    frame.offset[row] = static_cast<float>(m.m[row][3]);
  }
  return frame;
}

// Bounds are a hair larger than the shape: rounding to float must not lose a touch.
void CollisionWorld::add(
    Kind kind, std::size_t index, Vec3 low, Vec3 high, const char* list, std::size_t row) {
  constexpr double hair = 1e-4;
  shapes_.push_back({kind, static_cast<std::uint32_t>(index)});
  names_.push_back(fmt::format("{}/{}", list, row));
  const double lows[3] = {low.x, low.y, low.z}, highs[3] = {high.x, high.y, high.z};
  for (std::size_t k = 0; k < 3; ++k) {
    low_[k].push_back(static_cast<float>(lows[k] - hair));
    high_[k].push_back(static_cast<float>(highs[k] + hair));
  }
}

void CollisionWorld::add_box(const BoxObstacle& box, std::size_t row) {
  const Vec3 half = box.half_size, reach = reach_of(box.pose, half);
  boxes_.push_back(
      {frame_of(box.pose),
       {static_cast<float>(half.x), static_cast<float>(half.y), static_cast<float>(half.z)}});
  const Vec3 at = box.pose.position;
  add(Kind::box, boxes_.size() - 1, at - reach, at + reach, "boxes", row);
}

void CollisionWorld::add_cylinder(const CylinderObstacle& cylinder, std::size_t row) {
  const Vec3 reach =
      reach_of(cylinder.pose, {cylinder.radius, cylinder.radius, cylinder.half_length});
  cylinders_.push_back({frame_of(cylinder.pose),
                        static_cast<float>(cylinder.radius),
                        static_cast<float>(cylinder.half_length)});
  const Vec3 at = cylinder.pose.position;
  add(Kind::cylinder, cylinders_.size() - 1, at - reach, at + reach, "cylinders", row);
}

Result<void> CollisionWorld::add_convex(const ConvexObstacle& convex, std::size_t row) {
  const ConvexHull hull = convex_hull(convex.points);
  if (hull.triangles.empty()) return bad("convex", row, "the points have no volume");
  std::vector<Vec3> points;
  Vec3 low{1e30, 1e30, 1e30}, high{-1e30, -1e30, -1e30};
  for (const Vec3f& p : convex.points) {
    const Vec3 at = convex.pose * to_double(p);
    points.push_back(at);
    low = {std::min(low.x, at.x), std::min(low.y, at.y), std::min(low.z, at.z)};
    high = {std::max(high.x, at.x), std::max(high.y, at.y), std::max(high.z, at.z)};
  }
  Convex made;
  for (const Vec3& n : supporting_normals(points, hull)) {
    double offset = -1e30;
    for (const Vec3& p : points)
      offset = std::max(offset, dot(n, p));
    made.planes.push_back({static_cast<float>(n.x),
                           static_cast<float>(n.y),
                           static_cast<float>(n.z),
                           static_cast<float>(offset)});
  }
  convex_.push_back(std::move(made));
  add(Kind::convex, convex_.size() - 1, low, high, "convex", row);
  return {};
}

void CollisionWorld::add_cloud(const CloudObstacle& cloud, std::size_t row) {
  if (cloud.points.empty()) return;
  Cloud made{cloud_cell_m, static_cast<float>(cloud.radius), {}, {}, {}, {}, {}, {}};
  std::array<float, 3> high{};
  const auto axis_of = [](const Vec3f& p) { return std::array<float, 3>{p.x, p.y, p.z}; };
  made.low = high = axis_of(cloud.points.front());
  for (const Vec3f& p : cloud.points) {
    for (std::size_t k = 0; k < 3; ++k) {
      made.low[k] = std::min(made.low[k], axis_of(p)[k]);
      high[k] = std::max(high[k], axis_of(p)[k]);
    }
  }
  const auto cells_along = [&](std::size_t k) { return (high[k] - made.low[k]) / made.cell + 1.0; };
  while (cells_along(0) * cells_along(1) * cells_along(2) > max_cells)
    made.cell *= 2;
  for (std::size_t k = 0; k < 3; ++k)
    made.cells[k] = static_cast<int>(cells_along(k));
  const auto cell_of = [&](const Vec3f& p) {
    const std::array<float, 3> at = axis_of(p);
    std::array<int, 3> c{};
    for (std::size_t k = 0; k < 3; ++k) {
      c[k] = std::min(static_cast<int>((at[k] - made.low[k]) / made.cell), made.cells[k] - 1);
    }
    return static_cast<std::uint32_t>((c[2] * made.cells[1] + c[1]) * made.cells[0] + c[0]);
  };
  std::vector<std::pair<std::uint32_t, std::uint32_t>> order;
  for (std::uint32_t i = 0; i < cloud.points.size(); ++i)
    order.emplace_back(cell_of(cloud.points[i]), i);
  std::sort(order.begin(), order.end());
  made.first.assign(static_cast<std::size_t>(made.cells[0] * made.cells[1] * made.cells[2]) + 1, 0);
  for (const auto& [cell, point] : order) {
    ++made.first[cell + 1];
    made.x.push_back(cloud.points[point].x);
    made.y.push_back(cloud.points[point].y);
    made.z.push_back(cloud.points[point].z);
  }
  for (std::size_t i = 1; i < made.first.size(); ++i)
    made.first[i] += made.first[i - 1];
  for (std::vector<float>* values : {&made.x, &made.y, &made.z})
    values->resize(values->size() + lane_count, nowhere);
  const Vec3 margin{cloud.radius, cloud.radius, cloud.radius};
  const Vec3 low{made.low[0], made.low[1], made.low[2]}, top{high[0], high[1], high[2]};
  clouds_.push_back(std::move(made));
  add(Kind::cloud, clouds_.size() - 1, low - margin, top + margin, "clouds", row);
}

void CollisionWorld::close() {
  const std::size_t padded = (size() + lane_count - 1) / lane_count * lane_count;
  for (std::size_t k = 0; k < 3; ++k) {
    low_[k].resize(padded, nowhere);
    high_[k].resize(padded, nowhere);
  }
}

Result<CollisionWorld> CollisionWorld::make(const Obstacles& obstacles) {
  MARKETGEN_CHECK(check(obstacles));
  CollisionWorld world;
  for (std::size_t i = 0; i < obstacles.boxes.size(); ++i)
    world.add_box(obstacles.boxes[i], i);
  for (std::size_t i = 0; i < obstacles.cylinders.size(); ++i)
    world.add_cylinder(obstacles.cylinders[i], i);
  for (std::size_t i = 0; i < obstacles.convex.size(); ++i) {
    MARKETGEN_CHECK(world.add_convex(obstacles.convex[i], i));
  }
  for (std::size_t i = 0; i < obstacles.clouds.size(); ++i)
    world.add_cloud(obstacles.clouds[i], i);
  world.close();
  return world;
}

}  // namespace marketgen::motion
