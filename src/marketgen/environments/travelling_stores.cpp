#include "environments/travelling_stores.h"

#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

#include "environments/arena.h"
#include "episodes/episode_header.h"
#include "episodes/episode_sets.h"
#include "io/file.h"
#include "store/store.h"

namespace marketgen::environments {
namespace {

namespace fs = std::filesystem;

// A file of episodes, and what its stores are called, which are in no folder: as the file, or as
// the sets (v1, pool), several of which are of the same stores.
struct EpisodesOf {
  fs::path file, called;
};

// The user's own first.
std::vector<EpisodesOf> files_with_stores(const std::string& episodes, const fs::path& data) {
  std::vector<EpisodesOf> files;
  if (!episodes.empty()) files.push_back({episodes, episodes});
  for (const auto& [name, file] : episodes::episode_sets(data))
    files.push_back({name, fs::path(name).parent_path()});
  return files;
}

// It has all that a page wants of a store.
std::shared_ptr<const store::Store> made_of(const episodes::EpisodeStore& row,
                                            const scene::Scene& scene,
                                            const fs::path& called) {
  auto made = std::make_shared<store::Store>();
  made->folder = called;
  made->manifest.name = row.name;
  made->manifest.seed = row.seed;
  made->manifest.own = row.own;
  made->manifest.scene_hash = row.scene_hash;
  made->manifest.look_hash = scene::look_hash(scene);
  made->plan = row.plan;
  made->scene = scene;
  return made;
}

// A file, or the name of a set that no folder has.
bool names_episodes(const std::string& name, const fs::path& data) {
  std::error_code failed;
  if (fs::is_directory(name, failed)) return false;
  return fs::is_regular_file(name, failed) || episodes::episode_sets(data).contains(name);
}

using Stores = std::vector<std::shared_ptr<const store::Store>>;

// All stores of a file or set of episodes; notes in `known` what is frozen of them.
Result<Stores> stores_of_episodes(const std::string& name,
                                  const fs::path& data,
                                  const catalog::Catalog& rows,
                                  NamedStores& known) {
  MARKETGEN_TRY(const episodes::EpisodeHeader header, episodes::read_episode_header(name, data));
  Arena arena(data, header, rows);
  Stores stores;
  for (const episodes::EpisodeStore& row : header.stores) {
    if (row.scene && known.frozen.empty()) known.frozen = name;
    if (row.scene) known.scenes[row.scene_hash] = *row.scene;
    MARKETGEN_TRY(const auto scene, arena.scene(row.scene_hash));
    stores.push_back(made_of(row, *scene, name));
  }
  return stores;
}

}  // namespace

Result<NamedStores> open_named_stores(const std::vector<std::string>& names,
                                      catalog::Catalog rows) {
  MARKETGEN_TRY(const fs::path data, io::data_folder());
  NamedStores named;
  Stores stores;
  for (const std::string& name : names) {
    Stores found;
    if (names_episodes(name, data)) {
      MARKETGEN_TRY(found, stores_of_episodes(name, data, rows, named));
    } else {
      MARKETGEN_TRY(store::Store store, store::open_store(name, rows));
      found.push_back(std::make_shared<const store::Store>(std::move(store)));
    }
    for (auto& store : found)
      MARKETGEN_CHECK(store::add_distinct(stores, std::move(store), name));
  }
  named.opened = store::opened_stores(std::move(stores), std::move(rows));
  return named;
}

Result<store::OpenedStores> with_travelling_stores(store::OpenedStores opened,
                                                   std::set<std::string> scenes,
                                                   const std::string& episodes) {
  if (scenes.empty()) return opened;
  MARKETGEN_TRY(const fs::path data, io::data_folder());
  std::vector<std::shared_ptr<const store::Store>> stores = opened.stores;
  for (const auto& [file, called] : files_with_stores(episodes, data)) {
    if (scenes.empty()) break;
    MARKETGEN_TRY(const episodes::EpisodeHeader header, episodes::read_episode_header(file, data));
    Arena arena(data, header, opened.rows);
    for (const episodes::EpisodeStore& row : header.stores) {
      if (scenes.erase(row.scene_hash) == 0) continue;
      MARKETGEN_TRY(const auto scene, arena.scene(row.scene_hash));
      stores.push_back(made_of(row, *scene, called));
    }
  }
  return store::opened_stores(std::move(stores), std::move(opened.rows));
}

}  // namespace marketgen::environments
