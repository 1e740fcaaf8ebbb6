// A planogram's file, read for a store.
#pragma once
#include <filesystem>

#include "base/result.h"
#include "scene/planogram_file.h"
#include "store/store.h"

namespace marketgen::store {

// Errors: io.*, input.*, and those of scene::read_planogram.
Result<scene::PlanogramFile> read_planogram_file(const std::filesystem::path& file,
                                                 const Store& store,
                                                 const catalog::Catalog& catalog);

}  // namespace marketgen::store
