#include "assets/import/import_pictures.h"

#include <algorithm>

#include <fmt/format.h>

#include "assets/import/model_look.h"
#include "assets/own_pack.h"
#include "assets/print/label_sheet.h"
#include "assets/print/pack_pictures.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/pack_shape.h"
#include "catalog/own_faces.h"
#include "catalog/usual_pack.h"
#include "io/file.h"
#include "io/json.h"

namespace marketgen::assets {
namespace fs = std::filesystem;
namespace {

// One import of pictures on its way.
class PictureImporter {
 public:
  PictureImporter(const PictureImport& import, const catalog::Catalog& catalog)
      : import_(import), catalog_(catalog) {}

  Result<PicturedAsset> run(const AssetAnnotator& annotator) {
    MARKETGEN_CHECK(check_stated(import_.row));
    row().archetype = import_.archetype;
    row().size_mm = import_.size_mm;
    row().sku = "own";  // until the row is named; errors say it
    MARKETGEN_CHECK(check_shape());
    MARKETGEN_CHECK(read());
    MARKETGEN_CHECK(fit());
    MARKETGEN_TRY(const ProductModel model, make_pack_shape(row()));
    MARKETGEN_CHECK(annotate(annotator));
    StatedRow stated = import_.row;  // the shape says more of the material than any name
    if (stated.material.empty())
      stated.material = catalog::usual_material(catalog_.products, row());
    MARKETGEN_CHECK(name_row(asset_.file, stated, row().archetype, catalog_, source_place()));
    row().label.primary = catalog::border_color(pictures_[0]);
    estimate_row(asset_.file, import_.row, marketgen::volume_of(model.mesh), catalog_);
    MARKETGEN_CHECK(check_asset(asset_.file, catalog_));
    return std::move(asset_);
  }

 private:
  catalog::Product& row() { return asset_.file.product; }
  std::string source_place() const { return import_.pictures[0].file.string(); }

  Result<void> check_shape() {
    if (has_own_mesh(row()) || sheet_kind_of(row().archetype).ok()) return {};
    return unknown_archetype(row().archetype, "--archetype");
  }

  Result<void> read() {
    row().faces.emplace();
    for (const SidePicture& side : import_.pictures) {
      MARKETGEN_TRY(const std::string bytes, io::read_file(side.file, catalog::max_face_bytes));
      MARKETGEN_TRY(catalog::ReadyFace face, catalog::ready_face(bytes, side.file.string()));
      if (asset_.file.source.file.empty()) {
        asset_.file.source.file = side.file.filename().string();
        asset_.file.source.sha256 = io::sha256_hex(bytes);
      }
      const auto* slot =
          std::ranges::find(catalog::face_slots, side.side, &catalog::FaceSlot::name);
      const std::string name = fmt::format("{}{}", side.side, face.ending);
      (*row().faces).*slot->file = name;
      asset_.pictures.push_back({name, std::move(face.bytes)});
      pictures_.push_back(std::move(face.picture));
    }
    return {};
  }

  // Whether they fit the shape and its size.
  Result<void> fit() {
    PixelsBySide pixels;
    for (std::size_t i = 0; i < pictures_.size(); ++i) {
      const SidePicture& side = import_.pictures[i];
      pixels[side.side] = {{pictures_[i].width, pictures_[i].height}, side.file.string()};
    }
    MARKETGEN_TRY(const std::vector<FaceFit> fits, face_fits(row(), pixels));
    MARKETGEN_CHECK(check_fits(fits));
    asset_.file.notes = face_notes(fits);
    return {};
  }

  Result<void> annotate(const AssetAnnotator& annotator) {
    asset_.file.look = look_of(pictures_);
    AssetEvidence evidence;
    evidence.file_name = asset_.file.source.file;
    if (!import_.row.name.empty()) evidence.parts = {import_.row.name};
    evidence.size_mm = row().size_mm;
    evidence.look = asset_.file.look;
    evidence.pictures = &pictures_;
    MARKETGEN_TRY(asset_.file.annotation, annotator(evidence));
    asset_.file.annotation.archetype = row().archetype;
    return {};
  }

  const PictureImport& import_;
  const catalog::Catalog& catalog_;
  std::vector<Image> pictures_;  // in the order of import_.pictures
  PicturedAsset asset_;
};

}  // namespace

Result<PicturedAsset> import_pictures(const PictureImport& import,
                                      const catalog::Catalog& catalog,
                                      const AssetAnnotator& annotator) {
  return PictureImporter(import, catalog).run(annotator);
}

Result<void> write_asset(const PicturedAsset& asset, const fs::path& folder) {
  MARKETGEN_TRY(io::FolderDraft draft, io::FolderDraft::begin(folder));
  for (const PicturedAsset::File& picture : asset.pictures)
    MARKETGEN_CHECK(io::write_file(draft.folder() / picture.name, picture.bytes));
  MARKETGEN_CHECK(io::write_file(draft.folder() / asset_file_name, io::write_json(asset.file)));
  return draft.commit();
}

}  // namespace marketgen::assets
