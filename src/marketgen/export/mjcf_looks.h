// What the goods and the floor of an MJCF file look like: files beside it.
//
// MuJoCo gives a geom one picture, and a pack has several finishes. So each SKU has one sheet: its
// label above, a row of plain swatches below, one for every surface that is not printed. Packs of
// one shape share a mesh.
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "export/exporter.h"
#include "export/mjcf_text.h"
#include "geometry/image.h"
#include "geometry/mesh.h"
#include "scene/scene.h"

namespace marketgen::exporters {

// A mesh whose corners show where on the sheet each has its look.
struct SheetLook {
  Mesh mesh;
  Image sheet;
};

// `label` is empty for goods without print. `materials`: rows of the tiled materials that surfaces
// name; these show as their ground colour. Error: assets.bad_row for a colour that is none.
Result<SheetLook> sheet_look(const assets::ProductModel& model,
                             const Image& label,
                             const std::vector<catalog::MaterialRow>& materials);

// Wavefront OBJ: positions, texture coordinates (v upwards), normals.
std::string obj_text(const Mesh& mesh);

class MjcfLooks {
 public:
  // Of the SKUs that stand in the scene. Errors: assets.*, image.*.
  static Result<MjcfLooks> make(const scene::Scene& scene);

  void write_assets(MjcfText& out) const;    // inside <asset>
  void write_defaults(MjcfText& out) const;  // inside <default>: a class "look/<sku>" each
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
