#include "export/mjcf_looks.h"

#include <algorithm>

#include "assets/materials/material_texture.h"
#include "base/hash.h"
#include "export/goods_sheets.h"
#include "io/png.h"

namespace marketgen::exporters {
namespace {

constexpr int floor_px = 512;
constexpr std::size_t hash_letters = 12;  // of a mesh's name: no two of a store's meshes share them

}  // namespace

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
  MARKETGEN_TRY(const auto sheets, goods_sheets(scene));
  for (std::size_t sku = 0; sku < sheets.size(); ++sku) {
    if (!sheets[sku]) continue;
    looks.add_mesh(scene.catalog[sku].sku, sheets[sku]->obj);
    looks.files_.push_back({scene.catalog[sku].sku + ".png", sheets[sku]->png});
  }
  MARKETGEN_CHECK(looks.add_floor(scene));
  return looks;
}

void MjcfLooks::write_assets(XmlText& out) const {
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

void MjcfLooks::write_defaults(XmlText& out) const {
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
