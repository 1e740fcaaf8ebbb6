// Frozen episodes: their stores' scenes travel with them, as files, so that later versions of the
// generator and of the catalogue run them in the same stores, with the same goods.
//
//     v1/checkout.jsonl.gz        header: stores/0/scene = {file: scenes/3f…a1.bin.gz, sha256}
//     v1/aisle.jsonl.gz           of the same stores
//     v1/scenes/3f…a1.bin.gz      scene.bin (scene/scene_file.h), packed
//
// A scene has all that stands in the store and the rows of its goods. What else decides an episode
// is rows of this program: the station, the robot and its tools, friction. They cannot travel, so
// the header has their hash, and episodes whose rows have changed are refused.
#pragma once
#include <filesystem>
#include <memory>
#include <string>

#include "catalog/catalog.h"
#include "episodes/episode_spec.h"
#include "scene/scene.h"

namespace marketgen::episodes {

// Beside the episodes' file.
inline constexpr char scenes_folder[] = "scenes";

// Of a store, below the folder of the episodes' file.
std::string frozen_scene_file(const EpisodeStore& store);
// The bytes of that file.
std::string pack_scene(const scene::Scene& scene);

// Rows of goods that were frozen before rows had Product::contents have those of `catalog`: they
// are seen, and no more. Errors: those of read_file, gunzip and decode_scene; episode.other_store
// at the file when it has not the bytes or the scene that the header says.
Result<std::shared_ptr<const scene::Scene>> open_frozen_scene(const EpisodeStore& store,
                                                              const catalog::Catalog& catalog);

// Over the rows of `data` that decide what becomes of the file's episodes: the stations' files,
// friction.json, and all files of robots/ that these name, and those name. Errors: those of
// read_file.
Result<std::string> rows_hash(const std::filesystem::path& data, const EpisodeFile& file);

// Gives the stores' scenes their whole paths, `folder` being that of the file. Error
// input.outside_folder.
Result<void> find_scenes(EpisodeHeader& header,
                         const std::string& source,
                         const std::filesystem::path& folder);

// The same, and error episode.other_rows when the header's rows_hash is not that of `data`.
Result<void> check_frozen(EpisodeFile& file,
                          const std::string& source,
                          const std::filesystem::path& folder,
                          const std::filesystem::path& data);

}  // namespace marketgen::episodes
