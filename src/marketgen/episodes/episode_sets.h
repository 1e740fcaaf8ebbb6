// The sets of episodes that come with the program, by name: "pool/aisle" for
// data/benchmark/pool/aisle.jsonl, packed or not.
#pragma once
#include <filesystem>
#include <map>
#include <string>

#include "base/result.h"

namespace marketgen::episodes {

// Below `data`, which is usually data_folder().
std::map<std::string, std::filesystem::path> episode_sets(const std::filesystem::path& data);

// A file as it was named, else the set of that name. Error input.not_found, which lists the sets.
Result<std::filesystem::path> find_episode_file(const std::filesystem::path& named,
                                                const std::filesystem::path& data);

}  // namespace marketgen::episodes
