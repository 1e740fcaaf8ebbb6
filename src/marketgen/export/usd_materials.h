// Materials of a USD export: surfaces as UsdPreviewSurface, and how what touches rubs.
#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "assets/product_model.h"
#include "base/result.h"
#include "export/exporter.h"
#include "export/usd_geometry.h"
#include "export/usd_text.h"
#include "scene/scene.h"

namespace marketgen::exporters {

// The pictures of an export, each a file beside it.
class UsdPictures {
 public:
  explicit UsdPictures(const scene::Scene& scene) : scene_(&scene) {}

  struct Tiled {
    std::string color, normal, gloss;  // names of files
    float opacity = 1;
  };
  // Returns the file's name.
  std::string add(const std::string& name, std::string_view ending, std::string bytes);
  // Of a row of Scene::materials; they are drawn by take().
  const Tiled& tiled(const catalog::MaterialRow& material);
  const scene::Scene& scene() const { return *scene_; }
  // All of them; materials are drawn side by side. Errors: image.*.
  Result<std::vector<BesideFile>> take();

 private:
  const scene::Scene* scene_;
  std::map<std::string, Tiled> tiled_;           // by the material's id
  std::vector<catalog::MaterialRow> materials_;  // in the order in which they were asked for
  std::vector<BesideFile> files_;
};

// The looks of one asset, equal ones once: materials "look_<n>" in the scope "materials" below it.
class UsdLooks {
 public:
  explicit UsdLooks(UsdPictures& pictures) : pictures_(pictures) {}

  // `picture` is a file of UsdPictures, over the surface once; empty: none.
  int add(const assets::Surface& surface, const std::string& picture = {});
  // A catalogue material, tiled; light plaster when the scene has no such row. No errors, but
  // add_looks() asks for some.
  Result<int> add_tiled(const std::string& id);
  Result<int> add_tiled(const catalog::MaterialRow& material);
  bool textured(int look) const { return !rows_[static_cast<std::size_t>(look)].color.empty(); }

  // The scope, below the open prim at `path`; the second with a contact material of this sliding
  // friction.
  void write(UsdText& out, std::string_view path) const;
  void write(UsdText& out, std::string_view path, double friction) const;
  // Binds the meshes of `shape` to `looks`, by surface; inside the prim that refers to it.
  static void write_bindings(UsdText& out,
                             std::string_view path,
                             const UsdShape& shape,
                             const std::vector<int>& looks);

 private:
  struct Row {
    Vec3f diffuse, emissive;
    float roughness = 0.5F, metallic = 0, opacity = 1;
    std::string color, normal, gloss;  // files
    bool tiled = false;
    friend bool operator==(const Row&, const Row&) = default;
  };
  int add_row(Row row);
  void write_looks(UsdText& out, std::string_view path) const;
  static void write_look(UsdText& out, const std::string& path, const Row& row);

  UsdPictures& pictures_;
  std::vector<Row> rows_;
};

// Of the scope that write() makes below `path`.
std::string usd_contact_material(std::string_view path);

}  // namespace marketgen::exporters
