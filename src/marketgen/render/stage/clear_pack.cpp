#include "render/stage/clear_pack.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace marketgen::render::raytrace {
namespace {

// Of the height from the pack's foot to where the clear wall ends below its closure: bottles are
// filled into the neck.
constexpr float fill_share = 0.9F;
// Colours are cut to this range before their absorption is taken: nothing is quite black or clear.
constexpr float darkest_liquid = 0.015F, clearest_liquid = 0.985F;

bool is_clear(const assets::ProductModel& model, std::uint16_t surface) {
  return model.surfaces[surface].refraction > 0;
}

float fill_height(const assets::ProductModel& model) {
  float low = 1e30F, high = -1e30F;
  for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
    for (const std::uint32_t v : model.mesh.triangles[t]) {
      const float z = model.mesh.positions[v].z;
      low = std::min(low, z);
      if (is_clear(model, model.mesh.surfaces[t])) high = std::max(high, z);
    }
  }
  return low + fill_share * (high - low);
}

// Cuts triangles at a height.
class Cutter {
 public:
  Cutter(const Mesh& from, float height, ClearPack& to) : from_(from), height_(height), to_(to) {
    to_.mesh.positions = from.positions;
    to_.mesh.normals = from.normals;
    to_.mesh.uvs = from.uvs;
  }

  // Adds triangle `t`: what lies below the height as `low`, the rest as `high`.
  void add(std::size_t t, std::uint16_t low, std::uint16_t high) {
    const std::array<std::uint32_t, 3>& corners = from_.triangles[t];
    std::vector<std::uint32_t> below, above, cut;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = corners[i], b = corners[(i + 1) % 3];
      (is_low(a) ? below : above).push_back(a);
      if (is_low(a) == is_low(b)) continue;
      const std::uint32_t middle = between(a, b);
      below.push_back(middle);
      above.push_back(middle);
      cut.push_back(middle);
    }
    if (cut.size() == 2) rim_.push_back({cut[0], cut[1]});
    if (low == high) {
      to_.mesh.add_triangle(corners[0], corners[1], corners[2], low);
      return;
    }
    add_fan(below, low);
    add_fan(above, high);
  }

  // Closes the cut with a level surface that faces up.
  void close(std::uint16_t surface) {
    Vec3f middle;
    for (const auto& [a, b] : rim_)
      middle += to_.mesh.positions[a] + to_.mesh.positions[b];
    middle = middle / std::max(2.0F * static_cast<float>(rim_.size()), 1.0F);
    middle.z = height_;
    const Vec3f up{0, 0, 1};
    const std::uint32_t center = to_.mesh.add_vertex(middle, up, {});
    for (const auto& [a, b] : rim_) {
      const Vec3f p = to_.mesh.positions[a], q = to_.mesh.positions[b];
      std::uint32_t first = to_.mesh.add_vertex(p, up, {}), second = to_.mesh.add_vertex(q, up, {});
      if (cross(p - middle, q - middle).z < 0) std::swap(first, second);
      to_.mesh.add_triangle(center, first, second, surface);
    }
  }

 private:
  bool is_low(std::uint32_t vertex) const { return from_.positions[vertex].z < height_; }

  std::uint32_t between(std::uint32_t a, std::uint32_t b) {
    const float za = from_.positions[a].z, zb = from_.positions[b].z;
    const float share = (height_ - za) / (zb - za);
    const auto part = [&](const auto& values) {
      return values[a] * (1 - share) + values[b] * share;
    };
    Vec3f cut = part(from_.positions);
    cut.z = height_;  // exactly, so that the surface is level
    return to_.mesh.add_vertex(cut, normalized(part(from_.normals)), part(from_.uvs));
  }

  void add_fan(const std::vector<std::uint32_t>& polygon, std::uint16_t surface) {
    for (std::size_t i = 2; i < polygon.size(); ++i)
      to_.mesh.add_triangle(polygon[0], polygon[i - 1], polygon[i], surface);
  }

  const Mesh& from_;
  float height_;
  ClearPack& to_;
  std::vector<std::array<std::uint32_t, 2>> rim_;
};

float absorption_per_m(float left, float depth_m) {
  return -std::log(std::clamp(left, darkest_liquid, clearest_liquid)) / (2 * depth_m);
}

}  // namespace

bool is_clear_pack(const assets::ProductModel& model) {
  return std::any_of(
      model.surfaces.begin(), model.surfaces.end(), [](const marketgen::assets::Surface& surface) {
        return surface.refraction > 0;
      });
}

ClearMaterials clear_materials(const marketgen::assets::Surface& surface,
                               const Material& look,
                               float depth_m) {
  ClearMaterials made{look, look};
  made.liquid.clear = made.sheet.clear = true;
  made.liquid.refraction = surface.refraction;
  made.liquid.absorption_per_m = {absorption_per_m(surface.color.x, depth_m),
                                  absorption_per_m(surface.color.y, depth_m),
                                  absorption_per_m(surface.color.z, depth_m)};
  return made;
}

ClearPack clear_pack(const assets::ProductModel& model) {
  ClearPack pack;
  const auto count = static_cast<std::uint16_t>(model.surfaces.size());
  pack.surface_count = count;
  std::uint16_t liquid = 0;
  for (std::uint16_t k = 0; k < count; ++k) {
    pack.sheet_of.push_back(k);
    if (!is_clear(model, k)) continue;
    liquid = k;
    pack.sheet_of[k] = pack.surface_count++;
  }
  Cutter cutter(model.mesh, fill_height(model), pack);
  for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
    const std::uint16_t surface = model.mesh.surfaces[t];
    cutter.add(t, surface, pack.sheet_of[surface]);
  }
  pack.outline_triangles = pack.mesh.triangles.size();
  cutter.close(liquid);
  return pack;
}

}  // namespace marketgen::render::raytrace
