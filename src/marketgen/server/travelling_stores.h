// Stores of recorded episodes that are in no folder: made of what travels with sets of episodes,
// which is their scene (frozen sets) or their plan.
#pragma once
#include <set>
#include <string>

#include "base/result.h"
#include "store/open_stores.h"

namespace marketgen::server {

// `opened`, and behind its stores those of these scenes that `episodes` (a file, or a set's name;
// may be empty) or a set of the program has, in the order in which these have them. Scenes that are
// nowhere are left out. Errors: those of read_episode_header, io::data_folder and Arena::scene.
Result<store::OpenedStores> with_travelling_stores(store::OpenedStores opened,
                                                   std::set<std::string> scenes,
                                                   const std::string& episodes);

}  // namespace marketgen::server
