#include "geometry/mesh.h"

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/weld.h"

namespace marketgen {
inline namespace geometry {

void Bounds3::include(Vec3f p) {
  low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
}

std::uint32_t Mesh::add_vertex(Vec3f position, Vec3f normal, Vec2f uv) {
  positions.push_back(position);
  normals.push_back(normal);
  uvs.push_back(uv);
  return static_cast<std::uint32_t>(positions.size() - 1);
}

void Mesh::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint16_t surface) {
  triangles.push_back({a, b, c});
  surfaces.push_back(surface);
}

void Mesh::append(const Mesh& other) {
  const auto offset = static_cast<std::uint32_t>(positions.size());
  positions.insert(positions.end(), other.positions.begin(), other.positions.end());
  normals.insert(normals.end(), other.normals.begin(), other.normals.end());
  uvs.insert(uvs.end(), other.uvs.begin(), other.uvs.end());
  surfaces.insert(surfaces.end(), other.surfaces.begin(), other.surfaces.end());
  triangles.reserve(triangles.size() + other.triangles.size());
  for (const auto& t : other.triangles) {
    triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }
}

Bounds3 bounds_of(const Mesh& mesh) {
  Bounds3 bounds;
  for (const Vec3f p : mesh.positions)
    bounds.include(p);
  return bounds;
}

double volume_of(const Mesh& mesh) {
  double six_volumes = 0;  // of the tetrahedra from the origin to each triangle
  for (const auto& t : mesh.triangles) {
    const Vec3 a = to_double(mesh.positions[t[0]]);
    const Vec3 b = to_double(mesh.positions[t[1]]);
    const Vec3 c = to_double(mesh.positions[t[2]]);
    six_volumes += dot(a, cross(b, c));
  }
  return six_volumes / 6.0;
}

bool is_watertight(const Mesh& mesh, double weld_m) {
  const std::vector<std::uint32_t> welded = weld_positions(mesh.positions, weld_m);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;  // of each directed edge
  for (const auto& t : mesh.triangles) {
    const std::array<std::uint32_t, 3> w{welded[t[0]], welded[t[1]], welded[t[2]]};
    if (w[0] == w[1] || w[1] == w[2] || w[2] == w[0]) continue;  // welding closed it up
    for (std::size_t i = 0; i < 3; ++i)
      ++uses[{w[i], w[(i + 1) % 3]}];
  }
  const auto once_each_way = [&uses](const auto& edge) {
    const auto back = uses.find({edge.first.second, edge.first.first});
    return edge.second == 1 && back != uses.end();
  };
  return !uses.empty() && std::all_of(uses.begin(), uses.end(), once_each_way);
}

void translate(Mesh& mesh, Vec3f by) {
  for (Vec3f& p : mesh.positions)
    p += by;
}

void place(Mesh& mesh, const Pose& pose, std::size_t first) {
  for (std::size_t v = first; v < mesh.positions.size(); ++v) {
    mesh.positions[v] = to_float(pose * to_double(mesh.positions[v]));
    mesh.normals[v] = to_float(rotate(pose.rotation, to_double(mesh.normals[v])));
  }
}

}  // namespace geometry
}  // namespace marketgen
