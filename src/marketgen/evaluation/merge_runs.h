// The shards of one run as a whole.
#pragma once
#include <filesystem>
#include <vector>

#include "base/result.h"
#include "evaluation/finished_run.h"

namespace marketgen::evaluation {

// In any order; the merged run is at `folder`, which is not looked at. Episodes that could not be
// run are kept as such. Errors, which name the folders: results.not_comparable when they are of
// other episodes, or of another policy, version, commit or realism; results.overlap when two have
// the same episode; results.incomplete when episodes are in none.
Result<FinishedRun> merge_runs(const std::vector<FinishedRun>& shards,
                               const std::filesystem::path& folder);

// The same with what lies in `folders`, written to `folder`, which is looked at first. `set`: of
// the program's, where the shards ran a copy of it; else they say so themselves. Errors: those of
// read_runs and write_run, too.
Result<FinishedRun> merge_folders(const std::vector<std::string>& folders,
                                  const std::filesystem::path& folder,
                                  const std::string& set = {});

}  // namespace marketgen::evaluation
