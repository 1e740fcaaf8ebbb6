#include "export/mjcf_looks.h"

#include <algorithm>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "assets/materials/material_texture.h"
#include "assets/print/color.h"
#include "base/hash.h"
#include "base/parallel.h"
#include "export/label_picture.h"
#include "io/png.h"

namespace marketgen::exporters {
namespace {

constexpr int swatch_px = 8;
constexpr int floor_px = 512;
constexpr std::size_t hash_letters = 12;  // of a mesh's name: no two of a store's meshes share them

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

// What one SKU needs, made side by side.
struct MadeLook {
  std::string obj, png;
  std::optional<Error> error;
};

Result<MadeLook> made_look(const catalog::Product& product,
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
  MadeLook made;
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

std::string obj_text(const Mesh& mesh) {
  std::string text;
  const auto add = [&](std::string_view key, auto... numbers) {
    text += key;
    ((text += fmt::format(" {:.6g}", numbers)), ...);
    text += '\n';
  };
  for (const Vec3f& p : mesh.positions)
    add("v", p.x, p.y, p.z);
  for (const Vec2f& uv : mesh.uvs)
    add("vt", uv.x, 1 - uv.y);
  for (const Vec3f& n : mesh.normals)
    add("vn", n.x, n.y, n.z);
  for (const auto& [a, b, c] : mesh.triangles)
    text += fmt::format("f {0}/{0}/{0} {1}/{1}/{1} {2}/{2}/{2}\n", a + 1, b + 1, c + 1);
  return text;
}

void MjcfLooks::add_mesh(const std::string& sku, const std::string& obj) {
  const std::string name = "pack-" + Hasher().add(obj).hex().substr(0, hash_letters);
  if (std::ranges::find(meshes_, name) == meshes_.end()) {
    meshes_.push_back(name);
    files_.push_back({name + ".obj", obj});
  }
  goods_.push_back({sku, name});
}

Result<void> MjcfLooks::add_floor(const scene::Scene& scene) {
  const auto row =
      std::ranges::find(scene.materials, scene.layout.look.floor, &catalog::MaterialRow::id);
  if (row == scene.materials.end()) return {};
  MARKETGEN_TRY(std::string png, io::encode_png(assets::draw_material(*row, floor_px)));
  floor_ = "look/floor";
  floor_extent_m_ = assets::material_extent_m(*row);
  files_.push_back({"floor.png", std::move(png)});
  return {};
}

Result<MjcfLooks> MjcfLooks::make(const scene::Scene& scene) {
  MjcfLooks looks;
  std::vector<bool> stands(scene.catalog.size(), false);
  for (const scene::SceneProduct& item : scene.products)
    stands[item.sku] = true;
  const std::vector<MadeLook> made = parallel_map(scene.catalog.size(), [&](std::size_t sku) {
    if (!stands[sku]) return MadeLook{};
    Result<MadeLook> look = made_look(scene.catalog[sku], scene.materials);
    return look.ok() ? std::move(look).value() : MadeLook{{}, {}, look.error()};
  });
  for (std::size_t sku = 0; sku < made.size(); ++sku) {
    if (!stands[sku]) continue;
    if (made[sku].error) return *made[sku].error;
    looks.add_mesh(scene.catalog[sku].sku, made[sku].obj);
    looks.files_.push_back({scene.catalog[sku].sku + ".png", made[sku].png});
  }
  MARKETGEN_CHECK(looks.add_floor(scene));
  return looks;
}

void MjcfLooks::write_assets(MjcfText& out) const {
  for (const std::string& mesh : meshes_)
    out.line(2, "<mesh name=\"{0}\" file=\"{0}.obj\"/>", mesh);
  for (const Goods& goods : goods_) {
    out.line(2, "<texture name=\"look/{0}\" type=\"2d\" file=\"{0}.png\"/>", goods.sku);
    out.line(2, "<material name=\"look/{0}\" texture=\"look/{0}\"/>", goods.sku);
  }
  if (floor_.empty()) return;
  const auto repeat = static_cast<float>(1 / floor_extent_m_);
  out.line(2, "<texture name=\"{}\" type=\"2d\" file=\"floor.png\"/>", floor_);
  out.line(2,
           "<material name=\"{0}\" texture=\"{0}\" texuniform=\"true\" texrepeat=\"{1} {1}\"/>",
           floor_,
           repeat);
}

void MjcfLooks::write_defaults(MjcfText& out) const {
  out.line(2, "<default class=\"look\">");
  out.line(3,
           "<geom type=\"mesh\" group=\"{}\" contype=\"0\" conaffinity=\"0\" mass=\"0\"/>",
           static_cast<int>(group_product));
  for (const Goods& goods : goods_)
    out.line(3,
             "<default class=\"look/{0}\"><geom mesh=\"{1}\" material=\"look/{0}\"/></default>",
             goods.sku,
             goods.mesh);
  out.line(2, "</default>");
}

}  // namespace marketgen::exporters
