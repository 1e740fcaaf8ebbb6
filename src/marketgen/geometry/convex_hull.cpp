// The incremental algorithm: begin with a tetrahedron; each further point outside replaces the
// faces it sees by a fan over their rim.
#include "geometry/convex_hull.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace marketgen {
inline namespace geometry {
namespace {

constexpr double shift_share = 2e-7;  // of the extent: moves points out of common planes
constexpr double flat_share = 1e-6;   // of the extent: a thinner set is flat

struct Face {
  std::array<std::uint32_t, 3> corners;
  Vec3 normal;  // outwards, not unit
  double offset;
  double inverse_length;  // of the normal
};

// -1..1, the same for the same index and axis.
double shift_of(std::uint32_t index, std::uint32_t axis) {
  std::uint32_t h = (3 * index + axis + 1) * 2654435761U;
  h ^= h >> 15;
  h *= 2246822519U;
  h ^= h >> 13;
  return static_cast<double>(h) / std::numeric_limits<std::uint32_t>::max() * 2 - 1;
}

class Builder {
 public:
  explicit Builder(const std::vector<Vec3f>& points) {
    Vec3 low{1e30, 1e30, 1e30}, high{-1e30, -1e30, -1e30};
    for (const Vec3f p : points) {
      low = {
          std::min<double>(low.x, p.x), std::min<double>(low.y, p.y), std::min<double>(low.z, p.z)};
      high = {std::max<double>(high.x, p.x),
              std::max<double>(high.y, p.y),
              std::max<double>(high.z, p.z)};
    }
    extent_ = points.empty() ? 0 : std::max({high.x - low.x, high.y - low.y, high.z - low.z});
    const double shift = shift_share * extent_;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      points_.push_back(to_double(points[i]) - low +
                        Vec3{shift_of(i, 0), shift_of(i, 1), shift_of(i, 2)} * shift);
    }
  }

  ConvexHull build() {
    ConvexHull hull;
    if (!begin()) return hull;
    for (std::uint32_t p = 0; p < points_.size(); ++p)
      add(p);
    for (const Face& face : faces_) {
      hull.triangles.push_back(face.corners);
      const auto& [a, b, c] = face.corners;
      hull.volume += dot(points_[a], cross(points_[b], points_[c])) / 6;
    }
    return hull;
  }

  // Adds the farthest point again and again.
  std::vector<std::uint32_t> choose(std::size_t most) {
    if (!begin()) return {};
    std::vector<std::uint32_t> chosen = first_;
    while (chosen.size() < most) {
      const std::uint32_t next = farthest([&](Vec3 p) { return height_over_faces(p); });
      if (height_over_faces(points_[next]) < flat_share * extent_) break;
      add(next);
      chosen.push_back(next);
    }
    std::sort(chosen.begin(), chosen.end());
    return chosen;
  }

 private:
  // How far a point lies outside.
  double height_over_faces(Vec3 p) const {
    double most = 0;
    for (const Face& face : faces_)
      most = std::max(most, (dot(face.normal, p) - face.offset) * face.inverse_length);
    return most;
  }

  // The point for which `measure` is greatest.
  template <class Measure>
  std::uint32_t farthest(const Measure& measure) const {
    std::uint32_t best = 0;
    double most = -1;
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      const double value = measure(points_[i]);
      if (value > most) most = value, best = i;
    }
    return best;
  }

  // A first tetrahedron of far points; false when there is none.
  bool begin() {
    if (points_.size() < 4) return false;
    const Vec3 first = points_[0];
    const std::uint32_t a = farthest([&](Vec3 p) { return length(p - first); });
    const Vec3 pa = points_[a];
    const std::uint32_t b = farthest([&](Vec3 p) { return length(p - pa); });
    const Vec3 line = normalized(points_[b] - pa);
    const std::uint32_t c = farthest([&](Vec3 p) { return length(cross(p - pa, line)); });
    const Vec3 plane = normalized(cross(line, points_[c] - pa));
    const std::uint32_t d = farthest([&](Vec3 p) { return std::abs(dot(p - pa, plane)); });
    const double rise = dot(points_[d] - pa, plane);
    if (!(std::abs(rise) > flat_share * extent_)) return false;
    const std::array<std::uint32_t, 4> v =
        rise < 0 ? std::array{a, b, c, d} : std::array{a, c, b, d};
    first_ = {a, b, c, d};
    add_face(v[0], v[1], v[2]);
    add_face(v[0], v[3], v[1]);
    add_face(v[1], v[3], v[2]);
    add_face(v[2], v[3], v[0]);
    return true;
  }

  void add_face(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Vec3 normal = cross(points_[b] - points_[a], points_[c] - points_[a]);
    const double length_of_normal = length(normal);
    faces_.push_back({{a, b, c},
                      normal,
                      dot(normal, points_[a]),
                      length_of_normal > 0 ? 1 / length_of_normal : 0.0});
  }

  void add(std::uint32_t p) {
    const Vec3 at = points_[p];
    rim_.clear();
    std::size_t kept = 0;
    for (const Face& face : faces_) {
      const bool own = face.corners[0] == p || face.corners[1] == p || face.corners[2] == p;
      if (own || dot(face.normal, at) <= face.offset) {
        faces_[kept++] = face;
        continue;
      }
      for (std::size_t i = 0; i < 3; ++i)
        add_rim_edge(face.corners[i], face.corners[(i + 1) % 3]);
    }
    faces_.resize(kept);
    for (const auto& [a, b] : rim_)
      add_face(a, b, p);
  }

  // An edge between two faces that are seen is none of the rim: it comes twice, once each way.
  void add_rim_edge(std::uint32_t a, std::uint32_t b) {
    const auto twin = std::find(rim_.begin(), rim_.end(), std::array{b, a});
    if (twin == rim_.end()) {
      rim_.push_back({a, b});
    } else {
      *twin = rim_.back();
      rim_.pop_back();
    }
  }

  std::vector<Vec3> points_;  // from the lowest corner, shifted
  std::vector<Face> faces_;
  std::vector<std::array<std::uint32_t, 2>> rim_;
  std::vector<std::uint32_t> first_;  // of the tetrahedron
  double extent_ = 0;
};

}  // namespace

ConvexHull convex_hull(const std::vector<Vec3f>& points) {
  return Builder(points).build();
}

std::vector<std::uint32_t> hull_points(const std::vector<Vec3f>& points, std::size_t most) {
  return Builder(points).choose(most);
}

}  // namespace geometry
}  // namespace marketgen
