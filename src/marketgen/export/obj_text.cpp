#include "export/obj_text.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "geometry/convex_hull.h"

namespace marketgen::exporters {

std::string obj_text(const Mesh& mesh) {
  std::string text;
  const auto add = [&](std::string_view key, auto... numbers) {
    text += key;
    ((text += fmt::format(" {:.6g}", numbers)), ...);
    text += '\n';
  };
  for (const Vec3f& p : mesh.positions)
    add("v", p.x, p.y, p.z);
  for (const Vec2f& uv : mesh.uvs)
    add("vt", uv.x, 1 - uv.y);
  for (const Vec3f& n : mesh.normals)
    add("vn", n.x, n.y, n.z);
  for (const auto& [a, b, c] : mesh.triangles)
    text += fmt::format("f {0}/{0}/{0} {1}/{1}/{1} {2}/{2}/{2}\n", a + 1, b + 1, c + 1);
  return text;
}

Mesh hull_mesh(const std::vector<Vec3f>& points) {
  Mesh mesh;
  for (const auto& triangle : convex_hull(points).triangles) {
    const Vec3f a = points[triangle[0]], b = points[triangle[1]], c = points[triangle[2]];
    const Vec3f across = cross(b - a, c - a);
    if (!(length(across) > 0)) continue;
    const Vec3f n = normalized(across);
    const std::uint32_t first = mesh.add_vertex(a, n, {});
    mesh.add_vertex(b, n, {});
    mesh.add_vertex(c, n, {});
    mesh.add_triangle(first, first + 1, first + 2, 0);
  }
  return mesh;
}

std::vector<Vec3f> ellipsoid_points(const Vec3& half) {
  constexpr int point_count = 64;
  std::vector<Vec3f> points;
  const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
  for (int i = 0; i < point_count; ++i) {
    const double z = 1 - (2 * i + 1.0) / point_count, r = std::sqrt(1 - z * z);
    points.push_back(to_float(
        Vec3{half.x * r * std::cos(turn * i), half.y * r * std::sin(turn * i), half.z * z}));
  }
  return points;
}

}  // namespace marketgen::exporters
