#include "assets/own_pack.h"

#include <algorithm>

#include "assets/shapes/contact_pieces.h"
#include "assets/shapes/mesh_detail.h"
#include "assets/shapes/outer_hull.h"
#include "catalog/own_mesh.h"
#include "geometry/solid.h"

namespace marketgen::assets {
namespace {

constexpr std::size_t middle_triangles = 1500, far_triangles = 300;
constexpr int solid_columns = 96;

// glTF: Y up, front +Z. Product: Z up, front -Y.
Vec3f product_from_gltf(Vec3f p) {
  return {p.x, -p.z, p.y};
}

Surface surface_of(const io::ModelMaterial& material) {
  Surface surface;
  surface.color = material.color;
  surface.roughness = material.roughness;
  surface.metallic = material.metallic;
  surface.kind = material.clear ? SurfaceKind::glass : SurfaceKind::opaque;
  if (material.picture >= 0) surface.texture = "label";
  return surface;
}

ContactPiece hull_piece(std::vector<Vec3f> points) {
  ContactPiece piece;
  piece.shape = PieceShape::hull;
  piece.points = std::move(points);
  return piece;
}

Result<io::OutsideModel> model_in_product_frame(const catalog::Product& product) {
  MARKETGEN_TRY(io::OutsideModel model, catalog::kept_mesh(product));
  for (Vec3f& p : model.mesh.positions)
    p = product_from_gltf(p);
  for (Vec3f& n : model.mesh.normals)
    n = product_from_gltf(n);
  for (std::vector<Vec3f>& piece : model.pieces) {
    for (Vec3f& p : piece)
      p = product_from_gltf(p);
  }
  return model;
}

}  // namespace

bool has_own_mesh(const catalog::Product& product) {
  return product.archetype == catalog::mesh_archetype;
}

Result<ProductModel> own_pack_model(const catalog::Product& product, Detail detail) {
  MARKETGEN_TRY(io::OutsideModel outside, model_in_product_frame(product));
  ProductModel model;
  model.mesh = std::move(outside.mesh);
  for (const io::ModelMaterial& material : outside.materials)
    model.surfaces.push_back(surface_of(material));
  model.collision = own_pack_collision(product);
  if (detail != Detail::near)
    model.mesh = simplified(
        model.mesh, {.triangles = detail == Detail::middle ? middle_triangles : far_triangles});
  return model;
}

CollisionPrimitive own_pack_collision(const catalog::Product& product) {
  const Vec3 size{product.width_m(), product.depth_m(), product.height_m()};
  CollisionPrimitive box;
  box.half_size = to_float(size * 0.5);
  box.center = {0, 0, box.half_size.z};
  return box;
}

Result<ProductBody> own_pack_body(const catalog::Product& product) {
  MARKETGEN_TRY(io::OutsideModel model, model_in_product_frame(product));
  const bool closed = is_watertight(model.mesh) && marketgen::volume_of(model.mesh) > 0;
  const Mesh hull = closed ? Mesh{} : outer_hull(model.mesh.positions);
  const Solid solid(closed ? model.mesh : hull, solid_columns);
  ProductBody body;
  for (std::vector<Vec3f>& points : model.pieces)
    body.pieces.push_back(hull_piece(std::move(points)));
  if (body.pieces.empty() && closed) body.pieces = contact_pieces(model.mesh, solid, {});
  if (body.pieces.empty()) body.pieces = {hull_piece(hull.positions)};
  const MassProperties mass = solid.mass_properties();
  if (!(mass.volume > 0))
    return Error{"model.bad_file", product.sku + "/mesh", "is flat: it encloses no volume"};
  body.center_of_mass = to_float(mass.centroid);
  for (std::size_t i = 0; i < mass.inertia.size(); ++i)
    body.inertia_kg_m2[i] = static_cast<float>(product.mass_kg / mass.volume * mass.inertia[i]);
  return body;
}

Result<Image> own_pack_picture(const catalog::Product& product, int size_px) {
  MARKETGEN_TRY(io::OutsideModel model, catalog::kept_mesh(product));
  if (model.pictures.empty())
    return Error{"assets.bad_row", product.sku, "its mesh has no picture, only colours"};
  const Image& full = model.pictures[0];
  const int step = std::max(1, (full.height + size_px - 1) / size_px);
  if (step == 1 && full.channels == 3) return std::move(model.pictures[0]);
  Image image(std::max(1, full.width / step), std::max(1, full.height / step));
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        int sum = 0;
        for (int dy = 0; dy < step; ++dy) {
          for (int dx = 0; dx < step; ++dx)
            sum += full.at(std::min(x * step + dx, full.width - 1),
                           std::min(y * step + dy, full.height - 1))[c];
        }
        image.at(x, y)[c] = static_cast<std::uint8_t>(sum / (step * step));
      }
    }
  }
  return image;
}

}  // namespace marketgen::assets
