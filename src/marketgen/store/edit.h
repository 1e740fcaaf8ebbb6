// Editing a store: patches on its plan, and a new folder in which all that they do not name is as
// it was.
//
// An edit never writes into the folder that it edits: undo is keeping that. Zones that no patch
// names, and whose floor stays as it is, keep every fixture and every product to the last bit
// (layout/kept_layout.h); this is looked at before anything is written. Nothing is repaired: an
// edit that breaks a hard rule which the store has kept is refused.
#pragma once
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "catalog/catalog.h"
#include "plan/patch.h"
#include "store/scene_changes.h"
#include "store/store.h"

namespace marketgen::store {

// A store's plan and layout after some patches; nothing is stocked or written.
struct Replanned {
  plan::Plan plan;
  layout::Layout layout;
  std::set<std::string> furnished;          // zones that had to be furnished anew
  std::vector<layout::Violation> offences;  // hard rules that are broken and were not before
};

// `source` names the patches in errors. Errors: of plan::apply_patches and layout::make_layout.
Result<Replanned> replan(const Store& store,
                         const plan::PatchSet& patches,
                         const std::string& source,
                         const catalog::Catalog& catalog);

// The broken rule as an error, with what helps: layout.violation.
Error error_of(const layout::Violation& offence);

// The store's report; measured anew when its file is gone, which no digest protects.
Result<StoreReport> report_before(const Store& store, const catalog::Catalog& catalog);

// What is done to a store in one step.
struct EditStep {
  plan::PatchSet patches;
  std::string source;  // of the patches, for errors: "shelves.json"
  std::string words;   // that were said, for the manifest
};

// A store after an edit, in memory. Its folder is that of the store it was made from, and its
// manifest has the edit but no digests.
struct EditedStore {
  Store store;
  StoreReport report;
  SceneChanges changes;
  std::vector<std::string> lost;  // wishes that were met before and no longer are
};

// `report` is the store's own. Errors: of replan; layout.violation when a hard rule is newly
// broken; scene.wrong_version when the store cannot be made again from this catalogue by this
// version.
Result<EditedStore> edited_store(const Store& store,
                                 const StoreReport& report,
                                 const EditStep& step,
                                 const catalog::Catalog& catalog,
                                 Progress& progress = silent_progress());

// Writes it as a folder that must not exist, or be empty. Errors: io.*.
Result<Created> save_edited(const EditedStore& edited,
                            const std::filesystem::path& folder,
                            bool previews,
                            const catalog::Catalog& catalog,
                            Progress& progress = silent_progress());

// Whether `generate --plan` with the store's plan and seed makes this layout. It does not where
// zones that an edit let stand were furnished otherwise than the plan alone has them.
Result<bool> follows_from_plan(const Store& store, const catalog::Catalog& catalog);

struct EditOptions {
  std::filesystem::path folder;  // must not exist, or be empty
  EditStep step;
  bool previews = true;
};

struct Edited {
  Created created;
  SceneChanges changes;
  std::vector<std::string> lost;  // wishes that were met before and no longer are
};

// Errors: of edited_store and save_edited. Nothing is left behind when it fails.
Result<Edited> edit_store(const Store& store,
                          const EditOptions& options,
                          const catalog::Catalog& catalog,
                          Progress& progress = silent_progress());

// "shop" -> "shop-edit-1", "shop-edit-1" -> "shop-edit-2": the first that is not there.
std::filesystem::path next_edit_folder(const std::filesystem::path& store);

}  // namespace marketgen::store
