// Takes an outside model (GLB, OBJ) into a user's library: checks its scale and its mesh, makes
// contact pieces, estimates mass and friction, and has it annotated.
#pragma once
#include <filesystem>
#include <string>

#include "assets/import/asset_annotator.h"
#include "assets/import/asset_row.h"
#include "base/result.h"
#include "catalog/asset_file.h"

namespace marketgen::assets {

// Which of the file's axes points up.
enum class UpAxis { y, z };
constexpr std::array<std::string_view, 2> names_of(UpAxis) {
  return {"y", "z"};
}

struct ImportOptions {
  catalog::LengthUnit unit = catalog::LengthUnit::m;
  UpAxis up = UpAxis::y;
  StatedRow row;
  bool coacd = true;  // false: contact pieces by our own means
};

struct ImportedAsset {
  catalog::AssetFile file;
  std::string model;  // the bytes of file.product.mesh: a GLB with its contact pieces
};

// Error codes: those of read_model_file(); model.bad_scale when a side is not 5 mm to 1.5 m, with
// the unit that would fit; catalog.unknown_kind for a category that is none, or when none was
// given and the names say nothing; model.bad_file when it encloses nothing. Holes are reported in
// notes. The same file and options give the same asset.
Result<ImportedAsset> import_asset(const std::filesystem::path& file,
                                   const ImportOptions& options,
                                   const catalog::Catalog& catalog,
                                   const AssetAnnotator& annotator);

// Writes asset.json and the model into a new folder. Errors: store.exists, io.cannot_write.
Result<void> write_asset(const ImportedAsset& asset, const std::filesystem::path& folder);

}  // namespace marketgen::assets
