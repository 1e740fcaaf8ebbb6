// One run as a self-contained HTML page: its figures, what failed and why, what was pushed, how
// long everything took, and which goods were reached.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "catalog/catalog.h"
#include "evaluation/finished_run.h"
#include "evaluation/strips.h"

namespace marketgen::evaluation {

// Part of a page; loads nothing, and every text of a file is escaped. What of the run is missing is
// said. `catalog` has the goods' categories and shapes.
std::string run_section(const FinishedRun& run,
                        const std::vector<StripPicture>& strips,
                        const catalog::Catalog& catalog);

// A page of one run or several; with a leaderboard where there are several, which then must be
// comparable and complete. Errors: those of leaderboard_of and strips_of.
Result<std::string> runs_html(const std::vector<FinishedRun>& runs,
                              const catalog::Catalog& catalog);

}  // namespace marketgen::evaluation
