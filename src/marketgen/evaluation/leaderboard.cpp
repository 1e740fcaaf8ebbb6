#include "evaluation/leaderboard.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "environments/policy_name.h"
#include "evaluation/paired_tests.h"
#include "evaluation/same_runs.h"

namespace marketgen::evaluation {
namespace {

// Of one run on one track.
struct RankedRun {
  LeaderboardEntry entry;
  std::vector<episodes::EpisodeResult> results;
};

RankedRun ranked(const FinishedRun& run, episodes::Track track) {
  RankedRun made{{}, results_of(run, track)};
  const EvaluationSummary summary = summarize(made.results);
  LeaderboardEntry& entry = made.entry;
  entry.policy = run.record.policy;
  entry.results = run.folder.string();
  entry.commit = run.record.commit();
  entry.repetition = run.record.repetition;
  entry.floor = environments::is_floor(entry.policy);
  entry.episodes = summary.episodes;
  entry.stores = summary.stores;
  entry.strict = summary.strict;
  entry.clean = summary.clean;
  entry.violations = summary.violations;
  entry.partial = summary.partial;
  entry.goals = summary.goals;
  entry.spl = spl_of(made.results);
  const StoreSampling sampling = sampling_of(strict_scores(made.results));
  entry.likeness = sampling.likeness;
  entry.power = power_of_two_runs(entry.strict.share, sampling);
  return made;
}

// For how many are compared.
void correct(LeaderboardTrack& track,
             double PairedComparison::*measured,
             double PairedComparison::*corrected) {
  std::vector<double> p;
  for (const LeaderboardEntry& entry : track.entries)
    if (entry.to_best) p.push_back((*entry.to_best).*measured);
  p = holm(p);
  std::size_t next = 0;
  for (LeaderboardEntry& entry : track.entries)
    if (entry.to_best) (*entry.to_best).*corrected = p[next++];
}

RepeatedShare repeated_share(const std::vector<double>& shares) {
  RepeatedShare made;
  for (const double share : shares)
    made.mean += share / static_cast<double>(shares.size());
  double squares = 0;
  for (const double share : shares)
    squares += (share - made.mean) * (share - made.mean);
  made.deviation = std::sqrt(squares / static_cast<double>(shares.size() - 1));
  return made;
}

// In the order of their first entry. Two runs of one repetition are of different builds: they are
// no repetitions of each other.
std::vector<RepeatedPolicy> repeated_policies(const std::vector<LeaderboardEntry>& entries) {
  std::vector<RepeatedPolicy> made;
  for (const LeaderboardEntry& entry : entries) {
    if (std::ranges::find(made, entry.policy, &RepeatedPolicy::policy) != made.end()) continue;
    std::vector<double> strict, clean, partial;
    std::set<int> repetitions;
    for (const LeaderboardEntry& other : entries) {
      if (other.policy != entry.policy) continue;
      repetitions.insert(other.repetition.value_or(1));
      strict.push_back(other.strict.share);
      clean.push_back(other.clean.share);
      partial.push_back(other.partial.value);
    }
    if (strict.size() < 2 || repetitions.size() < strict.size()) continue;
    made.push_back({entry.policy,
                    static_cast<int>(strict.size()),
                    repeated_share(strict),
                    repeated_share(clean),
                    repeated_share(partial)});
  }
  return made;
}

LeaderboardTrack track_of(const std::vector<FinishedRun>& runs, episodes::Track track) {
  std::vector<RankedRun> all;
  for (const FinishedRun& run : runs)
    all.push_back(ranked(run, track));
  std::ranges::stable_sort(all, [](const RankedRun& a, const RankedRun& b) {
    const auto key = [](const LeaderboardEntry& entry) {
      return std::tuple(-entry.strict.share, -entry.partial.value, entry.policy, entry.results);
    };
    return key(a.entry) < key(b.entry);
  });
  LeaderboardTrack made{track, {}};
  for (RankedRun& run : all) {
    if (&run != &all.front()) {
      run.entry.to_best = compared(run.results, all.front().results);
      run.entry.to_best->against = all.front().entry.policy;
    }
    made.entries.push_back(run.entry);
  }
  correct(made, &PairedComparison::p_strict, &PairedComparison::p_strict_holm);
  correct(made, &PairedComparison::p_partial, &PairedComparison::p_partial_holm);
  made.repeated = repeated_policies(made.entries);
  return made;
}

}  // namespace

PairedComparison compared(const std::vector<episodes::EpisodeResult>& these,
                          const std::vector<episodes::EpisodeResult>& others) {
  PairedComparison made;
  for (std::size_t i = 0; i < these.size(); ++i) {
    made.only_this += these[i].success_strict && !others[i].success_strict ? 1 : 0;
    made.only_other += others[i].success_strict && !these[i].success_strict ? 1 : 0;
  }
  made.p_strict = mcnemar_exact(made.only_this, made.only_other);
  std::vector<double> sums;
  for (const Cluster& store :
       clusters_of(differences(partial_scores(these), partial_scores(others))))
    sums.push_back(store.score);
  made.p_partial = sign_flip_test(sums);
  const auto count = static_cast<double>(std::max<std::size_t>(these.size(), 1));
  made.power =
      power_of_pairs((made.only_this + made.only_other) / count,
                     sampling_of(differences(strict_scores(these), strict_scores(others))));
  return made;
}

Result<Leaderboard> leaderboard_of(const std::vector<FinishedRun>& runs) {
  if (runs.empty()) return Error{"usage.bad_flag", "results", "name a folder of results"};
  std::set<std::filesystem::path> folders;
  for (const FinishedRun& run : runs) {
    std::error_code failed;
    if (!folders.insert(std::filesystem::weakly_canonical(run.folder, failed)).second)
      return Error{"usage.bad_flag", run.folder.string(), "is named twice: name each run once"};
  }
  MARKETGEN_CHECK(check_same_episodes(runs));
  for (const FinishedRun& run : runs)
    MARKETGEN_CHECK(check_complete(run));
  const RunRecord& record = runs.front().record;
  Leaderboard board;
  board.version = record.version;
  board.realism = record.realism;
  board.episodes_hash = record.episodes_hash;
  board.set = common_set(runs);
  board.split = record.split;
  board.instructions = record.instructions;
  for (const episodes::Track track : tracks_of(runs.front()))
    board.tracks.push_back(track_of(runs, track));
  return board;
}

}  // namespace marketgen::evaluation
