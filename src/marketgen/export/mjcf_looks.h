// What the goods and the floor of an MJCF file look like: files beside it.
// MuJoCo gives a geom one picture: see export/goods_sheets.h. Packs of one shape share a mesh.
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "export/exporter.h"
#include "export/mjcf_text.h"
#include "scene/scene.h"

namespace marketgen::exporters {

class MjcfLooks {
 public:
  // Of the SKUs that stand in the scene. Errors: assets.*, image.*.
  static Result<MjcfLooks> make(const scene::Scene& scene);

  void write_assets(XmlText& out) const;    // inside <asset>
  void write_defaults(XmlText& out) const;  // inside <default>: a class "look/<sku>" each
  const std::string& floor() const { return floor_; }  // a material's name; empty: none
  const std::vector<BesideFile>& files() const { return files_; }

 private:
  struct Goods {
    std::string sku, mesh;
  };
  void add_mesh(const std::string& sku, const std::string& obj);
  Result<void> add_floor(const scene::Scene& scene);

  std::vector<Goods> goods_;
  std::vector<std::string> meshes_;  // names of files, without ending
  std::string floor_;
  double floor_extent_m_ = 1;
  std::vector<BesideFile> files_;
};

}  // namespace marketgen::exporters
