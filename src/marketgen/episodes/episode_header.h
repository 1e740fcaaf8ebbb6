// The first line of a file of episodes: what can be known of it without reading them all.
#pragma once
#include <filesystem>

#include "base/result.h"
#include "episodes/episode_spec.h"

namespace marketgen::episodes {

// Of a file, packed with gzip or not, or of a set by its name; the scenes of its stores with their
// whole paths. Says nothing of the episodes, nor whether they can be run by this program's rows
// (check_frozen). Errors: those of find_episode_file, read_file, gunzip, read_json and
// path_within.
Result<EpisodeHeader> read_episode_header(const std::filesystem::path& named,
                                          const std::filesystem::path& data);

}  // namespace marketgen::episodes
