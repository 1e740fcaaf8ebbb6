#include "export/glb_goods.h"

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>

#include <fmt/format.h>

#include "assets/print/label.h"
#include "base/parallel.h"
#include "export/label_picture.h"
#include "io/json.h"
#include "io/png.h"
#include "render/picture_cache.h"

namespace marketgen::exporters {
namespace {

constexpr int tag_px = 64, card_px = 148;  // heights
constexpr auto card_width_m = static_cast<float>(assets::promotion_card_width_mm * 1e-3);
constexpr auto card_height_m = static_cast<float>(assets::promotion_card_height_mm * 1e-3);
constexpr float tag_lift_m = 8e-4F;  // label stock before the rail
constexpr float tag_roughness = 0.5F;

using PictureResult = Result<std::string>;

PictureResult png_of(const std::string& content, const std::function<Result<Image>()>& draw) {
  MARKETGEN_TRY(const Image image, render::raytrace::cached_picture(content, draw));
  return io::encode_png(image);
}

// What one SKU needs, made apart from the document so that SKUs can be made side by side.
struct MadeProduct {
  assets::ProductModel model;
  std::string label_png;  // empty when no surface shows the label
  std::optional<Error> error;
};

MadeProduct make(const catalog::Product& product) {
  MadeProduct made;
  Result<assets::ProductModel> model = assets::make_product_model(product);
  if (!model.ok()) return {{}, {}, model.error()};
  made.model = std::move(model).value();
  if (std::ranges::none_of(made.model.surfaces,
                           [](const assets::Surface& s) { return s.texture == "label"; }))
    return made;
  const Result<Image> label = exported_label(product);
  PictureResult png = label.ok() ? io::encode_png(*label) : label.error();
  if (!png.ok())
    made.error = png.error();
  else
    made.label_png = std::move(png).value();
  return made;
}

Result<int> add_product_mesh(const catalog::Product& product,
                             const MadeProduct& made,
                             io::GlbDocument& document,
                             GlbMaterials& materials) {
  if (made.error) return *made.error;
  const int label = made.label_png.empty() ? -1 : document.add_texture(made.label_png);
  std::vector<int> surfaces;
  for (const assets::Surface& surface : made.model.surfaces) {
    if (surface.texture.empty() || surface.texture == "label") {
      surfaces.push_back(materials.add(surface, surface.texture.empty() ? -1 : label));
      continue;
    }
    MARKETGEN_TRY(const int tiled, materials.add_tiled(surface.texture));
    surfaces.push_back(tiled);
  }
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

// One design of tag or card and where it is stuck on.
struct Prints {
  const scene::PriceLabel* first = nullptr;
  std::vector<Pose> places;
};

Mesh upright_quad(float width_m, float height_m) {
  const float x = width_m / 2, z = height_m / 2;
  Mesh quad;
  add_quad(quad, {-x, 0, -z}, {x, 0, -z}, {x, 0, z}, {-x, 0, z}, 0);
  return quad;
}

// Nobody asks for one print among its copies: without instances they are one mesh and one node, for
// every node costs a viewer time.
void add_prints(const std::string& name,
                const Mesh& print,
                int material,
                const std::vector<Pose>& places,
                const ExportOptions& options,
                io::GlbDocument& document,
                int group) {
  if (options.instanced) {
    io::GlbInstances copies;
    for (const Pose& pose : places)
      add_place(copies, pose);
    const int mesh = document.add_mesh(name, print, {material});
    document.add_instanced_node({{"name", name}, {"mesh", mesh}}, copies, group);
    return;
  }
  Mesh all;
  for (const Pose& pose : places) {
    const std::size_t first = all.positions.size();
    all.append(print);
    place(all, pose, first);
  }
  document.add_node({{"name", name}, {"mesh", document.add_mesh(name, all, {material})}}, group);
}

Pose place_of(const scene::Scene& scene, const scene::PriceLabel& label) {
  const scene::SceneShelf& shelf = scene.shelves[label.shelf];
  const double middle_m = (assets::price_rail_top_m + assets::price_rail_bottom_m) / 2;
  return scene::world_from_shelf(scene, label.shelf) *
         Pose{{label.x_m - shelf.width_m / 2, assets::price_rail_face_m - tag_lift_m, middle_m},
              {}};
}

// The card of an offer hangs below its tag; those of neighbours, which may overlap, a little apart.
Pose place_of_card(const scene::Scene& scene, std::size_t row) {
  const scene::PriceLabel& label = scene.price_labels[row];
  const double apart_m = tag_lift_m * static_cast<double>(1 + row % 3);
  return place_of(scene, label) *
         Pose{{0, -apart_m, -static_cast<double>(label.height_m + card_height_m) / 2}, {}};
}

// One card a SKU on offer, at all its places.
Result<void> add_promotion_cards(const scene::Scene& scene,
                                 const ExportOptions& options,
                                 io::GlbDocument& document,
                                 GlbMaterials& materials,
                                 int group) {
  std::map<std::uint32_t, std::vector<Pose>> cards;  // by SKU
  for (std::size_t row = 0; row < scene.price_labels.size(); ++row) {
    const scene::PriceLabel& label = scene.price_labels[row];
    if (label.promotion != 0) cards[label.sku].push_back(place_of_card(scene, row));
  }
  const Mesh card = upright_quad(card_width_m, card_height_m);
  for (const auto& [sku, places] : cards) {
    const catalog::Product& product = scene.catalog[sku];
    MARKETGEN_TRY(const std::string png,
                  png_of(fmt::format("promotion card {} {}", card_px, io::write_json_line(product)),
                         [&] { return assets::draw_promotion_card(product, card_px); }));
    const int material = materials.add(
        {.color = {1, 1, 1}, .roughness = tag_roughness, .texture = ""}, document.add_texture(png));
    add_prints("offer/" + product.sku, card, material, places, options, document, group);
  }
  return {};
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
  const std::vector<MadeProduct> made = parallel_map(scene.catalog.size(), [&](std::size_t sku) {
    return copies[sku].ids.empty() ? MadeProduct{} : make(scene.catalog[sku]);
  });
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
  std::map<std::tuple<std::uint32_t, std::uint32_t>, int> material_of;            // SKU, promotion
  std::map<std::tuple<std::uint32_t, std::uint32_t, float, float>, Prints> tags;  // and size
  for (const scene::PriceLabel& label : scene.price_labels) {
    Prints& same = tags[{label.sku, label.promotion, label.width_m, label.height_m}];
    if (same.first == nullptr) same.first = &label;
    same.places.push_back(place_of(scene, label));
    material_of[{label.sku, label.promotion}] = -1;
  }
  std::vector<std::pair<std::tuple<std::uint32_t, std::uint32_t>, PictureResult>> drawn;
  for (const auto& [key, index] : material_of)
    drawn.emplace_back(key, std::string());
  parallel_for(drawn.size(), [&](std::size_t i) {
    const auto& [sku, promotion] = drawn[i].first;
    const Result<Image> tag = exported_price_tag(scene.catalog[sku], promotion != 0, tag_px);
    drawn[i].second = tag.ok() ? io::encode_png(*tag) : tag.error();
  });
  for (const auto& [key, png] : drawn) {
    if (!png.ok()) return png.error();
    material_of[key] =
        materials.add({.color = {1, 1, 1}, .roughness = tag_roughness, .texture = ""},
                      document.add_texture(*png));
  }
  const int group = document.add_node({{"name", "price-labels"}}, -1);
  for (const auto& [key, same] : tags) {
    add_prints("price/" + scene.catalog[same.first->sku].sku,
               upright_quad(same.first->width_m, same.first->height_m),
               material_of[{same.first->sku, same.first->promotion}],
               same.places,
               options,
               document,
               group);
  }
  return add_promotion_cards(scene, options, document, materials, group);
}

}  // namespace marketgen::exporters
