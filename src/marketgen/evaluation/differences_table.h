// What a change is worth: runs of the very same episodes, each beside the one that was not changed,
// track by track: market-differences/1.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "evaluation/finished_run.h"
#include "evaluation/store_bootstrap.h"
#include "evaluation/text_table.h"
#include "grasping/grasp_shares.h"

namespace marketgen::evaluation {

// What may differ from run to run. truth: modules of one policy in whose place the truth stands;
// the run without any is the one that is compared with. realism: that of one policy; `ideal` is the
// one that is compared with.
enum class Varied { truth, realism };
constexpr std::array<std::string_view, 2> names_of(Varied) {
  return {"truth", "realism"};
}

struct DifferenceRow {
  std::string run, commit;
  grasping::Share strict, clean;
  Estimate sr = {};
  std::optional<Estimate> gain = {};
  std::optional<double> p_sr = {}, p_strict = {};
  static constexpr auto fields = field_list(
      field("run", &DifferenceRow::run, "the policy with its true modules, or the realism"),
      field("commit", &DifferenceRow::commit, "of the program that ran it"),
      field("strict", &DifferenceRow::strict, "episodes with all goals reached"),
      field("clean", &DifferenceRow::clean, "strict ones without side effects"),
      field("sr", &DifferenceRow::sr, "mean share of goals"),
      field("gain", &DifferenceRow::gain, "in sr, episode by episode; none of the first itself"),
      field("p_sr",
            &DifferenceRow::p_sr,
            "signs of the stores' sums flipped; corrected for how many rows there are (Holm)"),
      field("p_strict",
            &DifferenceRow::p_strict,
            "of strict successes: McNemar, exact; corrected likewise"));
};

struct DifferencesTrack {
  episodes::Track track = episodes::Track::checkout;
  int episodes = 0, stores = 0;
  std::vector<DifferenceRow> rows;
  static constexpr auto fields =
      field_list(field("track", &DifferencesTrack::track, "what kind of task"),
                 field("episodes", &DifferencesTrack::episodes, "the same in all runs"),
                 field("stores", &DifferencesTrack::stores, "that they are of"),
                 field("rows", &DifferencesTrack::rows, "the unchanged one first"));
};

struct DifferencesTable {
  std::string schema = "market-differences/1";
  Varied varied = Varied::truth;
  std::string version, policy;
  std::vector<DifferencesTrack> tracks;
  static constexpr auto fields = field_list(
      field("schema", &DifferencesTable::schema, "schema tag", constant("market-differences/1")),
      field("varied", &DifferencesTable::varied, "what differs from run to run"),
      field("version", &DifferencesTable::version, "of the program"),
      field("policy", &DifferencesTable::policy, "without true modules"),
      field("tracks", &DifferencesTable::tracks, "that were run"));
};

// Errors: usage.bad_flag when a track has no unchanged run, only that one, or one variant twice;
// results.not_comparable when runs of a track differ in anything else; results.incomplete.
Result<DifferencesTable> differences_table(const std::vector<FinishedRun>& runs, Varied varied);

// In percent.
TextTable text_of(const DifferencesTable& table);

}  // namespace marketgen::evaluation
