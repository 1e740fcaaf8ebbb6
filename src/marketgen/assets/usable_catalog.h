// The catalogue as programs use it: from the data folder, with users' own rows, every product with
// a shape that collides and pictures that fit it.
#pragma once
#include <filesystem>
#include <vector>

#include "base/result.h"
#include "catalog/catalog.h"

namespace marketgen::assets {

// `extra`: CSV, JSON or asset.json files. Errors: those of data_folder(), load_catalog(),
// collision_of() and check_faces().
Result<catalog::Catalog> usable_catalog(const std::vector<std::filesystem::path>& extra = {});

}  // namespace marketgen::assets
