#include "export/material_pictures.h"

#include <algorithm>

#include "assets/materials/material_texture.h"
#include "io/jpeg.h"
#include "io/png.h"

namespace marketgen::exporters {
namespace {

// Colour is looked at, relief and gloss only light it: half as fine is enough for them.
constexpr int color_px = 512, relief_px = 256;

// Roughness in green, metallic in blue, as glTF has them.
Image metallic_roughness(const assets::MaterialMaps& maps) {
  Image image(maps.roughness.width, maps.roughness.height);
  for (std::size_t i = 0; i < maps.roughness.pixels.size(); ++i) {
    image.pixels[3 * i] = 255;
    image.pixels[3 * i + 1] = maps.roughness.pixels[i];
    image.pixels[3 * i + 2] = maps.metallic.pixels[i];
  }
  return image;
}

}  // namespace

const catalog::MaterialRow* scene_material(const scene::Scene& scene, const std::string& id) {
  const auto found = std::ranges::find(scene.materials, id, &catalog::MaterialRow::id);
  return found == scene.materials.end() ? nullptr : &*found;
}

assets::Surface plain_plaster() {
  return {.color = {0.8F, 0.8F, 0.78F}, .roughness = 0.8F, .texture = ""};
}

double material_repeat_m(const scene::Scene& scene, const std::string& id) {
  const catalog::MaterialRow* material = scene_material(scene, id);
  return material == nullptr ? 1 : assets::material_extent_m(*material);
}

Result<MaterialPictures> material_pictures(const catalog::MaterialRow& material,
                                           MaterialCoding coding) {
  const assets::MaterialMaps relief = assets::draw_material_maps(material, relief_px);
  MaterialPictures pictures;
  const Image color = assets::draw_material(material, color_px);
  const auto coded = [&](const Image& image, io::JpegUse use) {
    return coding == MaterialCoding::jpeg ? io::encode_jpeg(image, use) : io::encode_png(image);
  };
  MARKETGEN_TRY(pictures.color, coded(color, io::JpegUse::texture));
  MARKETGEN_TRY(pictures.normal, coded(relief.normal, io::JpegUse::picture));
  MARKETGEN_TRY(pictures.gloss, io::encode_png(metallic_roughness(relief)));
  return pictures;
}

}  // namespace marketgen::exporters
