#include "export/goods_sheets.h"

#include <algorithm>
#include <map>

#include "assets/print/color.h"
#include "base/parallel.h"
#include "export/label_picture.h"
#include "export/obj_text.h"
#include "export/xml_text.h"
#include "io/png.h"

namespace marketgen::exporters {
namespace {

constexpr int swatch_px = 8;

// Half as many rows and columns: what a camera on a robot can tell apart.
Image halved(const Image& image) {
  Image half(std::max(1, image.width / 2), std::max(1, image.height / 2));
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        const int x1 = std::min(2 * x + 1, image.width - 1),
                  y1 = std::min(2 * y + 1, image.height - 1);
        const int sum = image.at(2 * x, 2 * y)[c] + image.at(x1, 2 * y)[c] +
                        image.at(2 * x, y1)[c] + image.at(x1, y1)[c];
        half.at(x, y)[c] = static_cast<std::uint8_t>((sum + 2) / 4);
      }
    }
  }
  return half;
}

Result<Vec3f> color_of(const assets::Surface& surface,
                       const std::vector<catalog::MaterialRow>& materials) {
  const auto row = std::ranges::find(materials, surface.texture, &catalog::MaterialRow::id);
  if (surface.texture.empty() || row == materials.end()) return surface.color;
  return assets::linear_from_hex(row->color);
}

void paint(Image& image, int left, int top, int width, int height, Vec3f linear) {
  const auto byte = [](float c) {
    return static_cast<std::uint8_t>(255 * srgb_from_linear(c) + 0.5);
  };
  for (int y = top; y < top + height; ++y) {
    for (int x = left; x < left + width; ++x) {
      std::uint8_t* p = image.at(x, y);
      p[0] = byte(linear.x), p[1] = byte(linear.y), p[2] = byte(linear.z);
    }
  }
}

Result<GoodsSheet> goods_sheet(const catalog::Product& product,
                               const std::vector<catalog::MaterialRow>& materials) {
  MARKETGEN_TRY(const assets::ProductModel model,
                assets::make_product_model(product, assets::Detail::middle));
  Image label;
  if (std::ranges::any_of(model.surfaces,
                          [](const assets::Surface& s) { return s.texture == "label"; })) {
    MARKETGEN_TRY(const Image sheet, exported_label(product));
    label = halved(sheet);
  }
  MARKETGEN_TRY(const SheetLook look, sheet_look(model, label, materials));
  GoodsSheet made;
  made.obj = obj_text(look.mesh);
  MARKETGEN_TRY(made.png, io::encode_png(look.sheet));
  return made;
}

}  // namespace

Result<SheetLook> sheet_look(const assets::ProductModel& model,
                             const Image& label,
                             const std::vector<catalog::MaterialRow>& materials) {
  SheetLook look;
  const auto swatches = static_cast<int>(model.surfaces.size());
  look.sheet = Image(std::max(label.width, swatch_px * swatches), label.height + swatch_px);
  for (int y = 0; y < label.height; ++y)
    std::copy_n(label.at(0, y), 3 * label.width, look.sheet.at(0, y));
  const auto width = static_cast<float>(look.sheet.width),
             height = static_cast<float>(look.sheet.height);
  for (int s = 0; s < swatches; ++s) {
    MARKETGEN_TRY(const Vec3f color,
                  color_of(model.surfaces[static_cast<std::size_t>(s)], materials));
    paint(look.sheet, s * swatch_px, label.height, swatch_px, swatch_px, color);
  }
  const auto on_sheet = [&](Vec2f uv, std::uint16_t surface) -> Vec2f {
    if (model.surfaces[surface].texture == "label" && !label.empty()) {
      const float u = std::clamp(uv.x, 0.0F, 1.0F), v = std::clamp(uv.y, 0.0F, 1.0F);
      // Half a pixel short of the swatches.
      return {u * static_cast<float>(label.width) / width,
              v * (static_cast<float>(label.height) - 0.5F) / height};
    }
    return {(static_cast<float>(surface) + 0.5F) * swatch_px / width,
            (static_cast<float>(label.height) + swatch_px / 2.0F) / height};
  };
  std::map<std::pair<std::uint32_t, std::uint16_t>, std::uint32_t> known;  // corner and surface
  const Mesh& mesh = model.mesh;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t v = mesh.triangles[t][c];
      const auto [entry, is_new] = known.try_emplace({v, mesh.surfaces[t]}, 0);
      if (is_new)
        entry->second = look.mesh.add_vertex(
            mesh.positions[v], mesh.normals[v], on_sheet(mesh.uvs[v], mesh.surfaces[t]));
      corners[c] = entry->second;
    }
    look.mesh.add_triangle(corners[0], corners[1], corners[2], 0);
  }
  return look;
}

Result<std::vector<std::optional<GoodsSheet>>> goods_sheets(const scene::Scene& scene) {
  std::vector<bool> stands(scene.catalog.size(), false);
  for (const scene::SceneProduct& item : scene.products)
    stands[item.sku] = true;
  using Made = std::optional<Result<GoodsSheet>>;
  const std::vector<Made> made = parallel_map(scene.catalog.size(), [&](std::size_t sku) {
    return stands[sku] ? Made(goods_sheet(scene.catalog[sku], scene.materials)) : Made();
  });
  std::vector<std::optional<GoodsSheet>> sheets(made.size());
  for (std::size_t sku = 0; sku < made.size(); ++sku) {
    if (!made[sku]) continue;
    MARKETGEN_TRY(sheets[sku], *made[sku]);
  }
  return sheets;
}

}  // namespace marketgen::exporters
