#include "server/replay_runs.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "evaluation/motion_recorder.h"

namespace marketgen::server {
namespace {

std::string last_part(const std::filesystem::path& folder) {
  const std::filesystem::path plain = folder.lexically_normal();
  return (plain.has_filename() ? plain.filename() : plain.parent_path().filename()).string();
}

RunLine line_of_run(int number, const evaluation::FinishedRun& run, const std::string& scene_hash) {
  const evaluation::RunRecord& record = run.record;
  RunLine line{number,
               last_part(run.folder),
               record.policy,
               record.realism,
               record.version,
               std::string(name_of(record.split)),
               record.instructions,
               0,
               0,
               0,
               {}};
  std::map<std::string, int> failures;
  for (const episodes::EpisodeResult& result : run.results) {
    if (result.scene_hash != scene_hash) continue;
    line.episodes += 1;
    line.strict += result.success_strict ? 1 : 0;
    line.clean += result.success_clean ? 1 : 0;
    failures[std::string(name_of(result.failure))] += 1;
  }
  for (const auto& [code, episodes] : failures)
    line.failures.push_back({code, episodes});
  std::ranges::stable_sort(line.failures, std::greater{}, &FailureCount::episodes);
  return line;
}

bool has_store(const evaluation::FinishedRun& run, const ReplayRuns::Stores& stores) {
  return std::ranges::any_of(run.results, [&](const episodes::EpisodeResult& result) {
    return std::ranges::any_of(
        stores, [&](const auto& store) { return store->manifest.scene_hash == result.scene_hash; });
  });
}

}  // namespace

Result<ReplayRuns> ReplayRuns::read(const std::vector<std::string>& folders) {
  ReplayRuns opened;
  MARKETGEN_TRY(opened.runs_, evaluation::read_runs(folders));
  return opened;
}

std::set<std::string> ReplayRuns::scenes_without(const Stores& stores) const {
  std::set<std::string> scenes;
  for (const evaluation::FinishedRun& run : runs_) {
    if (has_store(run, stores)) continue;
    for (const episodes::EpisodeResult& result : run.results)
      scenes.insert(result.scene_hash);
  }
  return scenes;
}

Result<void> ReplayRuns::check_shown_in(const Stores& stores) const {
  for (const evaluation::FinishedRun& run : runs_) {
    if (run.results.empty())
      return Error{"results.incomplete", run.folder.string(), "no episode has a result yet"};
    if (has_store(run, stores)) continue;
    const episodes::EpisodeResult& first = run.results.front();
    return Error{
        "episode.other_store",
        run.folder.string(),
        fmt::format("its episodes are of the store \"{}\" (scene {}), which is none of those that "
                    "are shown, nor of a set of the program's: name that store's folder, or the "
                    "file of its episodes with --episodes",
                    first.store,
                    first.scene_hash)};
  }
  return {};
}

RunList ReplayRuns::of_store(const std::string& scene_hash) const {
  RunList list;
  for (std::size_t number = 0; number < runs_.size(); ++number) {
    RunLine line = line_of_run(static_cast<int>(number), runs_[number], scene_hash);
    if (line.episodes > 0) list.runs.push_back(std::move(line));
  }
  return list;
}

RunEpisodes ReplayRuns::episodes(std::size_t run, const std::string& scene_hash) const {
  RunEpisodes list{line_of_run(static_cast<int>(run), runs_[run], scene_hash), {}};
  for (std::size_t row = 0; row < runs_[run].results.size(); ++row)
    if (runs_[run].results[row].scene_hash == scene_hash)
      list.episodes.push_back(line_of(run, row));
  return list;
}

EpisodeLine ReplayRuns::line_of(std::size_t run, std::size_t episode) const {
  const evaluation::FinishedRun& of = runs_[run];
  const episodes::EpisodeResult& result = of.results[episode];
  const auto listed =
      std::ranges::find(of.record.episodes, result.episode, &evaluation::RunEpisode::id);
  std::error_code failed;
  return {static_cast<std::uint32_t>(episode),
          result.episode,
          listed->track,
          std::string(name_of(result.failure)),
          result.error,
          result.detail,
          result.hits,
          result.asked,
          result.success_partial,
          result.success_strict,
          result.success_clean,
          result.is_void,
          std::filesystem::exists(evaluation::motion_file(of.folder, result.episode), failed),
          result.simulated_s};
}

}  // namespace marketgen::server
