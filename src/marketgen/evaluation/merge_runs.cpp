#include "evaluation/merge_runs.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "evaluation/same_runs.h"
#include "io/output.h"

namespace marketgen::evaluation {
namespace {

struct OfShard {
  const FinishedRun* shard;
  const episodes::EpisodeResult* result;
};
using ResultsById = std::map<std::string, OfShard>;

Result<ResultsById> each_once(const std::vector<FinishedRun>& shards) {
  ResultsById all;
  for (const FinishedRun& shard : shards) {
    for (const episodes::EpisodeResult& result : shard.results) {
      const auto [before, is_new] = all.emplace(result.episode, OfShard{&shard, &result});
      if (is_new) continue;
      const bool alike = before->second.result->state_hash == result.state_hash;
      return Error{"results.overlap",
                   shard.folder.string(),
                   fmt::format("has a result of {}, and so has {}, {}: name each shard once",
                               result.episode,
                               before->second.shard->folder.string(),
                               alike ? "the same" : "another one")};
    }
  }
  return all;
}

// What the missing ones are called: by the shards that nobody named, where each shard is whole.
std::string missing_shards(const std::vector<FinishedRun>& shards,
                           const std::vector<std::size_t>& missing) {
  const Shard& one = shards.front().record.shard;
  std::vector<std::string> parts;
  for (int part = 1; part <= one.of; ++part) {
    const Shard shard{part, one.of};
    const auto is_named = [&](const FinishedRun& run) { return run.record.shard == shard; };
    const bool has_missing =
        std::ranges::any_of(missing, [&](std::size_t number) { return shard.has(number); });
    if (!has_missing) continue;
    parts.push_back(fmt::format(
        "{}/{}{}", part, one.of, std::ranges::any_of(shards, is_named) ? " (unfinished)" : ""));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

Result<FinishedRun> merge_runs(const std::vector<FinishedRun>& shards,
                               const std::filesystem::path& folder) {
  if (shards.empty()) return Error{"results.incomplete", "", "name the folders of the shards"};
  MARKETGEN_CHECK(check_one_run(shards));
  MARKETGEN_TRY(const ResultsById all, each_once(shards));
  FinishedRun merged{folder, shards.front().record, {}};
  merged.record.shard = {};
  merged.record.set = common_set(shards);
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < merged.record.episodes.size(); ++i) {
    const auto found = all.find(merged.record.episodes[i].id);
    if (found == all.end())
      missing.push_back(i);
    else
      merged.results.push_back(*found->second.result);
  }
  if (missing.empty()) return merged;
  return Error{"results.incomplete",
               shards.front().folder.string(),
               fmt::format("{} of {} episodes are in none of the {} folders, {} first; shards that "
                           "lack some: {}",
                           missing.size(),
                           merged.record.episodes.size(),
                           shards.size(),
                           merged.record.episodes[missing.front()].id,
                           missing_shards(shards, missing))};
}

Result<FinishedRun> merge_folders(const std::vector<std::string>& folders,
                                  const std::filesystem::path& folder,
                                  const std::string& set) {
  io::Outputs place;
  MARKETGEN_CHECK(place.add_folder(folder));
  MARKETGEN_TRY(const std::vector<FinishedRun> shards, read_runs(folders));
  MARKETGEN_TRY(FinishedRun whole, merge_runs(shards, folder));
  if (!set.empty()) whole.record.set = set;
  MARKETGEN_CHECK(write_run(whole));
  MARKETGEN_CHECK(place.commit());
  return whole;
}

}  // namespace marketgen::evaluation
