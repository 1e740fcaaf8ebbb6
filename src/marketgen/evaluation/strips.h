// Film strips of a run's episodes: a few small pictures each, in strips/ of its folder.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "catalog/catalog.h"
#include "episodes/episode_spec.h"
#include "evaluation/finished_run.h"

namespace marketgen::evaluation {

// A run's results by their failure code, each in the order of the episodes; "None" are those that
// reached all their goals.
using ResultsByCode = std::map<std::string, std::vector<const episodes::EpisodeResult*>>;
ResultsByCode results_by_code(const FinishedRun& run);

struct StripPicture {
  std::string episode, media_type, bytes;
};
// Those that `run.folder` has, strips/EPISODE.png or .jpg, `at_most` of each code. Errors: io.*.
Result<std::vector<StripPicture>> strips_of(const FinishedRun& run, std::size_t at_most);

// Runs the first `at_most` episodes of each code again, as far as they have no strip and were run
// to their end, and writes strips/EPISODE.png, each as it is done. Errors: usage.bad_flag when the
// run cannot be repeated from its record alone: its policy is written in Python, or its realism is
// a file of one's own; results.not_comparable when `file` has other episodes than the run;
// episode.not_repeated; those of run_episode and io.*.
Result<void> make_strips(const std::filesystem::path& data,
                         const FinishedRun& run,
                         const episodes::EpisodeFile& file,
                         const catalog::Catalog& catalog,
                         std::size_t at_most,
                         Progress& progress);

}  // namespace marketgen::evaluation
