// Whether episodes can be run, as far as their file alone tells: read, edited by hand or made by
// somebody else's program.
#pragma once
#include <filesystem>
#include <string>

#include "episodes/episode_spec.h"

namespace marketgen::episodes {

// Of one episode by itself, at "WHERE/FIELD". Errors: episode.bad_value for an attitude that is no
// unit quaternion, a camera or a field that the track does not have, a category of
// what is no goal, the same goal twice; episode.impossible for no goals, or more of a product than
// lie in the basket; those of check_certificate and check_witness.
Result<void> check_episode(const EpisodeSpec& spec, const std::string& where);

// Of a whole file, at "SOURCE:LINE/FIELD" of the first fault. Errors: those of check_episode;
// episode.duplicate_id; catalog.unknown_sku and catalog.duplicate_sku against the header's
// products; episode.other_store when an episode is of none of the header's stores, or a store's
// plan is not the one of its hash.
Result<void> check_episodes(const EpisodeFile& file, const std::string& source);

// Whether the tracks have the robots and tools that the episodes are for; `data` is usually
// data_folder(). Errors: robot.unknown at "SOURCE:LINE/FIELD"; those of the stations' files.
Result<void> check_robots(const EpisodeFile& file,
                          const std::string& source,
                          const std::filesystem::path& data);

}  // namespace marketgen::episodes
