// Stores that are in no folder: made of what travels with episodes, which is their scene (frozen
// sets) or their plan.
#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/result.h"
#include "episodes/episode_spec.h"
#include "store/open_stores.h"

namespace marketgen::environments {

// Those that a command names: folders, and files or sets of episodes, for all stores of theirs.
struct NamedStores {
  store::OpenedStores opened;
  std::string frozen;  // the first name whose stores may not come of their plans any more
  std::map<std::string, episodes::FrozenScene> scenes = {};  // of frozen ones, by scene_hash
};

// In the order of `names`. Errors: those of read_episode_header, Arena::scene and open_stores.
Result<NamedStores> open_named_stores(const std::vector<std::string>& names, catalog::Catalog rows);

// `opened`, and behind its stores those of these scenes that `episodes` (a file, or a set's name;
// may be empty) or a set of the program has, in the order in which these have them. Scenes that are
// nowhere are left out. Errors: those of read_episode_header, io::data_folder and Arena::scene.
Result<store::OpenedStores> with_travelling_stores(store::OpenedStores opened,
                                                   std::set<std::string> scenes,
                                                   const std::string& episodes);

}  // namespace marketgen::environments
