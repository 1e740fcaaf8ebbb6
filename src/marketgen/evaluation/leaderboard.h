// Policies side by side on the same episodes, track by track: market-leaderboard/1.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "evaluation/evaluation_summary.h"
#include "evaluation/finished_run.h"
#include "evaluation/power_table.h"

namespace marketgen::evaluation {

// Two policies on the same episodes (evaluation/paired_tests.h).
struct PairedComparison {
  std::string against;
  int only_this = 0, only_other = 0;
  double p_strict = 1, p_partial = 1;
  double p_strict_holm = 1, p_partial_holm = 1;
  std::vector<PowerRow> power;

  static constexpr auto fields = field_list(
      field("against", &PairedComparison::against, "the best policy of the track"),
      field("only_this", &PairedComparison::only_this, "episodes that only this one solves"),
      field("only_other", &PairedComparison::only_other, "episodes that only the best solves"),
      field("p_strict", &PairedComparison::p_strict, "of strict successes: McNemar, exact"),
      field("p_partial",
            &PairedComparison::p_partial,
            "of partial scores: signs of the stores' sums flipped"),
      field("p_strict_holm",
            &PairedComparison::p_strict_holm,
            "p_strict, corrected for how many are compared with the best"),
      field("p_partial_holm",
            &PairedComparison::p_partial_holm,
            "p_partial, corrected for how many are compared with the best"),
      field("power", &PairedComparison::power, "episodes needed, both run on the same ones"));
};
// Both have the same episodes in the same order.
PairedComparison compared(const std::vector<episodes::EpisodeResult>& these,
                          const std::vector<episodes::EpisodeResult>& others);

struct LeaderboardEntry {
  std::string policy, results, commit;
  std::optional<int> repetition = {};
  bool floor = false;
  int episodes = 0, stores = 0;
  grasping::Share strict, clean, violations;
  Estimate partial;
  GoalShare goals;
  std::optional<Estimate> spl;
  std::optional<PairedComparison> to_best;
  double likeness = 0;
  std::vector<PowerRow> power;

  static constexpr auto fields = field_list(
      field("policy", &LeaderboardEntry::policy, "who acted"),
      field("results", &LeaderboardEntry::results, "folder that it is from"),
      field("commit", &LeaderboardEntry::commit, "of the program that ran it"),
      field("repetition",
            &LeaderboardEntry::repetition,
            "which run of the episodes with draws of its own; the first when absent"),
      field("floor", &LeaderboardEntry::floor, "it knows nothing of what is asked for"),
      field("episodes", &LeaderboardEntry::episodes, "that were run"),
      field("stores", &LeaderboardEntry::stores, "that they are of"),
      field("strict", &LeaderboardEntry::strict, "episodes with all goals reached"),
      field("partial", &LeaderboardEntry::partial, "mean partial score"),
      field("goals", &LeaderboardEntry::goals, "goals reached, of all"),
      field("spl", &LeaderboardEntry::spl, "as the paper has it; of tracks with a way to go"),
      field("clean", &LeaderboardEntry::clean, "strict ones without side effects"),
      field("violations", &LeaderboardEntry::violations, "void, or beyond a limit on side effects"),
      field("to_best", &LeaderboardEntry::to_best, "none of the best itself"),
      field("likeness", &LeaderboardEntry::likeness, "of strict success within a store, 0..1"),
      field("power", &LeaderboardEntry::power, "episodes needed, each policy on its own"));
};

// A share over several runs of the same episodes.
struct RepeatedShare {
  double mean = 0, deviation = 0;
  static constexpr auto fields =
      field_list(field("mean", &RepeatedShare::mean, "over the repetitions"),
                 field("deviation", &RepeatedShare::deviation, "standard, between repetitions"));
};

// A policy that was run more than once on the episodes, each time with draws of its own.
struct RepeatedPolicy {
  std::string policy;
  int repetitions = 0;
  RepeatedShare strict, clean, partial;
  static constexpr auto fields =
      field_list(field("policy", &RepeatedPolicy::policy, "who acted"),
                 field("repetitions", &RepeatedPolicy::repetitions, "that were run"),
                 field("strict", &RepeatedPolicy::strict, "episodes with all goals reached"),
                 field("clean", &RepeatedPolicy::clean, "strict ones without side effects"),
                 field("partial", &RepeatedPolicy::partial, "mean partial score"));
};

struct LeaderboardTrack {
  episodes::Track track = episodes::Track::checkout;
  std::vector<LeaderboardEntry> entries;
  std::vector<RepeatedPolicy> repeated = {};
  static constexpr auto fields =
      field_list(field("track", &LeaderboardTrack::track, "what kind of task"),
                 field("entries", &LeaderboardTrack::entries, "best first"),
                 field("repeated",
                       &LeaderboardTrack::repeated,
                       "policies of which there is more than one repetition, best first"));
};

struct Leaderboard {
  std::string schema = "market-leaderboard/1";
  std::string version, realism, episodes_hash, instructions;
  std::optional<std::string> set = {};
  episodes::Split split = episodes::Split::planned;
  std::vector<LeaderboardTrack> tracks;
  static constexpr auto fields = field_list(
      field("schema", &Leaderboard::schema, "schema tag", constant("market-leaderboard/1")),
      field("version", &Leaderboard::version, "of the program"),
      field("realism", &Leaderboard::realism, "of all runs"),
      field("episodes_hash", &Leaderboard::episodes_hash, "of the file of episodes"),
      field("set",
            &Leaderboard::set,
            "the set that comes with the program of which all runs are; absent for other files"),
      field("split", &Leaderboard::split, "what the file's episodes were shown to be"),
      field("instructions",
            &Leaderboard::instructions,
            "how the file's goals are told: ids, words, or ids and words"),
      field("tracks", &Leaderboard::tracks, "that the file has"));
};

// Sorted by strict success, then by partial score, then by name. Errors: usage.bad_flag when a
// folder is named twice; results.not_comparable; results.incomplete.
Result<Leaderboard> leaderboard_of(const std::vector<FinishedRun>& runs);

}  // namespace marketgen::evaluation
