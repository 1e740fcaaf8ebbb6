// What was run: run.json beside the results, market-run/1. It names every episode of the file, so
// that a folder of results says by itself what is missing from it.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "episodes/episode_spec.h"

namespace marketgen::evaluation {

// One of so many parts of a file: its episodes part - 1, part - 1 + of, ...
struct Shard {
  int part = 1, of = 1;
  bool has(std::size_t number) const {
    return number % static_cast<std::size_t>(of) == static_cast<std::size_t>(part - 1);
  }
  bool operator==(const Shard&) const = default;
  static constexpr auto fields =
      field_list(field("part", &Shard::part, "which, from 1 on", range(1, 10000)),
                 field("of", &Shard::of, "how many there are", range(1, 10000)));
};

// That this program was built of: twelve digits, with "+" when its files differed from it;
// "unknown" where there was no Git.
std::string commit_of_program();

// "2/4". Error usage.bad_flag at --shard.
Result<Shard> read_shard(const std::string& text);

struct RunEpisode {
  std::string id, hash;
  episodes::Track track = episodes::Track::checkout;
  static constexpr auto fields =
      field_list(field("id", &RunEpisode::id, "of the episode", identifier()),
                 field("hash", &RunEpisode::hash, "over all that decides it", required()),
                 field("track", &RunEpisode::track, "what kind of task", required()));
};

struct RunRecord {
  std::string schema = "market-run/1";
  std::string policy;
  std::string version;               // of the program
  std::vector<std::string> commits;  // more than one when a run was gone on with
  std::string realism = "ideal";
  std::string episodes_hash;
  std::optional<std::string> set;  // v1/checkout: of the program's sets; absent: of none of them
  episodes::Split split = episodes::Split::planned;
  std::string instructions = "ids";  // of the file's episodes: ids, words, or "ids and words"
  Shard shard;
  std::optional<int> repetition = {};  // the first when there is none
  std::vector<RunEpisode> episodes;

  static constexpr auto fields = field_list(
      field("schema", &RunRecord::schema, "schema tag", constant("market-run/1")),
      field("policy", &RunRecord::policy, "who acted", required()),
      field("version", &RunRecord::version, "of the program", required()),
      field("commits",
            &RunRecord::commits,
            "of the program; a \"+\" when it was changed since, unknown where it was not kept"),
      field("realism",
            &RunRecord::realism,
            "what stood between the world and the robot: a row's name, or own- and a hash; ideal: "
            "nothing"),
      field("episodes_hash",
            &RunRecord::episodes_hash,
            "over all episodes of the file, in their order",
            required()),
      field(
          "set",
          &RunRecord::set,
          "the set that comes with the program of which the episodes are; absent for other files"),
      field("split", &RunRecord::split, "what the file's episodes were shown to be"),
      field("instructions",
            &RunRecord::instructions,
            "how the file's goals are told: ids, words, or ids and words"),
      field("shard", &RunRecord::shard, "the part of the file that was run"),
      field("repetition",
            &RunRecord::repetition,
            "which run of the episodes with draws of its own (eval --repetition); the first when "
            "absent",
            range(2, 1000)),
      field("episodes", &RunRecord::episodes, "all of the file", required()));
  std::string commit() const;  // of the commits, as one text
};

// Of a run of `file` by this program.
RunRecord record_of(const episodes::EpisodeFile& file,
                    const std::string& policy,
                    const std::string& realism,
                    const Shard& shard,
                    int repetition = 1);

// "v1/checkout (3f…)": how pages and tables name the file of episodes.
std::string spoken_episodes(const std::optional<std::string>& set, const std::string& hash);

std::filesystem::path record_path(const std::filesystem::path& folder);
// Errors: results.no_record; io.*; those of read_json.
Result<RunRecord> read_record(const std::filesystem::path& folder);

}  // namespace marketgen::evaluation
