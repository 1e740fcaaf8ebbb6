// Many episodes, several at a time, kept as they finish: a run that was broken off goes on where it
// was.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/progress.h"
#include "evaluation/run_episode.h"

namespace marketgen {

struct EvaluationOptions {
  std::string policy = "oracle";
  std::filesystem::path folder;  // gets results.jsonl and summary.json
  bool resume = false;           // keeps what an earlier run has finished there
};

// What a results.jsonl holds, by episode. A line that was cut off is one that was not finished.
// Errors: those of read_json.
Result<std::map<std::string, EpisodeResult>> finished_results(const std::filesystem::path& file);

// Each finished episode is a line of results.jsonl at once; at the end the lines are in the order
// of the episodes. The same for any number of threads, wall times apart. Errors: store.exists when
// the folder has results and `resume` is off; io.*; those of run_episode.
Result<std::vector<EpisodeResult>> evaluate(const std::filesystem::path& data,
                                            const EpisodeFile& file,
                                            const Catalog& catalog,
                                            const EvaluationOptions& options,
                                            Progress& progress);

}  // namespace marketgen
