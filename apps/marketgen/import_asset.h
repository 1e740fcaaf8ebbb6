// `marketgen assets import`: an outside model, or pictures of a pack's sides, into a library of
// one's own.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "base/result.h"
#include "catalog/catalog.h"
#include "catalog/own_faces.h"
#include "command.h"

namespace marketgen::app {

struct ImportFlags {
  std::string model, folder, unit = "m", up = "y";
  std::array<std::string, catalog::face_slots.size()> faces;  // files, in the order of face_slots
  std::string archetype, size_mm;                             // of a pack that has faces
  std::string name, category, subcategory, material;
  double mass_kg = 0;  // 0: estimate it
  bool coacd = true;
  std::string vlm, vlm_url, vlm_record, vlm_replay;  // without --vlm: offline
};

void add_import_flags(CLI::App& sub, ImportFlags& flags);

// Errors: usage.bad_flag; those of assets::import_asset() and assets::import_pictures().
Result<void> import_one(const ImportFlags& flags,
                        const catalog::Catalog& catalog,
                        const CommonFlags& common);

// Before any work: whether the folders that were named have a place, and whether there is something
// to import. Errors: usage.bad_flag, store.exists, io.cannot_write.
Result<void> probe_import(const ImportFlags& flags);

}  // namespace marketgen::app
