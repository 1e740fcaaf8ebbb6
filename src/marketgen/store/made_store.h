// A store that was made and lies in no folder yet: to be looked at before one is kept.
#pragma once
#include <filesystem>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "catalog/catalog.h"
#include "store/store.h"

namespace marketgen::store {

// Its folder is empty, and its manifest has no digests.
struct MadeStore {
  Store store;
  StoreReport report;
  std::vector<intake::PlannerFile> planner_files;  // that belong into its folder
};

// What create_store would save; `folder` and `previews` of the options are not looked at. Errors:
// those of create_store but for the folder's.
Result<MadeStore> made_store(const CreateOptions& options,
                             const catalog::Catalog& catalog,
                             Progress& progress = silent_progress());

// Writes it as a folder that must not exist, or be empty. Errors: io.*.
Result<Created> save_made(const MadeStore& made,
                          const std::filesystem::path& folder,
                          bool previews,
                          const catalog::Catalog& catalog,
                          Progress& progress = silent_progress());

}  // namespace marketgen::store
