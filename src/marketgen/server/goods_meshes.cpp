// The shapes of goods, and their labels on pages.
#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "assets/print/color.h"
#include "base/interrupt.h"
#include "base/parallel.h"
#include "io/jpeg.h"
#include "render/picture_cache.h"
#include "render/stage/label_library.h"
#include "server/picture_pages.h"
#include "server/view_files.h"
#include "server/view_mesh.h"

namespace marketgen::server {
namespace {

using render::PrintDetail;
using render::raytrace::Texture;

constexpr int max_label_px = 512;

// What one SKU needs, made apart from the others.
struct MadeSku {
  assets::ProductModel model;
  Texture label;  // empty: it shows none
  std::optional<Error> error;
};

bool shows_label(const assets::ProductModel& model) {
  return std::ranges::any_of(model.surfaces,
                             [](const assets::Surface& s) { return s.texture == "label"; });
}

MadeSku make_sku(const catalog::Product& product, assets::Detail detail) {
  Result<assets::ProductModel> model = assets::make_product_model(product, detail);
  if (!model.ok()) return {{}, {}, model.error()};
  MadeSku made{std::move(model).value(), {}, std::nullopt};
  if (!shows_label(made.model)) return made;
  const Result<render::raytrace::Print> print = render::raytrace::cached_print(
      render::raytrace::label_content(product, PrintDetail::distant),
      [&] { return render::raytrace::library_label(product, PrintDetail::distant); });
  if (!print.ok()) return {{}, {}, print.error()};
  made.label = Texture(print->blocks, print->bars);
  return made;
}

bool is_clear(const assets::Surface& surface) {
  return surface.refraction > 0 || surface.kind == assets::SurfaceKind::glass;
}

// A surface in a catalogue material has that material's ground colour from afar.
Vec3f color_of(const assets::Surface& surface, const std::vector<catalog::MaterialRow>& materials) {
  if (surface.texture.empty() || surface.texture == "label") return surface.color;
  const auto row = std::ranges::find(materials, surface.texture, &catalog::MaterialRow::id);
  if (row == materials.end()) return surface.color;
  const Result<Vec3f> color = assets::linear_from_hex(row->color);
  return color.ok() ? *color : surface.color;
}

// Rows of the section "range".
struct SkuRange {
  std::uint32_t first_vertex = 0, vertices = 0, first_index = 0, opaque = 0, clear = 0;
};

class SkuMeshes {
 public:
  explicit SkuMeshes(const std::vector<catalog::MaterialRow>& materials) : materials_(materials) {}

  void add_nothing() { ranges_.insert(ranges_.end(), 6, 0U); }

  void add(const assets::ProductModel& model) {
    SkuRange range{static_cast<std::uint32_t>(mesh_.vertices.size()),
                   0,
                   static_cast<std::uint32_t>(mesh_.indices.size()),
                   0,
                   0};
    mesh_.begin_part();
    range.opaque = add_triangles(model, false);
    range.clear = add_triangles(model, true);
    range.vertices = static_cast<std::uint32_t>(mesh_.vertices.size()) - range.first_vertex;
    for (const std::uint32_t value :
         {range.first_vertex, range.vertices, range.first_index, range.opaque, range.clear, 0U})
      ranges_.push_back(value);
  }

  void pack(PackedSections& sections) const {
    mesh_.pack(sections);
    sections.add("range", 6, std::span<const std::uint32_t>(ranges_));
  }

 private:
  // Of the surfaces that are clear, or of those that are not; how many indices.
  std::uint32_t add_triangles(const assets::ProductModel& model, bool clear) {
    const std::size_t before = mesh_.indices.size();
    const Mesh& mesh = model.mesh;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const assets::Surface& surface = model.surfaces[mesh.surfaces[t]];
      if (is_clear(surface) != clear) continue;
      for (const std::uint32_t corner : mesh.triangles[t])
        mesh_.indices.push_back(mesh_.add(vertex_of(mesh, corner, surface)));
    }
    return static_cast<std::uint32_t>(mesh_.indices.size() - before);
  }

  ViewVertex vertex_of(const Mesh& mesh, std::uint32_t corner, const assets::Surface& surface) {
    const bool label = surface.texture == "label";
    const Vec3f color = color_of(surface, materials_);
    ViewVertex vertex;
    vertex.position = mesh.positions[corner];
    vertex.normal = mesh.normals[corner];
    if (label) vertex.uv = mesh.uvs[corner];
    vertex.color = {srgb_byte(color.x),
                    srgb_byte(color.y),
                    srgb_byte(color.z),
                    static_cast<std::uint8_t>(label ? 255 : 0)};
    return vertex;
  }

  const std::vector<catalog::MaterialRow>& materials_;
  ViewMesh mesh_;
  std::vector<std::uint32_t> ranges_;
};

PictureSize tile_size(const Texture& label) {
  if (label.empty()) return {};
  return {std::min(label.width(), max_label_px), std::min(label.height(), max_label_px)};
}

Result<std::vector<ViewFile>> label_pages(const std::vector<MadeSku>& made,
                                          const PictureLayout& layout,
                                          const std::vector<PictureSize>& sizes) {
  std::vector<ViewFile> files;
  for (std::size_t p = 0; p < layout.pages.size(); ++p) {
    const Image page = painted_page(
        layout, p, sizes, [&](std::size_t i) -> const Texture& { return made[i].label; });
    MARKETGEN_TRY(std::string bytes, io::encode_jpeg(page));
    files.push_back({fmt::format("goods-{}.jpg", p), "image/jpeg", std::move(bytes)});
  }
  return files;
}

void pack_tiles(PackedSections& sections,
                const PictureLayout& layout,
                const std::vector<PictureSize>& sizes) {
  std::vector<float> tiles;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    tiles.push_back(static_cast<float>(layout.places[i].page));
    for (const float edge : tile_of(layout, i, sizes))
      tiles.push_back(edge);
  }
  sections.add("tile", 5, std::span<const float>(tiles));
  nlohmann::ordered_json pages = nlohmann::ordered_json::array();
  for (const PictureSize& page : layout.pages)
    pages.push_back({{"width", page.width}, {"height", page.height}});
  sections.note("pages", std::move(pages));
}

// Of each product; null: its row is empty.
Result<std::vector<ViewFile>> meshes_of(const std::vector<const catalog::Product*>& products,
                                        const std::vector<catalog::MaterialRow>& materials,
                                        assets::Detail detail,
                                        Progress& progress) {
  progress.begin("goods", products.size());
  const std::vector<MadeSku> made = parallel_map(products.size(), [&](std::size_t sku) {
    MadeSku one = products[sku] != nullptr ? make_sku(*products[sku], detail) : MadeSku{};
    progress.advance();
    return one;
  });
  progress.end();
  MARKETGEN_CHECK(check_interrupt());
  SkuMeshes meshes(materials);
  std::vector<PictureSize> sizes;
  for (std::size_t sku = 0; sku < made.size(); ++sku) {
    if (made[sku].error) return *made[sku].error;
    if (products[sku] != nullptr)
      meshes.add(made[sku].model);
    else
      meshes.add_nothing();
    sizes.push_back(tile_size(made[sku].label));
  }
  const PictureLayout layout = lay_out(sizes);
  MARKETGEN_TRY(std::vector<ViewFile> files, label_pages(made, layout, sizes));
  PackedSections sections;
  meshes.pack(sections);
  pack_tiles(sections, layout, sizes);
  files.push_back({"meshes.bin", "application/octet-stream", sections.file()});
  return files;
}

}  // namespace

Result<std::vector<ViewFile>> goods_meshes(const scene::Scene& scene, Progress& progress) {
  std::vector<const catalog::Product*> stands(scene.catalog.size(), nullptr);
  for (const scene::SceneProduct& item : scene.products)
    stands[item.sku] = &scene.catalog[item.sku];
  return meshes_of(stands, scene.materials, assets::Detail::far, progress);
}

Result<std::vector<ViewFile>> product_meshes(const std::vector<catalog::Product>& products,
                                             const std::vector<catalog::MaterialRow>& materials,
                                             assets::Detail detail) {
  std::vector<const catalog::Product*> rows;
  for (const catalog::Product& product : products)
    rows.push_back(&product);
  return meshes_of(rows, materials, detail, silent_progress());
}

Result<ViewFile> product_mesh(const scene::Scene& scene, std::uint32_t sku, assets::Detail detail) {
  MARKETGEN_TRY(const assets::ProductModel model,
                assets::make_product_model(scene.catalog[sku], detail));
  SkuMeshes meshes(scene.materials);
  meshes.add(model);
  PackedSections sections;
  meshes.pack(sections);
  return ViewFile{"mesh.bin", "application/octet-stream", sections.file()};
}

}  // namespace marketgen::server
