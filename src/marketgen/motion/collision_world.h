// What an arm must not touch: boxes, cylinders, convex pieces and depth point clouds, tested eight
// spheres at a time.
//
// The robot is a set of spheres (as in VAMP; Thomason, Kingston, Kavraki, ICRA 2024). Tests are in
// single precision on eight lanes whatever the machine has, so results are the same everywhere;
// within 64 m of the origin a coordinate is exact to 4 micrometres. Boxes and cylinders are exact.
// A convex piece is the intersection of its face planes and of further planes that touch its edges
// and corners: never too small, and at a right-angled edge at most 0.09 radii too large. A point of
// a cloud is a ball.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "geometry/pose.h"

namespace marketgen::motion {

// Every pose and point is in one frame, the planner's: the world's or the robot base's. Metres.
struct BoxObstacle {
  Pose pose;  // of its middle
  Vec3 half_size;
};
struct CylinderObstacle {
  Pose pose;  // of its middle; the axis is Z
  double radius = 0, half_length = 0;
};
struct ConvexObstacle {
  Pose pose;
  std::vector<Vec3f> points;  // their hull counts; at least four, not in one plane
};
struct CloudObstacle {
  std::vector<Vec3f> points;
  double radius = 0.005;  // of each point
};
struct Obstacles {
  std::vector<BoxObstacle> boxes;
  std::vector<CylinderObstacle> cylinders;
  std::vector<ConvexObstacle> convex;
  std::vector<CloudObstacle> clouds;
};

// Eight spheres, lane by lane. Unused lanes repeat a used one.
struct alignas(32) SphereBlock {
  std::array<float, 8> x{}, y{}, z{}, radius{};
};
struct PlainSphere {
  Vec3 center;
  double radius = 0;
};
// Packs spheres eight to a block; the last block is filled up with its first sphere.
std::vector<SphereBlock> packed(std::span<const PlainSphere> spheres);

// Immutable after make(); any number of threads may ask.
class CollisionWorld {
 public:
  // Errors: motion.bad_obstacle for numbers that are not finite, sizes that are not positive, hulls
  // without volume, coordinates beyond 10 km or a cloud of more than 5 million points.
  static Result<CollisionWorld> make(const Obstacles& obstacles);

  // True when a sphere of `blocks` overlaps an obstacle. `center` and `radius` bound all of them.
  bool hits(std::span<const SphereBlock> blocks, Vec3f center, float radius) const;
  // The obstacle that is hit first: "boxes/3", "clouds/0"; empty when none is.
  std::string first_hit(std::span<const SphereBlock> blocks, Vec3f center, float radius) const;

  std::size_t size() const { return names_.size(); }

  // In two steps, for spheres that are the same one at eight moments: the shapes that a sphere of
  // `bound` overlaps, and whether a smaller block within them does. Replaces what `shapes` holds.
  void touched(const SphereBlock& bound, std::vector<std::uint32_t>& shapes) const;
  bool hits_shape(std::uint32_t shape, const SphereBlock& block) const;
  const std::string& name(std::uint32_t shape) const { return names_[shape]; }

 private:
  enum class Kind : std::uint8_t { box, cylinder, convex, cloud };
  struct Shape {
    Kind kind;
    std::uint32_t index;
  };
  struct Frame {  // obstacle_from_world, row by row
    std::array<float, 9> rotation;
    std::array<float, 3> offset;
  };
  struct Box {
    Frame frame;
    std::array<float, 3> half;
  };
  struct Cylinder {
    Frame frame;
    float radius, half_length;
  };
  struct Plane {
    float x, y, z, offset;  // outside where the sum is positive
  };
  struct Convex {
    std::vector<Plane> planes;
  };
  // Points sorted by cell, x fastest, so that the cells of a row lie side by side.
  struct Cloud {
    float cell, radius;
    std::array<float, 3> low;
    std::array<int, 3> cells;
    std::vector<std::uint32_t> first;
    std::vector<float> x, y, z;  // eight far points at the end
  };

  static Frame frame_of(const Pose& pose);
  static bool touches(const Box& box, const SphereBlock& block);
  static bool touches(const Cylinder& cylinder, const SphereBlock& block);
  static bool touches(const Convex& convex, const SphereBlock& block);
  static bool touches(const Cloud& cloud, const SphereBlock& block);
  bool touches(std::size_t shape, std::span<const SphereBlock> blocks) const;
  std::size_t first_of(std::span<const SphereBlock> blocks, Vec3f center, float radius) const;
  void add(Kind kind, std::size_t index, Vec3 low, Vec3 high, const char* list, std::size_t row);
  void add_box(const BoxObstacle& box, std::size_t row);
  void add_cylinder(const CylinderObstacle& cylinder, std::size_t row);
  Result<void> add_convex(const ConvexObstacle& convex, std::size_t row);
  void add_cloud(const CloudObstacle& cloud, std::size_t row);
  void close();

  std::vector<Box> boxes_;
  std::vector<Cylinder> cylinders_;
  std::vector<Convex> convex_;
  std::vector<Cloud> clouds_;
  std::vector<Shape> shapes_;
  std::vector<std::string> names_;
  std::array<std::vector<float>, 3> low_, high_;  // bounds of the shapes, filled up to eights
};

}  // namespace marketgen::motion
