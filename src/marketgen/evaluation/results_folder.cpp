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
    finished[result.episode] = std::move(result);
  }
  return finished;
}

ResultsFolder::ResultsFolder(const episodes::EpisodeFile& file,
                             const std::filesystem::path& folder,
                             io::FolderLock lock)
    : folder_(folder), lock_(std::move(lock)), file_(file), results_(file.episodes.size()) {
  for (const episodes::EpisodeSpec& spec : file.episodes)
    hashes_.push_back(episodes::episode_hash(file.header, spec));
}

std::string ResultsFolder::results_path() const {
  return (folder_ / "results.jsonl").string();
}

Result<std::unique_ptr<ResultsFolder>> ResultsFolder::open(const episodes::EpisodeFile& file,
                                                           const std::filesystem::path& folder,
                                                           const std::string& policy,
                                                           bool resume) {
  io::Outputs place;
  MARKETGEN_CHECK(place.add_folder(folder));
  MARKETGEN_CHECK(place.commit());
  std::error_code failed;
  MARKETGEN_TRY(io::FolderLock lock, io::FolderLock::take(folder));
  std::unique_ptr<ResultsFolder> opened(new ResultsFolder(file, folder, std::move(lock)));
  const std::string path = opened->results_path();
  const auto size = std::filesystem::file_size(path, failed);
  if (!failed && size > 0) {
    if (!resume)
      return Error{"store.exists",
                   path,
                   "there are results already: name another folder, or go on with --resume"};
    MARKETGEN_CHECK(opened->take_over(policy));
  }
  MARKETGEN_CHECK(io::write_file(path, lines_of(opened->in_order())));
  opened->lines_.open(path, std::ios::app);
  return opened;
}

Result<void> ResultsFolder::take_over(const std::string& policy) {
  MARKETGEN_TRY(const auto finished, finished_results(results_path()));
  int changed = 0;
  for (const auto& [id, result] : finished) {
    if (result.policy != policy)
      return Error{"usage.bad_flag",
                   "--policy",
                   fmt::format("{} has results of \"{}\": go on with that, or name another folder",
                               results_path(),
                               result.policy)};
    const auto spec = std::ranges::find(file_.episodes, id, &episodes::EpisodeSpec::id);
    if (spec == file_.episodes.end())
      return Error{"usage.bad_flag",
                   "--resume",
                   fmt::format("{} has a result of {}, which is not among these episodes: go on "
                               "with the file it is of, or name another folder",
                               results_path(),
                               id)};
    const auto number = static_cast<std::size_t>(spec - file_.episodes.begin());
    if (result.episode_hash != hashes_[number])
      ++changed;
    else if (result.error.empty())
      results_[number] = result;
  }
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
  result.episode_hash = hashes_[number];
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
  summary.unfinished = static_cast<int>(results_.size() - results.size());
  MARKETGEN_CHECK(io::write_file(results_path(), lines_of(results)));
  MARKETGEN_CHECK(io::write_file(folder_ / "summary.json", io::write_json(summary)));
  return results;
}

}  // namespace marketgen::evaluation
