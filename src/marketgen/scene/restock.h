// Single shelves stocked anew in a finished scene: what build_scene makes of the changed plan, to
// the last bit, without making the rest of the store again.
#pragma once
#include <optional>
#include <vector>

#include "base/result.h"
#include "catalog/catalog.h"
#include "plan/plan.h"
#include "scene/scene.h"

namespace marketgen::scene {

// The shelves that `after` stocks otherwise than `before`. Nothing when more than that differs, or
// when a shelf decides what stands elsewhere: shelves given back to their zone, products of the
// user's own or that a zone must stock, pinned products, zones with misplaced goods, heaps where
// boards are fitted (which of them is never empty is planned with the zone's whole range). `scene`
// is that of `before`.
std::optional<std::vector<plan::StockedShelf>> shelves_changed(const plan::Plan& before,
                                                               const plan::Plan& after,
                                                               const catalog::Catalog& catalog,
                                                               const Scene& scene);

// The scene with these shelves as they say. `plan` is the changed one. Errors: of build_scene.
Result<Scene> restocked(Scene scene,
                        const std::vector<plan::StockedShelf>& shelves,
                        const plan::Plan& plan,
                        const catalog::Catalog& catalog);

}  // namespace marketgen::scene
