#include "assets/shapes/archetypes/pack_builder.h"

#include <bit>
#include <cmath>
#include <utility>

#include "base/flat_index.h"

namespace marketgen::assets {
namespace {

// Closer corners count as one: half of the welding distance of is_watertight.
constexpr float collapsed_m = 5e-7F;

bool same_place(Vec3f a, Vec3f b) {
  return std::abs(a.x - b.x) < collapsed_m && std::abs(a.y - b.y) < collapsed_m &&
         std::abs(a.z - b.z) < collapsed_m;
}

using VertexKey = std::array<std::uint32_t, 5>;

std::uint32_t bits_of(float value) {
  return std::bit_cast<std::uint32_t>(value + 0.0F);
}  // -0 is 0

VertexKey key_of(const Corner& c) {
  return {bits_of(c.position.x),
          bits_of(c.position.y),
          bits_of(c.position.z),
          bits_of(c.uv.x),
          bits_of(c.uv.y)};
}

// Moves and stretches the mesh, and the features on it, so that its bounds are w x d x h, standing
// on z = 0 about the Z axis.
void fit_to_size(ProductModel& model, Vec3f size) {
  const Bounds3 bounds = marketgen::bounds_of(model.mesh);
  const Vec3f now = bounds.size();
  const Vec3f scale{size.x / now.x, size.y / now.y, size.z / now.z};
  const Vec3f foot{bounds.center().x, bounds.center().y, bounds.low.z};
  for (Vec3f& p : model.mesh.positions)
    p = (p - foot) * scale;
  for (PackFeature& feature : model.features) {
    feature.center = (feature.center - foot) * scale;
    feature.half_size = feature.half_size * scale;
  }
}

float along_axis(Vec3f p, PackAxis axis) {
  return axis == PackAxis::x ? p.x : axis == PackAxis::y ? p.y : p.z;
}

// Includes what of the edge from a to b lies between two places along the axis.
void include_between(Bounds3& bounds, Vec3f a, Vec3f b, float low, float high, PackAxis axis) {
  if (along_axis(a, axis) > along_axis(b, axis)) std::swap(a, b);
  const float start = along_axis(a, axis), end = along_axis(b, axis);
  if (end < low || start > high) return;
  const auto at = [&](float place) { return a + (b - a) * ((place - start) / (end - start)); };
  bounds.include(start < low ? at(low) : a);
  bounds.include(end > high ? at(high) : b);
}

}  // namespace

PackBuilder::PackBuilder(const catalog::Product& product, std::vector<Panel> panels)
    : size_{static_cast<float>(product.width_m()),
            static_cast<float>(product.depth_m()),
            static_cast<float>(product.height_m())},
      panels_(std::move(panels)) {}

std::uint16_t PackBuilder::add_surface(Surface surface) {
  surfaces_.push_back(std::move(surface));
  return static_cast<std::uint16_t>(surfaces_.size() - 1);
}

std::uint16_t PackBuilder::add_print(float roughness) {
  return add_surface({.color = {1, 1, 1}, .roughness = roughness, .texture = "label"});
}

const Panel* PackBuilder::panel(PanelKind kind) const {
  for (const Panel& candidate : panels_) {
    if (candidate.kind == kind) return &candidate;
  }
  return nullptr;
}

void PackBuilder::add_triangle(const Corner& a,
                               const Corner& b,
                               const Corner& c,
                               std::uint16_t surface) {
  if (same_place(a.position, b.position) || same_place(b.position, c.position) ||
      same_place(c.position, a.position)) {
    return;
  }
  triangles_.push_back({a, b, c});
  triangle_surfaces_.push_back(surface);
}

void PackBuilder::add_quad(
    const Corner& a, const Corner& b, const Corner& c, const Corner& d, std::uint16_t surface) {
  add_triangle(a, b, c, surface);
  add_triangle(a, c, d, surface);
}

void PackBuilder::add_feature(FeatureKind kind, const Bounds3& box) {
  if (!box.empty()) features_.push_back({kind, box.center(), box.size() * 0.5F});
}

void PackBuilder::add_surface_feature(FeatureKind kind, std::uint16_t surface) {
  Bounds3 box;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    if (triangle_surfaces_[t] != surface) continue;
    for (const Corner& corner : triangles_[t])
      box.include(corner.position);
  }
  add_feature(kind, box);
}

void PackBuilder::add_part_feature(FeatureKind kind, std::size_t mark) {
  Bounds3 box;
  for (std::size_t t = mark; t < triangles_.size(); ++t) {
    for (const Corner& corner : triangles_[t])
      box.include(corner.position);
  }
  add_feature(kind, box);
}

void PackBuilder::add_band_feature(FeatureKind kind, float low_m, float high_m, PackAxis along) {
  Bounds3 box;
  for (const std::array<Corner, 3>& t : triangles_) {
    for (std::size_t i = 0; i < 3; ++i)
      include_between(box, t[i].position, t[(i + 1) % 3].position, low_m, high_m, along);
  }
  add_feature(kind, box);
}

ProductModel PackBuilder::finish(float crease_cos) const {
  ProductModel model;
  model.surfaces = surfaces_;
  model.features = features_;
  FlatIndex<VertexKey> known(triangles_.size() * 3);
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    std::array<std::uint32_t, 3> v{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Corner& corner = triangles_[t][i];
      const auto next = static_cast<std::uint32_t>(model.mesh.positions.size());
      const auto [found, is_new] = known.try_emplace(key_of(corner), next);
      if (is_new) model.mesh.add_vertex(corner.position, {}, corner.uv);
      v[i] = found;
    }
    model.mesh.add_triangle(v[0], v[1], v[2], triangle_surfaces_[t]);
  }
  fit_to_size(model, size_);
  recompute_normals(model.mesh, crease_cos);
  return model;
}

Result<PackBuilder> start_pack(const catalog::Product& product) {
  MARKETGEN_TRY(std::vector<Panel> panels, panels_of(product));
  return PackBuilder(product, std::move(panels));
}

Vec2f uv_in(const Panel* panel, float share_u, float share_v) {
  if (panel == nullptr) return {share_u, share_v};
  return {panel->u0 + share_u * (panel->u1 - panel->u0),
          panel->v0 + share_v * (panel->v1 - panel->v0)};
}

}  // namespace marketgen::assets
