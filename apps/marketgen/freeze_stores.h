// Gives episodes their stores along, as files beside theirs.
#pragma once
#include <filesystem>

#include "environments/arena.h"
#include "environments/travelling_stores.h"
#include "io/output.h"

namespace marketgen::app {

// Puts the scenes of all stores of the header below the folder of `output`, where the episodes will
// lie, and their sums and the rows' hash into the header. Errors: usage.bad_flag where another
// version's scene of a store lies there; those of Arena::scene, read_file and rows_hash.
Result<void> freeze_stores(const std::filesystem::path& data,
                           const environments::NamedStores& named,
                           environments::Arena& arena,
                           const std::filesystem::path& output,
                           io::Outputs& outputs,
                           episodes::EpisodeFile& file);

}  // namespace marketgen::app
