#include "export/glb_goods.h"

#include "export/goods_look.h"
#include "export/price_prints.h"

namespace marketgen::exporters {
namespace {

Result<int> add_product_mesh(const catalog::Product& product,
                             const GoodsLook& made,
                             io::GlbDocument& document,
                             GlbMaterials& materials) {
  if (made.error) return *made.error;
  const int label = made.label.empty() ? -1 : document.add_texture(made.label);
  MARKETGEN_TRY(const std::vector<int> surfaces, add_looks(materials, product, made.model, label));
  return document.add_mesh(product.sku, made.model.mesh, surfaces);
}

std::array<float, 3> as_array(Vec3 v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

void add_place(io::GlbInstances& copies, const Pose& pose) {
  copies.translations.push_back(as_array(pose.position));
  copies.rotations.push_back(io::gltf_rotation(pose.rotation));
}

// Draws the node's mesh at every place: as a node each, by its id, or as one instanced node.
void add_copies(io::GltfJson node,
                const io::GlbInstances& copies,
                const ExportOptions& options,
                io::GlbDocument& document,
                int group) {
  if (options.instanced) {
    document.add_instanced_node(std::move(node), copies, group);
    return;
  }
  for (std::size_t i = 0; i < copies.translations.size(); ++i) {
    io::GltfJson copy = node;
    copy["name"] = copies.ids[i];
    copy["translation"] = io::json_array(copies.translations[i]);
    copy["rotation"] = io::json_array(copies.rotations[i]);
    document.add_node(std::move(copy), group);
  }
}

// Nobody asks for one print among its copies: without instances they are one mesh and one node, for
// every node costs a viewer time.
void add_prints(const PricePrint& print,
                int material,
                const ExportOptions& options,
                io::GlbDocument& document,
                int group) {
  if (options.instanced) {
    io::GlbInstances copies;
    for (const Pose& pose : print.places)
      add_place(copies, pose);
    const int mesh = document.add_mesh(print.name, print.mesh, {material});
    document.add_instanced_node({{"name", print.name}, {"mesh", mesh}}, copies, group);
    return;
  }
  const int mesh = document.add_mesh(print.name, mesh_of_all(print), {material});
  document.add_node({{"name", print.name}, {"mesh", mesh}}, group);
}

}  // namespace

Result<void> add_products(const scene::Scene& scene,
                          const ExportOptions& options,
                          io::GlbDocument& document,
                          GlbMaterials& materials) {
  std::vector<io::GlbInstances> copies(scene.catalog.size());
  for (std::uint32_t row = 0; row < scene.products.size(); ++row) {
    const scene::SceneProduct& item = scene.products[row];
    add_place(copies[item.sku], scene::world_from_product(item));
    copies[item.sku].ids.push_back(scene::product_id(scene, row));
  }
  const std::vector<GoodsLook> made = goods_looks(scene, assets::Detail::near, LabelCoding::png);
  const int group = document.add_node({{"name", "products"}}, -1);
  for (std::size_t sku = 0; sku < made.size(); ++sku) {
    if (copies[sku].ids.empty()) continue;
    const catalog::Product& product = scene.catalog[sku];
    MARKETGEN_TRY(const int mesh, add_product_mesh(product, made[sku], document, materials));
    add_copies({{"name", product.sku}, {"mesh", mesh}, {"extras", {{"sku", product.sku}}}},
               copies[sku],
               options,
               document,
               group);
  }
  return {};
}

Result<void> add_price_labels(const scene::Scene& scene,
                              const ExportOptions& options,
                              io::GlbDocument& document,
                              GlbMaterials& materials) {
  MARKETGEN_TRY(const PricePrints prints, price_prints(scene));
  std::vector<int> materials_of;  // by picture; those of cards follow the tags' meshes
  const auto draw = [&](std::size_t pictures) {
    for (std::size_t i = materials_of.size(); i < pictures; ++i)
      materials_of.push_back(
          materials.add({.color = {1, 1, 1}, .roughness = print_roughness, .texture = ""},
                        document.add_texture(prints.pictures[i])));
  };
  draw(prints.pictures.size() - prints.cards.size());
  const int group = document.add_node({{"name", "price-labels"}}, -1);
  for (const PricePrint& tag : prints.tags)
    add_prints(tag, materials_of[tag.picture], options, document, group);
  for (const PricePrint& card : prints.cards) {
    draw(card.picture + 1);
    add_prints(card, materials_of[card.picture], options, document, group);
  }
  return {};
}

}  // namespace marketgen::exporters
