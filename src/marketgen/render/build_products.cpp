#include "render/build_products.h"

#include <optional>
#include <set>

#include "base/parallel.h"
#include "render/label_library.h"
#include "render/picture_objects.h"
#include "render/shading_math.h"

namespace marketgen::raytrace {
namespace {

constexpr float brightness_spread =
    0.04F;  // between items of one SKU, each way: print runs, dust, wear
constexpr float smoothest_opaque = 0.15F;  // roughness

std::vector<std::uint32_t> skus_in_use(const Scene& scene) {
  std::set<std::uint32_t> rows;
  for (const SceneProduct& product : scene.products)
    rows.insert(product.sku);
  return {rows.begin(), rows.end()};
}

// Filled plastic and glass (assets/archetypes/surfaces.h) are the only plain surfaces so smooth.
bool is_clear(const Surface& surface) {
  return surface.kind == SurfaceKind::glass || (surface.texture.empty() && surface.metallic == 0 &&
                                                surface.roughness <= smoothest_opaque);
}

Material material_of(Draft& draft, const Product& product, const Surface& surface) {
  Material material{
      .color = surface.color, .roughness = surface.roughness, .metallic = surface.metallic};
  material.clear = is_clear(surface);
  if (surface.texture == "label")
    material.texture = draft.print_texture(
        label_content(product, draft.print()),
        [&product, print = draft.print()] { return library_label(product, print); });
  else if (!surface.texture.empty())
    return draft.world().materials[draft.tiled_material(surface.texture)];
  return material;
}

// Clear packs are seen as their contents, so that the picture's instance is the product and not
// what stands behind it.
std::uint16_t add_material(Draft& draft, const Product& product, const Surface& surface) {
  return draft.material(material_of(draft, product, surface));
}

float brightness_of(std::size_t product) {
  return 1 + brightness_spread * (2 * unit_float(hashed(static_cast<std::uint32_t>(product))) - 1);
}

}  // namespace

Result<ProductBuilder> ProductBuilder::begin(Draft& draft) {
  ProductBuilder builder;
  const std::vector<std::uint32_t> rows = skus_in_use(draft.scene());
  std::vector<std::optional<Error>> errors(rows.size());
  builder.skus_ = parallel_map(rows.size(), [&](std::size_t i) {
    Sku sku{rows[i], {}, {}};
    Result<ProductModel> model = make_product_model(draft.scene().catalog[rows[i]]);
    if (model.ok())
      sku.model = std::move(model).value();
    else
      errors[i] = model.error();
    return sku;
  });
  for (const std::optional<Error>& error : errors) {
    if (error) return *error;
  }
  for (Sku& sku : builder.skus_) {
    for (const Surface& surface : sku.model.surfaces) {
      sku.materials.push_back(add_material(draft, draft.scene().catalog[sku.row], surface));
    }
  }
  return builder;
}

void ProductBuilder::build(Draft& draft) const {
  const Scene& scene = draft.scene();
  World& world = draft.world();
  const std::size_t first_mesh = world.meshes.size();
  world.meshes.resize(first_mesh + skus_.size());
  std::vector<std::uint32_t> mesh_of_sku(scene.catalog.size());
  parallel_for(skus_.size(), [&](std::size_t i) {
    TracedMesh& mesh = world.meshes[first_mesh + i];
    append(mesh.solid, mesh.glass, skus_[i].model.mesh, skus_[i].materials, world, {});
    mesh_of_sku[skus_[i].row] = static_cast<std::uint32_t>(first_mesh + i);
  });
  const auto first_id = first_product_object(scene);
  world.first_product_instance = static_cast<std::uint32_t>(world.instances.size());
  for (std::size_t i = 0; i < scene.products.size(); ++i) {
    const SceneProduct& product = scene.products[i];
    Instance instance;
    instance.mesh = mesh_of_sku[product.sku];
    instance.id = first_id + static_cast<std::uint32_t>(i);
    if (product.facing < scene.facings.size())
      instance.shelf = static_cast<std::int32_t>(scene.facings[product.facing].shelf);
    instance.brightness = brightness_of(i);
    instance.world_from_mesh = placement_of(world_from_product(product));
    world.instances.push_back(instance);
  }
}

}  // namespace marketgen::raytrace
