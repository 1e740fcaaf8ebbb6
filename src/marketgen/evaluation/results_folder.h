// The folder of a run: run.json, which says what is run; results.jsonl, to which each episode adds
// its line as it finishes; and summary.json. A run that was broken off is gone on with from there.
#pragma once
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "episodes/episode_result.h"
#include "episodes/episode_spec.h"
#include "evaluation/run_record.h"
#include "io/folder_lock.h"

namespace marketgen::evaluation {

// What a results.jsonl holds, by episode. A last line without an end was not finished, and is left
// out. Errors: input.not_found, io.*; at FILE:LINE those of read_json, and results.duplicate_id.
Result<std::map<std::string, episodes::EpisodeResult>> finished_results(
    const std::filesystem::path& file);

class ResultsFolder {
 public:
  // `record`: of a run of `file` (record_of). Has the folder to itself while it lives. With
  // `resume` it keeps what is finished there: results of the same episodes, as they are now
  // (EpisodeResult::episode_hash), that could be run. Errors: io.in_use, io.*; store.exists when it
  // has results and `resume` is off; usage.bad_flag when they are of another policy, realism, shard
  // or repetition, or of episodes that the file does not have; those of finished_results and
  // read_record. `file` must outlive it.
  static Result<std::unique_ptr<ResultsFolder>> open(const episodes::EpisodeFile& file,
                                                     const std::filesystem::path& folder,
                                                     RunRecord record,
                                                     bool resume);

  bool is_asked_for(std::size_t number) const { return record_.shard.has(number); }
  bool has(std::size_t number) const;  // of the episode in its file
  std::size_t count() const;           // of results
  // Adds a line, with the id and the hash of its episode and the run's realism. Error:
  // io.cannot_write. Thread-safe.
  Result<void> keep(std::size_t number, episodes::EpisodeResult result);
  // Writes the lines in the order of the episodes, and the summary. Errors: io.*.
  Result<std::vector<episodes::EpisodeResult>> close();

 private:
  ResultsFolder(const episodes::EpisodeFile& file,
                const std::filesystem::path& folder,
                RunRecord record,
                io::FolderLock lock);
  Result<void> take_over();
  Result<void> check_taken_over(const std::map<std::string, episodes::EpisodeResult>& before) const;
  Result<void> add_commits_of_before();
  std::string results_path() const;
  std::vector<episodes::EpisodeResult> in_order() const;

  std::filesystem::path folder_;
  io::FolderLock lock_;
  const episodes::EpisodeFile& file_;
  RunRecord record_;
  mutable std::mutex mutex_;
  std::ofstream lines_;
  std::vector<std::optional<episodes::EpisodeResult>> results_;
};

}  // namespace marketgen::evaluation
