// A planogram's file, read for a store or for a scene that is being made.
#pragma once
#include <filesystem>

#include "base/result.h"
#include "scene/planogram_file.h"
#include "store/store.h"

namespace marketgen::store {

// Errors: io.*, input.*, and those of scene::read_planogram.
Result<scene::PlanogramFile> read_planogram_file(const std::filesystem::path& file,
                                                 const scene::Scene& scene,
                                                 const plan::Plan& plan,
                                                 const catalog::Catalog& catalog);
inline Result<scene::PlanogramFile> read_planogram_file(const std::filesystem::path& file,
                                                        const Store& store,
                                                        const catalog::Catalog& catalog) {
  return read_planogram_file(file, store.scene, store.plan, catalog);
}

}  // namespace marketgen::store
