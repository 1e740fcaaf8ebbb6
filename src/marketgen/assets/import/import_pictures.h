// Takes pictures of a pack's sides into a user's library: an asset of one of our shapes that shows
// them.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "assets/import/asset_annotator.h"
#include "assets/import/asset_row.h"
#include "base/result.h"
#include "catalog/asset_file.h"

namespace marketgen::assets {

// The picture of one side: `side` is a name of catalog::face_slots.
struct SidePicture {
  std::string side;
  std::filesystem::path file;
};

struct PictureImport {
  std::vector<SidePicture> pictures;  // one at least, no side twice
  std::string archetype;
  std::array<int, 3> size_mm{};  // width, depth, height
  StatedRow row;
};

struct PicturedAsset {
  catalog::AssetFile file;
  struct File {
    std::string name;  // "front.jpg", as file.product.faces has it
    std::string bytes;
  };
  std::vector<File> pictures;  // made ready, see catalog/own_faces.h
};

// The first picture stands for the source. Pictures that are stretched are told of in notes.
// Errors: those of catalog::ready_face() and check_faces(), with the file as place;
// catalog.unknown_kind for a shape or category that is none; assets.bad_row, json.*. The same files
// and options give the same asset.
Result<PicturedAsset> import_pictures(const PictureImport& import,
                                      const catalog::Catalog& catalog,
                                      const AssetAnnotator& annotator);

// Writes asset.json and the pictures into a new folder. Errors: store.exists, io.cannot_write.
Result<void> write_asset(const PicturedAsset& asset, const std::filesystem::path& folder);

}  // namespace marketgen::assets
