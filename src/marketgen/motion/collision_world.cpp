#include "motion/collision_world.h"

#include <bit>
#include <utility>

#include "motion/lanes.h"

namespace marketgen::motion {
namespace {

struct LanePoint {
  Lanes x, y, z;
};

template <class Frame>
LanePoint local(const Frame& frame, const SphereBlock& block) {
  const Lanes x = load(block.x), y = load(block.y), z = load(block.z);
  const auto row = [&](std::size_t i) {
    const float* r = &frame.rotation[3 * i];
    return Lanes(r[0]) * x + Lanes(r[1]) * y + Lanes(r[2]) * z + Lanes(frame.offset[i]);
  };
  return {row(0), row(1), row(2)};
}

// How far a coordinate lies beyond +-half, at least 0.
Lanes beyond(Lanes coordinate, float half) {
  return xsimd::max(xsimd::abs(coordinate) - Lanes(half), Lanes(0.0F));
}

}  // namespace

std::vector<SphereBlock> packed(std::span<const PlainSphere> spheres) {
  std::vector<SphereBlock> blocks((spheres.size() + lane_count - 1) / lane_count);
  for (std::size_t i = 0; i < blocks.size() * lane_count; ++i) {
    SphereBlock& block = blocks[i / lane_count];
    const std::size_t lane = i % lane_count;
    const PlainSphere& s = spheres[i < spheres.size() ? i : i - lane];
    block.x[lane] = static_cast<float>(s.center.x);
    block.y[lane] = static_cast<float>(s.center.y);
    block.z[lane] = static_cast<float>(s.center.z);
    block.radius[lane] = static_cast<float>(s.radius);
  }
  return blocks;
}

bool CollisionWorld::touches(const Box& box, const SphereBlock& block) {
  const LanePoint p = local(box.frame, block);
  const Lanes x = beyond(p.x, box.half[0]), y = beyond(p.y, box.half[1]);
  const Lanes z = beyond(p.z, box.half[2]), radius = load(block.radius);
  return xsimd::any(x * x + y * y + z * z < radius * radius);
}

bool CollisionWorld::touches(const Cylinder& cylinder, const SphereBlock& block) {
  const LanePoint p = local(cylinder.frame, block);
  const Lanes off_axis = xsimd::sqrt(p.x * p.x + p.y * p.y);
  const Lanes across = xsimd::max(off_axis - Lanes(cylinder.radius), Lanes(0.0F));
  const Lanes along = beyond(p.z, cylinder.half_length), radius = load(block.radius);
  return xsimd::any(across * across + along * along < radius * radius);
}

bool CollisionWorld::touches(const Convex& convex, const SphereBlock& block) {
  const Lanes x = load(block.x), y = load(block.y), z = load(block.z);
  Lanes outermost(-1e30F);
  for (const Plane& plane : convex.planes) {
    const Lanes off =
        Lanes(plane.x) * x + Lanes(plane.y) * y + Lanes(plane.z) * z - Lanes(plane.offset);
    outermost = xsimd::max(outermost, off);
  }
  return xsimd::any(outermost < load(block.radius));
}

bool CollisionWorld::touches(const Cloud& cloud, const SphereBlock& block) {
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    const std::array<float, 3> center{block.x[lane], block.y[lane], block.z[lane]};
    const float reach = block.radius[lane] + cloud.radius;
    std::array<int, 3> from{}, to{};
    for (std::size_t k = 0; k < 3; ++k) {
      const float top = static_cast<float>(cloud.cells[k] - 1);
      const float low = (center[k] - reach - cloud.low[k]) / cloud.cell;
      const float high = (center[k] + reach - cloud.low[k]) / cloud.cell;
      from[k] = static_cast<int>(std::fmin(std::fmax(low, 0.0F), top));
      to[k] = high < 0 ? -1 : static_cast<int>(std::fmin(high, top));
      if (low > top + 1) to[k] = -1;
    }
    const Lanes x(center[0]), y(center[1]), z(center[2]), reach2(reach * reach);
    for (int iz = from[2]; iz <= to[2]; ++iz) {
      for (int iy = from[1]; iy <= to[1] && to[0] >= 0; ++iy) {
        const int row = (iz * cloud.cells[1] + iy) * cloud.cells[0];
        const std::size_t end = cloud.first[static_cast<std::size_t>(row + to[0] + 1)];
        // Lanes past the end hold points of later cells: points too, so a hit is a hit.
        for (std::size_t i = cloud.first[static_cast<std::size_t>(row + from[0])]; i < end;
             i += lane_count) {
          const Lanes dx = Lanes::load_unaligned(&cloud.x[i]) - x;
          const Lanes dy = Lanes::load_unaligned(&cloud.y[i]) - y;
          const Lanes dz = Lanes::load_unaligned(&cloud.z[i]) - z;
          if (xsimd::any(dx * dx + dy * dy + dz * dz < reach2)) return true;
        }
      }
    }
  }
  return false;
}

bool CollisionWorld::touches(std::size_t shape, std::span<const SphereBlock> blocks) const {
  const std::uint32_t index = shapes_[shape].index;
  const auto any_block = [&](const auto& solid) {
    for (const SphereBlock& block : blocks) {
      if (touches(solid, block)) return true;
    }
    return false;
  };
  switch (shapes_[shape].kind) {
    case Kind::box:
      return any_block(boxes_[index]);
    case Kind::cylinder:
      return any_block(cylinders_[index]);
    case Kind::convex:
      return any_block(convex_[index]);
    case Kind::cloud:
      return any_block(clouds_[index]);
  }
  return false;
}

// Index of the first shape that is hit, size() when none is. Shapes whose bounds the bounding
// sphere does not reach are passed over, eight at a time.
std::size_t CollisionWorld::first_of(std::span<const SphereBlock> blocks,
                                     Vec3f center,
                                     float radius) const {
  const Lanes x(center.x), y(center.y), z(center.z), radius2(radius * radius), zero(0.0F);
  for (std::size_t i = 0; i < low_[0].size(); i += lane_count) {
    const auto off = [&](std::size_t axis, const Lanes& at) {
      return xsimd::max(xsimd::max(Lanes::load_unaligned(&low_[axis][i]) - at,
                                   at - Lanes::load_unaligned(&high_[axis][i])),
                        zero);
    };
    const Lanes dx = off(0, x), dy = off(1, y), dz = off(2, z);
    std::uint32_t near = bits_of(dx * dx + dy * dy + dz * dz < radius2);
    for (; near != 0; near &= near - 1) {
      const std::size_t shape = i + static_cast<std::size_t>(std::countr_zero(near));
      if (touches(shape, blocks)) return shape;
    }
  }
  return size();
}

void CollisionWorld::touched(const SphereBlock& bound, std::vector<std::uint32_t>& shapes) const {
  shapes.clear();
  const Lanes radius = load(bound.radius);
  const auto axis = [&](const std::array<float, lane_count>& values) {
    const Lanes at = load(values);
    return std::pair{Lanes(lowest(at - radius)), Lanes(highest(at + radius))};
  };
  const auto [low_x, high_x] = axis(bound.x);
  const auto [low_y, high_y] = axis(bound.y);
  const auto [low_z, high_z] = axis(bound.z);
  for (std::size_t i = 0; i < low_[0].size(); i += lane_count) {
    const auto overlaps = [&](std::size_t k, const Lanes& low, const Lanes& high) {
      return (Lanes::load_unaligned(&low_[k][i]) < high) &
             (low < Lanes::load_unaligned(&high_[k][i]));
    };
    std::uint32_t near = bits_of(overlaps(0, low_x, high_x) & overlaps(1, low_y, high_y) &
                                 overlaps(2, low_z, high_z));
    for (; near != 0; near &= near - 1) {
      const auto shape =
          static_cast<std::uint32_t>(i) + static_cast<std::uint32_t>(std::countr_zero(near));
      if (hits_shape(shape, bound)) shapes.push_back(shape);
    }
  }
}

bool CollisionWorld::hits_shape(std::uint32_t shape, const SphereBlock& block) const {
  return touches(shape, std::span(&block, 1));
}

bool CollisionWorld::hits(std::span<const SphereBlock> blocks, Vec3f center, float radius) const {
  return first_of(blocks, center, radius) < size();
}

std::string CollisionWorld::first_hit(std::span<const SphereBlock> blocks,
                                      Vec3f center,
                                      float radius) const {
  const std::size_t shape = first_of(blocks, center, radius);
  return shape < size() ? names_[shape] : std::string{};
}

}  // namespace marketgen::motion
