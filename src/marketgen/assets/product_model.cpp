#include "assets/product_model.h"

#include <fmt/format.h>

#include <algorithm>

#include "assets/contents.h"
#include "assets/own_pack.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/mesh_detail.h"
#include "assets/shapes/pack_shape.h"
#include "catalog/catalog.h"

namespace marketgen::assets {
namespace {

struct Archetype {
  ArchetypeInfo info;
  Result<ProductModel> (*make)(const catalog::Product&);
  CollisionPrimitive (*collision)(const catalog::Product&);
};

constexpr Archetype archetype_list[] = {
#define ARCHETYPE(name, description) {{#name, description}, make_##name, collision_##name},
#include "assets/shapes/archetypes.inc"
#undef ARCHETYPE
};

// Limits of Product::fields, repeated here for rows that were not read from a file.
constexpr int min_size_mm = 5, greatest_size_mm = 1500;

// A quarter and a sixteenth of the near mesh's triangles, and what may go for it: across the aisle
// a leaf is a sliver, but a can still has twelve sides.
DetailLimits limits_of(Detail detail, std::size_t triangles) {
  constexpr std::size_t min_triangles = 100;
  if (detail == Detail::middle) return {std::max(triangles / 4, min_triangles), 0.05, 0.4};
  return {std::max(triangles / 16, min_triangles), 0.10, 0.8};
}

Result<const Archetype*> archetype_of(const catalog::Product& product) {
  for (const Archetype& archetype : archetype_list) {
    if (archetype.info.name == product.archetype) return &archetype;
  }
  return unknown_archetype(product.archetype, product.sku + "/archetype");
}

}  // namespace

Result<ProductModel> make_pack_shape(const catalog::Product& product, Detail detail) {
  if (has_own_mesh(product)) return own_pack_model(product, detail);
  MARKETGEN_TRY(const Archetype* archetype, archetype_of(product));
  MARKETGEN_CHECK(check_product_size(product));
  MARKETGEN_TRY(ProductModel model, archetype->make(product));
  model.collision = archetype->collision(product);
  if (detail == Detail::near) return model;
  Mesh coarse = simplified(model.mesh, limits_of(Detail::middle, model.mesh.triangles.size()));
  if (detail == Detail::far) {  // bunches of small parts may have nothing more to give
    Mesh far = simplified(model.mesh, limits_of(detail, model.mesh.triangles.size()));
    if (far.triangles.size() < coarse.triangles.size()) coarse = std::move(far);
  }
  model.mesh = std::move(coarse);
  return model;
}

Result<ProductModel> make_product_model(const catalog::Product& product, Detail detail) {
  MARKETGEN_TRY(ProductModel model, make_pack_shape(product, detail));
  part_at_level(model, product);
  return model;
}

Result<CollisionPrimitive> collision_of(const catalog::Product& product) {
  if (has_own_mesh(product)) return own_pack_collision(product);
  MARKETGEN_TRY(const Archetype* archetype, archetype_of(product));
  MARKETGEN_CHECK(check_product_size(product));
  return archetype->collision(product);
}

std::vector<ArchetypeInfo> archetypes() {
  std::vector<ArchetypeInfo> infos;
  for (const Archetype& archetype : archetype_list)
    infos.push_back(archetype.info);
  return infos;
}

Result<void> check_product_size(const catalog::Product& product) {
  for (const int size : product.size_mm) {
    if (size < min_size_mm || size > greatest_size_mm) {
      return Error{
          "assets.bad_row",
          product.sku + "/size_mm",
          fmt::format("a pack of {} x {} x {} mm cannot be built; each size must be {} to {} mm",
                      product.size_mm[0],
                      product.size_mm[1],
                      product.size_mm[2],
                      min_size_mm,
                      greatest_size_mm)};
    }
  }
  return {};
}

Error unknown_archetype(std::string_view name, std::string where) {
  std::vector<std::string_view> known;
  for (const Archetype& archetype : archetype_list)
    known.push_back(archetype.info.name);
  return catalog::unknown_name("catalog.unknown_kind", std::move(where), "archetype", name, known);
}

}  // namespace marketgen::assets
