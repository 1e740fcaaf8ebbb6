// Evaluations as a page lists them beside the stores in which they happened.
#pragma once
#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "episodes/episode_result.h"
#include "evaluation/finished_run.h"
#include "store/store.h"

namespace marketgen::server {

struct FailureCount {
  std::string code;
  int episodes = 0;
  static constexpr auto fields =
      field_list(field("code", &FailureCount::code, "as results have it; None: none failed"),
                 field("episodes", &FailureCount::episodes, "how many ended so"));
};

struct RunLine {
  int run = 0;
  std::string folder, policy, realism, version, split, instructions;
  int episodes = 0, strict = 0, clean = 0;
  std::vector<FailureCount> failures;
  static constexpr auto fields =
      field_list(field("run", &RunLine::run, "its number in addresses"),
                 field("folder", &RunLine::folder, "last part of its folder's path"),
                 field("policy", &RunLine::policy, "who acted"),
                 field("realism", &RunLine::realism, "what stood between the world and the robot"),
                 field("version", &RunLine::version, "of the program"),
                 field("split", &RunLine::split, "what the episodes were shown to be"),
                 field("instructions", &RunLine::instructions, "how goals were told"),
                 field("episodes", &RunLine::episodes, "that have a result in this store"),
                 field("strict", &RunLine::strict, "that reached all goals"),
                 field("clean", &RunLine::clean, "that did so without harm"),
                 field("failures", &RunLine::failures, "of this store's, most frequent first"));
};

struct RunList {
  std::vector<RunLine> runs;
  static constexpr auto fields = field_list(
      field("runs", &RunList::runs, "with episodes in the store, in the command line's order"));
};

struct EpisodeLine {
  std::uint32_t episode = 0;
  std::string id;
  episodes::Track track = episodes::Track::checkout;
  std::string failure, error, detail;
  int hits = 0, asked = 0;
  double partial = 0;
  bool strict = false, clean = false, is_void = false, recorded = false;
  double simulated_s = 0;
  static constexpr auto fields = field_list(
      field("episode", &EpisodeLine::episode, "its number in addresses of the run"),
      field("id", &EpisodeLine::id, "of the episode"),
      field("track", &EpisodeLine::track, "what kind of task"),
      field("failure", &EpisodeLine::failure, "what kept the agent from its goals"),
      field("error", &EpisodeLine::error, "for which it could not be run"),
      field("detail", &EpisodeLine::detail, "of that, or of what broke it off"),
      field("hits", &EpisodeLine::hits, "goals that count"),
      field("asked", &EpisodeLine::asked, "goals that there are"),
      field("partial", &EpisodeLine::partial, "hits of asked"),
      field("strict", &EpisodeLine::strict, "all goals"),
      field("clean", &EpisodeLine::clean, "strict, and within the limits"),
      field("void", &EpisodeLine::is_void, "the basket was tilted too far, or somebody was hurt"),
      field("recorded", &EpisodeLine::recorded, "there is a motion to be watched"),
      field("simulated_s", &EpisodeLine::simulated_s, "until it was judged"));
};

struct RunEpisodes {
  RunLine run;
  std::vector<EpisodeLine> episodes;
  static constexpr auto fields =
      field_list(field("run", &RunEpisodes::run, "the run"),
                 field("episodes", &RunEpisodes::episodes, "of this store, in the run's order"));
};

// Runs that were read, in order. Immutable.
class ReplayRuns {
 public:
  using Stores = std::vector<std::shared_ptr<const store::Store>>;
  // Errors: those of read_runs.
  static Result<ReplayRuns> read(const std::vector<std::string>& folders);

  // Scenes of the runs that have no episode in any of the stores.
  std::set<std::string> scenes_without(const Stores& stores) const;
  // Error episode.other_store: a run has no episode in any of them.
  Result<void> check_shown_in(const Stores& stores) const;

  std::size_t size() const { return runs_.size(); }
  const evaluation::FinishedRun& run(std::size_t number) const { return runs_[number]; }
  RunList of_store(const std::string& scene_hash) const;
  RunEpisodes episodes(std::size_t run, const std::string& scene_hash) const;
  EpisodeLine line_of(std::size_t run, std::size_t episode) const;

 private:
  std::vector<evaluation::FinishedRun> runs_;
};

}  // namespace marketgen::server
