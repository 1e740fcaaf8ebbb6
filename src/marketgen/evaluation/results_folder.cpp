#include "evaluation/results_folder.h"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "base/progress.h"
#include "evaluation/evaluation_summary.h"
#include "io/file.h"
#include "io/json.h"
#include "io/output.h"

namespace marketgen::evaluation {
namespace {

std::string lines_of(const std::vector<episodes::EpisodeResult>& results) {
  std::string lines;
  for (const episodes::EpisodeResult& result : results)
    lines += io::write_json_line(result) + "\n";
  return lines;
}

}  // namespace

Result<std::map<std::string, episodes::EpisodeResult>> finished_results(
    const std::filesystem::path& file) {
  MARKETGEN_TRY(const std::string text, io::read_file(file));
  std::map<std::string, episodes::EpisodeResult> finished;
  std::istringstream lines(text.substr(0, text.rfind('\n') + 1));
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::string where = fmt::format("{}:{}", file.string(), ++number);
    MARKETGEN_TRY(episodes::EpisodeResult result,
                  io::read_json<episodes::EpisodeResult>(line, where));
    const std::string id = result.episode;
    if (!finished.emplace(id, std::move(result)).second)
      return Error{"results.duplicate_id",
                   where,
                   id + " has a result further up: take one of the two lines out"};
  }
  return finished;
}

ResultsFolder::ResultsFolder(const episodes::EpisodeFile& file,
                             const std::filesystem::path& folder,
                             RunRecord record,
                             io::FolderLock lock)
    : folder_(folder),
      lock_(std::move(lock)),
      file_(file),
      record_(std::move(record)),
      results_(file.episodes.size()) {}

std::string ResultsFolder::results_path() const {
  return (folder_ / "results.jsonl").string();
}

Result<std::unique_ptr<ResultsFolder>> ResultsFolder::open(const episodes::EpisodeFile& file,
                                                           const std::filesystem::path& folder,
                                                           RunRecord record,
                                                           bool resume) {
  io::Outputs place;
  MARKETGEN_CHECK(place.add_folder(folder));
  MARKETGEN_CHECK(place.commit());
  std::error_code failed;
  MARKETGEN_TRY(io::FolderLock lock, io::FolderLock::take(folder));
  std::unique_ptr<ResultsFolder> opened(
      new ResultsFolder(file, folder, std::move(record), std::move(lock)));
  const std::string path = opened->results_path();
  io::Outputs files;  // looked at before any work; written by others
  MARKETGEN_CHECK(files.add({{"--output", path}, {"--output", folder / "summary.json"}}));
  const auto size = std::filesystem::file_size(path, failed);
  if (!failed && size > 0) {
    if (!resume)
      return Error{"store.exists",
                   path,
                   "there are results already: name another folder, or go on with --resume"};
    MARKETGEN_CHECK(opened->take_over());
  }
  MARKETGEN_CHECK(io::write_file(record_path(folder), io::write_json(opened->record_)));
  MARKETGEN_CHECK(io::write_file(path, lines_of(opened->in_order())));
  opened->lines_.open(path, std::ios::app);
  return opened;
}

// Each of them is of this policy and realism, and of an episode that is run here.
Result<void> ResultsFolder::check_taken_over(
    const std::map<std::string, episodes::EpisodeResult>& before) const {
  for (const auto& [id, result] : before) {
    if (result.policy != record_.policy)
      return Error{"usage.bad_flag",
                   "--policy",
                   fmt::format("{} has results of \"{}\": go on with that, or name another folder",
                               results_path(),
                               result.policy)};
    if (result.realism != record_.realism)
      return Error{"usage.bad_flag",
                   "--realism",
                   fmt::format("{} has results of realism \"{}\", this run is of \"{}\": go on "
                               "with that, or name another folder",
                               results_path(),
                               result.realism,
                               record_.realism)};
    if (result.repetition != record_.repetition)
      return Error{"usage.bad_flag",
                   "--repetition",
                   fmt::format("{} has results of repetition {}, this run is repetition {}: go on "
                               "with that, or name another folder",
                               results_path(),
                               result.repetition.value_or(1),
                               record_.repetition.value_or(1))};
    const auto spec = std::ranges::find(file_.episodes, id, &episodes::EpisodeSpec::id);
    if (spec == file_.episodes.end())
      return Error{"usage.bad_flag",
                   "--resume",
                   fmt::format("{} has a result of {}, which is not among these episodes: go on "
                               "with the file it is of, or name another folder",
                               results_path(),
                               id)};
    if (!is_asked_for(static_cast<std::size_t>(spec - file_.episodes.begin())))
      return Error{"usage.bad_flag",
                   "--shard",
                   fmt::format("{} has a result of {}, which is in another shard: go on with that, "
                               "or name another folder",
                               results_path(),
                               id)};
  }
  return {};
}

// Results that are kept were made by the programs that made them.
Result<void> ResultsFolder::add_commits_of_before() {
  std::vector<std::string> commits{"unknown"};
  auto before = read_record(folder_);
  if (!before.ok() && before.error().code != "results.no_record") return before.error();
  if (before.ok()) commits = before->commits;
  for (const std::string& commit : record_.commits)
    if (std::ranges::find(commits, commit) == commits.end()) commits.push_back(commit);
  record_.commits = commits;
  return {};
}

Result<void> ResultsFolder::take_over() {
  MARKETGEN_TRY(const auto finished, finished_results(results_path()));
  MARKETGEN_CHECK(check_taken_over(finished));
  int changed = 0;
  for (std::size_t number = 0; number < file_.episodes.size(); ++number) {
    const auto before = finished.find(file_.episodes[number].id);
    if (before == finished.end()) continue;
    if (before->second.episode_hash != record_.episodes[number].hash)
      ++changed;
    else if (before->second.error.empty())
      results_[number] = before->second;
  }
  if (count() > 0) MARKETGEN_CHECK(add_commits_of_before());
  if (changed > 0)
    log_warning(
        fmt::format("{} of {} results in {} are of episodes that have changed since: they "
                    "are run again",
                    changed,
                    finished.size(),
                    results_path()));
  return {};
}

bool ResultsFolder::has(std::size_t number) const {
  const std::scoped_lock lock(mutex_);
  return results_[number].has_value();
}

std::size_t ResultsFolder::count() const {
  const std::scoped_lock lock(mutex_);
  return static_cast<std::size_t>(
      std::ranges::count_if(results_, [](const auto& result) { return result.has_value(); }));
}

Result<void> ResultsFolder::keep(std::size_t number, episodes::EpisodeResult result) {
  const std::scoped_lock lock(mutex_);
  result.episode = record_.episodes[number].id;  // whatever its runner says
  result.episode_hash = record_.episodes[number].hash;
  result.realism = record_.realism;
  result.repetition = record_.repetition;
  lines_ << io::write_json_line(result) << "\n" << std::flush;
  if (!lines_) return Error{"io.cannot_write", results_path(), "is the disk full?"};
  results_[number] = std::move(result);
  return {};
}

std::vector<episodes::EpisodeResult> ResultsFolder::in_order() const {
  std::vector<episodes::EpisodeResult> ordered;
  for (const auto& result : results_)
    if (result) ordered.push_back(*result);
  return ordered;
}

Result<std::vector<episodes::EpisodeResult>> ResultsFolder::close() {
  const std::scoped_lock lock(mutex_);
  lines_.close();
  std::vector<episodes::EpisodeResult> results = in_order();
  EvaluationSummary summary = summarize(results);
  for (std::size_t i = 0; i < results_.size(); ++i)
    summary.unfinished += is_asked_for(i) && !results_[i] ? 1 : 0;
  MARKETGEN_CHECK(io::write_file(results_path(), lines_of(results)));
  MARKETGEN_CHECK(io::write_file(folder_ / "summary.json", io::write_json(summary)));
  return results;
}

}  // namespace marketgen::evaluation
