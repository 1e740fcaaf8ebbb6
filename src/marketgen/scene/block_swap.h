// Blocks that change places on shelves (swap_blocks of market-patch/1) in a store that is stocked:
// what stands on shelves of which its plan says nothing, and whether blocks have room where they
// come to stand.
#pragma once
#include <string>

#include "base/result.h"
#include "catalog/catalog.h"
#include "plan/patch.h"
#include "scene/scene.h"

namespace marketgen::scene {

// The plan, with the shelves of swap_blocks in its planogram as they stand; those that it has
// already are as it says. `plan` is the scene's, `source` names the patches in errors. Errors:
// plan.unknown_reference for fixtures and shelves that are not there.
Result<plan::Plan> with_swapped_shelves(plan::Plan plan,
                                        const plan::PatchSet& patches,
                                        const std::string& source,
                                        const Scene& scene,
                                        const catalog::Catalog& catalog);

// Whether the shelves of swap_blocks hold what `swapped`, the plan after the patches, says of them.
// The scene is the one before: its fixtures must be those of the plan. Error:
// planogram.does_not_fit, with how many facings would have room.
Result<void> check_swapped(const plan::Plan& swapped,
                           const plan::PatchSet& patches,
                           const std::string& source,
                           const Scene& scene,
                           const catalog::Catalog& catalog);

}  // namespace marketgen::scene
