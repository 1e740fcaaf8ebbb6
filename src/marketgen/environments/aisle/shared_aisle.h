// What all who are in one store in aisles share: the store, opened once for each tool set, and a
// renderer of it.
#pragma once
#include <memory>
#include <mutex>
#include <string>

#include "environments/arena.h"
#include "episodes/aisle/aisle_store.h"
#include "episodes/aisle/aisle_view.h"

namespace marketgen::environments {

// `tools`: a tool set of the station, the first when empty; `doors`: where goals stand. Errors:
// those of Arena::scene and open_aisle_store.
Result<std::shared_ptr<const episodes::AisleStore>> shared_aisle_store(
    Arena& arena,
    const std::string& scene_hash,
    const std::string& tools = {},
    episodes::Doors doors = episodes::Doors::none);

// One renderer of a store for all who stand in it: whoever has the lock shows its own world.
struct SharedAisleView {
  std::mutex mutex;
  std::unique_ptr<episodes::AisleView> view;  // once a picture was asked for
};
// No errors of its own.
Result<std::shared_ptr<SharedAisleView>> shared_aisle_view(Arena& arena,
                                                           const std::string& scene_hash,
                                                           const std::string& tools);

}  // namespace marketgen::environments
