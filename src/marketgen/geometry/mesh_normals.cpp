// Smooth normals with creases: a corner takes the mean of the triangles around its point that turn
// away by less than the crease angle, weighted by area so that a bevel does not bend the shading of
// the large face beside it.
#include <numeric>
#include <span>
#include <utility>

#include "geometry/mesh.h"
#include "geometry/weld.h"

namespace marketgen {
inline namespace geometry {
namespace {

struct FaceNormals {
  std::vector<Vec3> scaled;  // length = twice the triangle's area
  std::vector<Vec3> unit;
};

FaceNormals face_normals(const Mesh& mesh) {
  FaceNormals faces;
  faces.scaled.reserve(mesh.triangles.size());
  faces.unit.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    const Vec3 a = to_double(mesh.positions[t[0]]);
    const Vec3 n = cross(to_double(mesh.positions[t[1]]) - a, to_double(mesh.positions[t[2]]) - a);
    faces.scaled.push_back(n);
    faces.unit.push_back(normalized(n));
  }
  return faces;
}

// The triangles around each welded point, one list after another.
struct TrianglesAtPoints {
  std::vector<std::uint32_t> first;  // of each point's list; one more entry than points
  std::vector<std::uint32_t> triangles;

  std::span<const std::uint32_t> at(std::uint32_t point) const {
    return std::span(triangles).subspan(first[point], first[point + 1] - first[point]);
  }
};

TrianglesAtPoints triangles_at_points(const Mesh& mesh, const std::vector<std::uint32_t>& welded) {
  TrianglesAtPoints around;
  around.first.assign(mesh.positions.size() + 1, 0);
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle)
      ++around.first[welded[vertex] + 1];
  }
  std::partial_sum(around.first.begin(), around.first.end(), around.first.begin());
  std::vector<std::uint32_t> end(around.first.begin(), around.first.end() - 1);
  around.triangles.resize(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t vertex : mesh.triangles[t])
      around.triangles[end[welded[vertex]]++] = t;
  }
  return around;
}

Vec3f corner_normal(const FaceNormals& faces,
                    std::uint32_t triangle,
                    std::span<const std::uint32_t> around,
                    double crease_cos) {
  Vec3 sum{};
  for (const std::uint32_t other : around) {
    if (other == triangle || dot(faces.unit[other], faces.unit[triangle]) >= crease_cos) {
      sum += faces.scaled[other];
    }
  }
  return to_float(normalized(sum));
}

// The mesh under construction. Each old vertex has become some new ones that differ by their
// normals; they are chained in the order in which they were made.
class CreasedMesh {
 public:
  explicit CreasedMesh(const Mesh& source)
      : source_(source), first_(source.positions.size(), none) {}

  std::uint32_t vertex_with_normal(std::uint32_t vertex, Vec3f normal) {
    std::uint32_t* link = &first_[vertex];
    while (*link != none) {
      if (dot(mesh.normals[*link], normal) > 0.9999F) return *link;
      link = &next_[*link];
    }
    const std::uint32_t made =
        mesh.add_vertex(source_.positions[vertex], normal, source_.uvs[vertex]);
    *link = made;
    next_.push_back(none);
    return made;
  }

  Mesh mesh;

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFF;
  const Mesh& source_;
  std::vector<std::uint32_t> first_;  // of an old vertex
  std::vector<std::uint32_t> next_;   // of a new one
};

}  // namespace

void recompute_normals(Mesh& mesh, float crease_cos) {
  const std::vector<std::uint32_t> welded = weld_positions(mesh.positions, weld_distance_m);
  const FaceNormals faces = face_normals(mesh);
  const TrianglesAtPoints around = triangles_at_points(mesh, welded);
  CreasedMesh smooth(mesh);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t vertex = mesh.triangles[t][i];
      const Vec3f normal = corner_normal(faces, t, around.at(welded[vertex]), crease_cos);
      corners[i] = smooth.vertex_with_normal(vertex, normal);
    }
    smooth.mesh.add_triangle(corners[0], corners[1], corners[2], mesh.surfaces[t]);
  }
  mesh = std::move(smooth.mesh);
}

}  // namespace geometry
}  // namespace marketgen
