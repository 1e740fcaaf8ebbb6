// What a page is given to draw a store with; docs/viewer.md says what each file holds.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "assets/product_model.h"
#include "base/progress.h"
#include "base/result.h"
#include "render/light/lit_world.h"
#include "scene/scene.h"

namespace marketgen::server {

struct ViewFile {
  std::string name;  // below the store's address: "room.bin", "textures/3.jpg"
  std::string type;  // content type
  std::string bytes;
};

// Where every product stands: no light, so that it is there at once.
ViewFile goods_table(const scene::Scene& scene);
// The light on every product, as the renderer has stored it.
ViewFile goods_light(const render::raytrace::LitWorld& lit, const scene::Scene& scene);

// The far meshes of all SKUs that stand somewhere, and the pages of their labels. Errors: those of
// make_product_model and library_label; internal.interrupted.
Result<std::vector<ViewFile>> goods_meshes(const scene::Scene& scene, Progress& progress);
// The same of these products, a row each. Errors: the same.
Result<std::vector<ViewFile>> product_meshes(const std::vector<catalog::Product>& products,
                                             const std::vector<catalog::MaterialRow>& materials,
                                             assets::Detail detail);
// The mesh of one SKU, a row of the scene's catalogue. Errors: those of make_product_model.
Result<ViewFile> product_mesh(const scene::Scene& scene, std::uint32_t sku, assets::Detail detail);

// Everything that stands still but goods, with its light, and its textures. Errors: image.*.
Result<std::vector<ViewFile>> room_files(const render::raytrace::LitWorld& lit,
                                         const scene::Scene& scene);

}  // namespace marketgen::server
