#include "render/stage/clear_pack.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace marketgen::render::raytrace {
namespace {

// Colours are cut to this range before their absorption is taken: nothing is quite black or clear.
constexpr float darkest_liquid = 0.015F, clearest_liquid = 0.985F;

float absorption_per_m(float left, float depth_m) {
  return -std::log(std::clamp(left, darkest_liquid, clearest_liquid)) / (2 * depth_m);
}

using Edge = std::array<Vec3f, 2>;

// Where the skin meets the level: the upper edges of the triangles below it, which are cut there.
std::vector<Edge> edges_at(const Mesh& mesh, float level) {
  std::vector<Edge> edges;
  for (const std::array<std::uint32_t, 3>& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3f a = mesh.positions[triangle[i]], b = mesh.positions[triangle[(i + 1) % 3]];
      const bool below = mesh.positions[triangle[(i + 2) % 3]].z < level;
      if (a.z == level && b.z == level && below) edges.push_back({a, b});
    }
  }
  return edges;
}

}  // namespace

Material liquid_material(const marketgen::assets::Surface& surface,
                         Material material,
                         float depth_m) {
  material.clear = true;
  material.refraction = surface.refraction;
  material.absorption_per_m = {absorption_per_m(surface.color.x, depth_m),
                               absorption_per_m(surface.color.y, depth_m),
                               absorption_per_m(surface.color.z, depth_m)};
  return material;
}

Material sheet_material(Material material) {
  material.clear = true;
  return material;
}

Mesh with_level(const assets::ProductModel& model) {
  Mesh mesh = model.mesh;
  if (model.level_m <= 0) return mesh;
  const auto holds = [](const marketgen::assets::Surface& surface) { return surface.fill > 0; };
  const auto surface = static_cast<std::uint16_t>(std::ranges::find_if(model.surfaces, holds) -
                                                  model.surfaces.begin());
  const std::vector<Edge> edges = edges_at(model.mesh, model.level_m);
  Vec3f middle;
  for (const auto& [a, b] : edges)
    middle += a + b;
  middle = middle / std::max(2.0F * static_cast<float>(edges.size()), 1.0F);
  middle.z = model.level_m;
  const Vec3f up{0, 0, 1};
  const std::uint32_t center = mesh.add_vertex(middle, up, {});
  for (const auto& [a, b] : edges) {
    std::uint32_t first = mesh.add_vertex(a, up, {}), second = mesh.add_vertex(b, up, {});
    if (cross(a - middle, b - middle).z < 0) std::swap(first, second);
    mesh.add_triangle(center, first, second, surface);
  }
  return mesh;
}

}  // namespace marketgen::render::raytrace
