// Who says what an outside model is: a function from what can be seen and read of the model to an
// annotation. The offline one needs nothing but the catalogue; assets/import/vlm_annotator.h asks a
// vision-language model.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "base/result.h"
#include "catalog/asset_database.h"
#include "catalog/asset_file.h"
#include "geometry/image.h"

namespace marketgen::assets {

struct AssetEvidence {
  std::string file_name;           // "TomatoSoup_can.glb"
  std::vector<std::string> parts;  // names of nodes, meshes and materials
  std::array<int, 3> size_mm{};    // width, depth, height
  catalog::AssetLook look;
  const std::vector<Image>* pictures = nullptr;  // the model's own; valid during the call
};

using AssetAnnotator = std::function<Result<catalog::AssetAnnotation>(const AssetEvidence&)>;

// Words of the names are looked up among the goods (catalog/asset_database.h); the ten best vote,
// each with its score, for category, subcategory and storage. Words that name a shape or a
// material ("jar", "glass") count before the vote; so do metal and clear surfaces for the
// material. Both arguments must outlive the annotator. It never fails: what it cannot tell stays
// empty.
AssetAnnotator offline_annotator(const catalog::Catalog& catalog,
                                 const catalog::AssetDatabase& database);

// Names as words: "TomatoSoup_can.001" is "tomato soup can". Words that modelling programs make
// up ("mesh", "object", "default") and numbers are left out.
std::vector<std::string> words_of_names(const std::vector<std::string>& names);

}  // namespace marketgen::assets
