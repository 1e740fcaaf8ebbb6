// Which runs may be put side by side.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "evaluation/finished_run.h"

namespace marketgen::evaluation {

// Of the same episodes, version and realism: they can be compared. Error results.not_comparable at
// the folder that differs from the first, with what to do.
Result<void> check_same_episodes(const std::vector<FinishedRun>& runs);
// The same, but for the realism.
Result<void> check_same_but_realism(const std::vector<FinishedRun>& runs);
// Of the same version and realism, on whichever episodes. The same error.
Result<void> check_same_world(const std::vector<FinishedRun>& runs);
// Of the same policy and commit, too: parts of one run. The same error.
Result<void> check_one_run(const std::vector<FinishedRun>& runs);

// The program's set of which they all are; none when some are of another file, a copy included.
std::optional<std::string> common_set(const std::vector<FinishedRun>& runs);

}  // namespace marketgen::evaluation
