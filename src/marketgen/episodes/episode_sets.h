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

// The name of the set that lies there; empty for any other file, a copy of a set's included.
std::string set_of_file(const std::filesystem::path& file, const std::filesystem::path& data);

// Whether a file of a set, `name` below its folder, is the one of the folder's SHA256SUMS (lines of
// sha256sum). A folder without such a file is not looked at. Errors: episode.changed_set when it is
// another, or is not listed; those of read_file and sha256_of_file.
Result<void> check_set_file(const std::filesystem::path& folder, const std::string& name);

}  // namespace marketgen::episodes
