// What an outside model looks like, and whether its mesh is sound: measured, without a guess.
#pragma once
#include "catalog/asset_file.h"
#include "geometry/image.h"
#include "io/model_file.h"

namespace marketgen::assets {

// Colours of pictures and materials by the area that shows them; the means of roughness, metal and
// transparency likewise. At most six colours. Factors on a picture are expected to be painted into
// it (merge_pictures). Deterministic.
catalog::AssetLook look_of(const io::OutsideModel& model);

// The same of pictures alone: their colours, each picture as much as another.
catalog::AssetLook look_of(const std::vector<Image>& pictures);

// Edges that do not join two triangles, once each way, after welding positions within a
// micrometre: 0 for a watertight mesh. Error: model.bad_file when thousands of vertices crowd in
// one spot.
Result<int> open_edges_of(const Mesh& mesh, const std::string& where);

}  // namespace marketgen::assets
