#include "evaluation/finished_run.h"

#include <algorithm>

#include <fmt/format.h>

#include "evaluation/results_folder.h"
#include "io/file.h"
#include "io/json.h"
#include "io/output.h"

namespace marketgen::evaluation {
namespace {

std::filesystem::path results_path_of(const std::filesystem::path& folder) {
  return folder / "results.jsonl";
}

// Error: its last line breaks off.
Result<void> check_whole_lines(const std::filesystem::path& file) {
  MARKETGEN_TRY(const std::string text, io::read_file(file));
  if (text.empty() || text.ends_with('\n')) return {};
  return Error{"results.truncated",
               fmt::format("{}:{}", file.string(), std::ranges::count(text, '\n') + 1),
               "the last line has no end: go on with eval --resume, which runs that episode again"};
}

Result<void> check_is_of(const FinishedRun& run,
                         const RunEpisode& episode,
                         const episodes::EpisodeResult& result) {
  const auto fault = [&](std::string why) {
    return Error{"results.changed", results_path_of(run.folder).string(), std::move(why)};
  };
  if (result.policy != run.record.policy)
    return fault(fmt::format("{} was run by \"{}\", the run is of \"{}\"",
                             episode.id,
                             result.policy,
                             run.record.policy));
  if (result.episode_hash != episode.hash)
    return fault(
        fmt::format("the result of {} is of an episode with hash {}, the run's has {}: go "
                    "on with eval --resume, which runs it again",
                    episode.id,
                    result.episode_hash,
                    episode.hash));
  return {};
}

}  // namespace

Result<FinishedRun> read_run(const std::filesystem::path& named) {
  FinishedRun run;
  run.folder = named.filename() == "results.jsonl" ? named.parent_path() : named;
  std::error_code failed;
  if (!std::filesystem::exists(named, failed))
    return Error{
        "input.not_found", named.string(), "there are no results: name a folder of `eval`"};
  MARKETGEN_TRY(run.record, read_record(run.folder));
  const std::filesystem::path file = results_path_of(run.folder);
  MARKETGEN_CHECK(check_whole_lines(file));
  MARKETGEN_TRY(auto finished, finished_results(file));
  for (std::size_t i = 0; i < run.record.episodes.size(); ++i) {
    const RunEpisode& episode = run.record.episodes[i];
    const auto result = finished.find(episode.id);
    if (result == finished.end()) continue;
    MARKETGEN_CHECK(check_is_of(run, episode, result->second));
    run.results.push_back(std::move(result->second));
    finished.erase(result);
  }
  if (finished.empty()) return run;
  return Error{"results.changed",
               file.string(),
               fmt::format("has a result of {}, which is not among the episodes of {}",
                           finished.begin()->first,
                           record_path(run.folder).string())};
}

Result<std::vector<FinishedRun>> read_runs(const std::vector<std::string>& folders) {
  std::vector<FinishedRun> runs;
  for (const std::string& folder : folders) {
    MARKETGEN_TRY(FinishedRun run, read_run(folder));
    runs.push_back(std::move(run));
  }
  return runs;
}

Result<void> check_complete(const FinishedRun& run) {
  const std::size_t all = run.record.episodes.size(), missing = all - run.results.size();
  const auto failed = [](const episodes::EpisodeResult& result) { return !result.error.empty(); };
  const auto not_run = std::ranges::count_if(run.results, failed);
  if (missing == 0 && not_run == 0) return {};
  const auto has_none = [&](const RunEpisode& episode) {
    return std::ranges::find(run.results, episode.id, &episodes::EpisodeResult::episode) ==
           run.results.end();
  };
  const auto first = missing > 0 ? std::ranges::find_if(run.record.episodes, has_none)->id
                                 : std::ranges::find_if(run.results, failed)->episode;
  return Error{"results.incomplete",
               run.folder.string(),
               fmt::format("of {} episodes {} have no result and {} could not be run, {} first; "
                           "only complete runs are ranked: {}",
                           all,
                           missing,
                           not_run,
                           first,
                           run.record.shard.of > 1 ? "join its shards with `marketgen merge`"
                                                   : "go on with eval --resume")};
}

Result<void> check_repeated(const episodes::EpisodeResult& before,
                            const episodes::EpisodeResult& again) {
  if (before.state_hash == again.state_hash) return {};
  return Error{"episode.not_repeated",
               again.episode,
               fmt::format("ended in state {}, before in {}: another version or machine",
                           again.state_hash,
                           before.state_hash)};
}

std::vector<episodes::EpisodeResult> results_of(const FinishedRun& run, episodes::Track track) {
  std::vector<episodes::EpisodeResult> results;
  std::size_t next = 0;  // both are in the same order
  for (const RunEpisode& episode : run.record.episodes) {
    if (next == run.results.size()) break;
    if (run.results[next].episode != episode.id) continue;
    if (episode.track == track) results.push_back(run.results[next]);
    ++next;
  }
  return results;
}

std::vector<episodes::Track> tracks_of(const FinishedRun& run) {
  std::vector<episodes::Track> tracks;
  for (const episodes::Track track : episodes::all_tracks)
    if (std::ranges::find(run.record.episodes, track, &RunEpisode::track) !=
        run.record.episodes.end())
      tracks.push_back(track);
  return tracks;
}

Result<void> write_run(const FinishedRun& run) {
  const std::filesystem::path results = results_path_of(run.folder);
  std::error_code failed;
  if (std::filesystem::exists(results, failed))
    return Error{
        "store.exists", results.string(), "there are results already: name another folder"};
  std::string lines;
  for (const episodes::EpisodeResult& result : run.results)
    lines += io::write_json_line(result) + "\n";
  io::Outputs outputs;
  MARKETGEN_CHECK(outputs.add_folder(run.folder));
  MARKETGEN_CHECK(outputs.put(record_path(run.folder), io::write_json(run.record)));
  MARKETGEN_CHECK(outputs.put(results, lines));
  MARKETGEN_CHECK(outputs.put(run.folder / "summary.json", io::write_json(summarize(run.results))));
  return outputs.commit();
}

}  // namespace marketgen::evaluation
