// A run as it lies in its folder, read strictly: what is ranked, merged or shown must be what was
// run, all of it and each episode once.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "episodes/episode_result.h"
#include "evaluation/evaluation_summary.h"
#include "evaluation/run_record.h"

namespace marketgen::evaluation {

struct FinishedRun {
  std::filesystem::path folder;
  RunRecord record;
  std::vector<episodes::EpisodeResult> results;  // in the order of the record; those there are
};

// `named`: the folder, or its results.jsonl. Errors: results.no_record, results.truncated,
// results.duplicate_id; results.changed when a result is of another episode or policy than the
// record says; input.not_found, io.*; those of read_json.
Result<FinishedRun> read_run(const std::filesystem::path& named);

// One after the other. The same errors.
Result<std::vector<FinishedRun>> read_runs(const std::vector<std::string>& folders);

// Error results.incomplete, with how many and the first of them: episodes of the whole file, not
// of its shard alone, have no result or could not be run.
Result<void> check_complete(const FinishedRun& run);

// Error episode.not_repeated: an episode that was run again ended in another state than before.
Result<void> check_repeated(const episodes::EpisodeResult& before,
                            const episodes::EpisodeResult& again);

// The results of one track.
std::vector<episodes::EpisodeResult> results_of(const FinishedRun& run, episodes::Track track);
// In the order of the tracks' list.
std::vector<episodes::Track> tracks_of(const FinishedRun& run);

// run.json, results.jsonl and summary.json of a run, as a new folder at `run.folder`. Errors:
// store.exists when there are results; io.*.
Result<void> write_run(const FinishedRun& run);

}  // namespace marketgen::evaluation
