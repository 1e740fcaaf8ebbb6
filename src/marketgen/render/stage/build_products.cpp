#include "render/stage/build_products.h"

#include <algorithm>
#include <optional>
#include <set>

#include "assets/contents.h"
#include "assets/print/label_sheet.h"
#include "base/parallel.h"
#include "render/picture_objects.h"
#include "render/shading_math.h"
#include "render/stage/clear_pack.h"
#include "render/stage/label_library.h"

namespace marketgen::render::raytrace {
namespace {

// How far light wanders below the skin of fruit and vegetables. An apple's reduced scattering and
// absorption (Jensen et al., SIGGRAPH 2001, table 2: 2.3 and 0.003 to 0.046 per mm) give diffusion
// lengths of 7 mm in red to 2 mm in blue; most light leaves nearer.
constexpr float flesh_reach_m = 0.003F;

std::vector<std::uint32_t> skus_in_use(const scene::Scene& scene) {
  std::set<std::uint32_t> rows;
  for (const scene::SceneProduct& product : scene.products)
    rows.insert(product.sku);
  return {rows.begin(), rows.end()};
}

bool is_grown(const catalog::Product& product) {
  const Result<assets::SheetKind> sheet = assets::sheet_kind_of(product.archetype);
  return sheet.ok() && *sheet == assets::SheetKind::skin;
}

Material material_of(Draft& draft,
                     const catalog::Product& product,
                     const marketgen::assets::Surface& surface) {
  Material material{
      .color = surface.color, .roughness = surface.roughness, .metallic = surface.metallic};
  if (surface.metallic > 0 && surface.metallic < 1) material.coat = 1;  // lacquered metal
  if (is_grown(product)) material.scatter_m = flesh_reach_m;
  if (surface.texture == "label")
    material.texture = draft.label_texture(
        label_content(product, draft.print()),
        [&product, print = draft.print()] { return library_label(product, print); });
  else if (surface.texture == "contents")
    return draft.world()
        .materials[draft.tiled_material(assets::contents_material(*product.contents))];
  else if (!surface.texture.empty())
    return draft.world().materials[draft.tiled_material(surface.texture)];
  return material;
}

// One material for each surface of the model.
std::vector<std::uint16_t> add_materials(Draft& draft,
                                         const catalog::Product& product,
                                         const assets::ProductModel& model) {
  std::vector<std::uint16_t> materials;
  const auto depth_m = static_cast<float>(std::min(product.width_m(), product.depth_m()));
  for (const marketgen::assets::Surface& surface : model.surfaces) {
    const Material look = material_of(draft, product, surface);
    materials.push_back(draft.material(surface.refraction > 0
                                           ? liquid_material(surface, look, depth_m)
                                       : surface.empty ? sheet_material(look)
                                                       : look));
  }
  return materials;
}

}  // namespace

Result<ProductBuilder> ProductBuilder::begin(Draft& draft, assets::Detail detail) {
  ProductBuilder builder;
  const std::vector<std::uint32_t> rows = skus_in_use(draft.scene());
  std::vector<std::optional<Error>> errors(rows.size());
  builder.skus_ = parallel_map(rows.size(), [&](std::size_t i) {
    Sku sku{rows[i], {}, {}};
    Result<assets::ProductModel> model =
        assets::make_product_model(draft.scene().catalog[rows[i]], detail);
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
    sku.materials = add_materials(draft, draft.scene().catalog[sku.row], sku.model);
  }
  return builder;
}

void ProductBuilder::build(Draft& draft) const {
  const scene::Scene& scene = draft.scene();
  World& world = draft.world();
  const std::size_t first_mesh = world.meshes.size();
  world.meshes.resize(first_mesh + skus_.size());
  std::vector<std::uint32_t> mesh_of_sku(scene.catalog.size());
  std::vector<ItemKind> kind_of_sku(scene.catalog.size(), ItemKind::packed);
  parallel_for(skus_.size(), [&](std::size_t i) {
    TracedMesh& mesh = world.meshes[first_mesh + i];
    const assets::ProductModel& model = skus_[i].model;
    append(mesh.solid, mesh.glass, with_level(model), skus_[i].materials, world, {});
    mesh_of_sku[skus_[i].row] = static_cast<std::uint32_t>(first_mesh + i);
    if (is_grown(scene.catalog[skus_[i].row])) kind_of_sku[skus_[i].row] = ItemKind::grown;
  });
  const auto first_id = first_product_object(scene);
  world.first_product_instance = static_cast<std::uint32_t>(world.instances.size());
  for (std::size_t i = 0; i < scene.products.size(); ++i) {
    const scene::SceneProduct& product = scene.products[i];
    Instance instance;
    instance.mesh = mesh_of_sku[product.sku];
    instance.id = first_id + static_cast<std::uint32_t>(i);
    if (product.facing < scene.facings.size())
      instance.shelf = static_cast<std::int32_t>(scene.facings[product.facing].shelf);
    if (!draft.detail().as_new)
      instance.look = look_of_item(i, product.sku, kind_of_sku[product.sku]);
    instance.world_from_mesh = placement_of(scene::world_from_product(product));
    world.instances.push_back(instance);
  }
}

}  // namespace marketgen::render::raytrace
