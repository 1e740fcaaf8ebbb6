#include "assets/contents.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "assets/materials/material_texture.h"
#include "assets/print/color.h"

namespace marketgen::assets {
namespace {

// A clear wall with nothing behind it, from afar: it shows the grey of what stands around.
constexpr Vec3f empty_wall_color{0.46F, 0.48F, 0.47F};
// What the pattern of pieces has on average of both colours, its shading and the shadows between
// pieces taken off: fitted over all rows, within 0.02.
constexpr float mean_between = 0.27F, mean_of_pieces = 0.50F;

Result<Vec3f> color_in(const catalog::Product& product,
                       const std::string& text,
                       std::string_view name) {
  Result<Vec3f> color = linear_from_hex(text);
  if (color.ok()) return color;
  return Error{
      color.error().code, fmt::format("{}/contents/{}", product.sku, name), color.error().message};
}

// The mesh again, each triangle cut where it crosses the level.
class Parting {
 public:
  Parting(const ProductModel& from, float level) : from_(from.mesh), level_(level) {
    to_.positions = from_.positions;
    to_.normals = from_.normals;
    to_.uvs = from_.uvs;
  }

  // Adds triangle `t`: what lies below the level as `low`, the rest as `high`.
  void add(std::size_t t, std::uint16_t low, std::uint16_t high) {
    const std::array<std::uint32_t, 3>& corners = from_.triangles[t];
    std::vector<std::uint32_t> below, above;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = corners[i], b = corners[(i + 1) % 3];
      (is_low(a) ? below : above).push_back(a);
      if (is_low(a) == is_low(b)) continue;
      const std::uint32_t middle = between(a, b);
      below.push_back(middle);
      above.push_back(middle);
    }
    add_fan(below, low);
    add_fan(above, high);
  }

  Mesh take() { return std::move(to_); }

 private:
  bool is_low(std::uint32_t vertex) const { return from_.positions[vertex].z < level_; }

  // The same to the bit for either direction, so that neighbours stay joined.
  std::uint32_t between(std::uint32_t a, std::uint32_t b) {
    const auto key = [&](std::uint32_t v) {
      const Vec3f& p = from_.positions[v];
      return std::tuple(p.z, p.x, p.y);
    };
    if (key(b) < key(a)) std::swap(a, b);
    const float za = from_.positions[a].z, zb = from_.positions[b].z;
    const float share = (level_ - za) / (zb - za);
    const auto part = [&](const auto& values) {
      return values[a] * (1 - share) + values[b] * share;
    };
    Vec3f cut = part(from_.positions);
    cut.z = level_;  // exactly, so that the surface is level
    return to_.add_vertex(cut, normalized(part(from_.normals)), part(from_.uvs));
  }

  void add_fan(const std::vector<std::uint32_t>& polygon, std::uint16_t surface) {
    for (std::size_t i = 2; i < polygon.size(); ++i)
      to_.add_triangle(polygon[0], polygon[i - 1], polygon[i], surface);
  }

  const Mesh& from_;
  float level_;
  Mesh to_;
};

bool holds(const Surface& surface) {
  return surface.fill > 0;
}

float level_of(const ProductModel& model) {
  float low = 1e30F, high = -1e30F, fill = 0;
  for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
    const Surface& surface = model.surfaces[model.mesh.surfaces[t]];
    if (!holds(surface)) continue;
    fill = surface.fill;
    for (const std::uint32_t v : model.mesh.triangles[t]) {
      low = std::min(low, model.mesh.positions[v].z);
      high = std::max(high, model.mesh.positions[v].z);
    }
  }
  return fill == 0 ? 0 : low + fill * (high - low);
}

// UVs of pieces: whole repeats around the pack, and upwards as many to the metre.
void tile_pieces(ProductModel& model, const catalog::Product& product) {
  const auto extent = static_cast<float>(material_extent_m(contents_material(*product.contents)));
  const auto around =
      static_cast<float>(std::numbers::pi * (product.width_m() + product.depth_m()) / 2);
  const float repeats = std::max(1.0F, std::round(around / extent));
  Mesh& mesh = model.mesh;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (model.surfaces[mesh.surfaces[t]].texture != "contents") continue;
    for (std::uint32_t& v : mesh.triangles[t])
      v = mesh.add_vertex(mesh.positions[v],
                          mesh.normals[v],
                          {mesh.uvs[v].x * repeats, mesh.positions[v].z / extent});
  }
}

}  // namespace

Result<Surface> contents_wall(const catalog::Product& product, float roughness, Surface otherwise) {
  if (!product.contents) return otherwise;
  const catalog::Contents& contents = *product.contents;
  Surface wall{.roughness = roughness, .fill = static_cast<float>(contents.fill)};
  MARKETGEN_TRY(wall.color, color_in(product, contents.color, "color"));
  if (contents.opacity == catalog::Opacity::clear)
    wall.refraction = static_cast<float>(contents.refraction);
  if (contents.particle_mm > 0) {
    MARKETGEN_TRY(const Vec3f pieces, color_in(product, contents.particle_color, "particle_color"));
    wall.color = wall.color * mean_between + pieces * mean_of_pieces;
    wall.texture = "contents";
  }
  return wall;
}

catalog::MaterialRow contents_material(const catalog::Contents& contents) {
  catalog::MaterialRow row;
  row.id = fmt::format("contents-{}-{}-{}",
                       contents.color.substr(1),
                       contents.particle_color.substr(1),
                       contents.particle_mm);
  row.name = "contents";
  row.pattern = catalog::MaterialPattern::pieces;
  row.color = contents.particle_color;
  row.second_color = contents.color;
  row.period_mm = contents.particle_mm;
  row.roughness = 0.1;
  return row;
}

void part_at_level(ProductModel& model, const catalog::Product& product) {
  if (std::ranges::none_of(model.surfaces, holds)) return;
  model.level_m = level_of(model);
  const auto count = static_cast<std::uint16_t>(model.surfaces.size());
  const auto first = std::ranges::find_if(model.surfaces, holds);
  model.surfaces.push_back(
      {.color = empty_wall_color, .roughness = first->roughness, .empty = true});
  Parting parting(model, model.level_m);
  for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
    const std::uint16_t surface = model.mesh.surfaces[t];
    parting.add(t, surface, holds(model.surfaces[surface]) ? count : surface);
  }
  model.mesh = parting.take();
  if (product.contents && product.contents->particle_mm > 0) tile_pieces(model, product);
}

}  // namespace marketgen::assets
