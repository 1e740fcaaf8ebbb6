// Writing a store folder: everything in it, whole or not at all.
#pragma once
#include <string_view>
#include <vector>

#include "base/result.h"
#include "io/file.h"
#include "store/stages.h"
#include "store/store.h"

namespace marketgen::store {

// Whether opening would take the stages' files: for those who only try a store.
Result<void> check_stages(const plan::Plan& plan,
                          const scene::Scene& scene,
                          const catalog::Catalog& catalog);

// The first hard violation as an error: layout.violation.
Result<void> require_no_hard_violation(const std::vector<layout::Violation>& rules);

// What of a manifest follows from plan, scene and seed; brief and wishes are the caller's.
Manifest manifest_of(const plan::Plan& plan,
                     const scene::Scene& scene,
                     const catalog::Catalog& catalog,
                     std::uint64_t seed);

// Writes plan, layout, scene, planogram, meshes, pictures when they are asked for, manifest and
// report into the draft and puts it in its place. `created` comes without digests and times.
Result<Created> save_store(io::FolderDraft& draft,
                           const plan::Plan& plan,
                           const scene::Scene& scene,
                           Created created,
                           bool previews,
                           const catalog::Catalog& catalog,
                           Stages& stages);

}  // namespace marketgen::store
