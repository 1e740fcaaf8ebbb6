#include "evaluation/run_record.h"

#include <charconv>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/build_info.h"
#include "base/hash.h"
#include "base/source_commit.h"
#include "io/file.h"
#include "io/json.h"

namespace marketgen::evaluation {
namespace {

// All of a text as a number, or 0.
int whole_number_of(std::string_view text) {
  int number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  return read.ec == std::errc{} && read.ptr == text.data() + text.size() ? number : 0;
}

std::string instructions_of(const episodes::EpisodeFile& file) {
  std::set<std::string_view> told;
  for (const episodes::EpisodeSpec& spec : file.episodes)
    told.insert(name_of(spec.instructions));
  return fmt::format("{}", fmt::join(told, " and "));
}

}  // namespace

std::string commit_of_program() {
  const std::string commit = source_commit;
  return commit.empty() ? "unknown" : commit;
}

Result<Shard> read_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash != std::string::npos) {
    const Shard shard{whole_number_of(std::string_view(text).substr(0, slash)),
                      whole_number_of(std::string_view(text).substr(slash + 1))};
    if (shard.part >= 1 && shard.part <= shard.of && shard.of <= 10000) return shard;
  }
  return Error{"usage.bad_flag",
               "--shard",
               fmt::format("\"{}\" is no part of a whole: write 2/4 for the second of four", text)};
}

std::string RunRecord::commit() const {
  return fmt::format("{}", fmt::join(commits, ", "));
}

RunRecord record_of(const episodes::EpisodeFile& file,
                    const std::string& policy,
                    const std::string& realism,
                    const Shard& shard,
                    int repetition) {
  RunRecord record;
  record.policy = policy;
  record.realism = realism;
  record.version = program_version;
  record.commits = {commit_of_program()};
  if (!file.set.empty()) record.set = file.set;
  record.split = file.header.split;
  record.instructions = instructions_of(file);
  record.shard = shard;
  if (repetition > 1) record.repetition = repetition;
  Hasher hasher;
  for (const episodes::EpisodeSpec& spec : file.episodes) {
    const std::string hash = episodes::episode_hash(file.header, spec);
    hasher.add(spec.id).add(hash);
    record.episodes.push_back({spec.id, hash, spec.track});
  }
  record.episodes_hash = hasher.hex();
  return record;
}

std::string spoken_episodes(const std::optional<std::string>& set, const std::string& hash) {
  return set ? fmt::format("{} ({})", *set, hash) : hash;
}

std::filesystem::path record_path(const std::filesystem::path& folder) {
  return folder / "run.json";
}

Result<RunRecord> read_record(const std::filesystem::path& folder) {
  const std::filesystem::path file = record_path(folder);
  auto text = io::read_file(file);
  if (!text.ok() && text.error().code == "input.not_found")
    return Error{"results.no_record",
                 folder.string(),
                 "has no run.json, so what was run is not known: name a folder of `marketgen "
                 "eval`; where an earlier version made it, eval --resume with its episodes adds "
                 "that"};
  if (!text.ok()) return text.error();
  return io::read_json<RunRecord>(*text, file.string());
}

}  // namespace marketgen::evaluation
