// Policies on all tracks, in the form of the paper's table, with what others have published beside
// them: market-tracks/1.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "evaluation/figure.h"
#include "evaluation/finished_run.h"
#include "evaluation/published.h"
#include "evaluation/text_table.h"

namespace marketgen::evaluation {

struct TrackFigures {
  episodes::Track track = episodes::Track::checkout;
  int episodes = 0, stores = 0;
  Figure sr = {};
  std::optional<Figure> strict = {}, spl = {}, path_m = {};
  static constexpr auto fields = field_list(
      field("track", &TrackFigures::track, "what kind of task"),
      field("episodes", &TrackFigures::episodes, "that were run; 0: not published"),
      field("stores", &TrackFigures::stores, "that they are of; 0: not published"),
      field("sr", &TrackFigures::sr, "mean share of goals, 0..1: the paper's SR"),
      field("strict", &TrackFigures::strict, "share of episodes with all goals, 0..1"),
      field("spl", &TrackFigures::spl, "of tracks with a way to go, 0..1"),
      field("path_m", &TrackFigures::path_m, "driven, an episode; of all, failed ones too"));
};

struct TracksRow {
  std::string policy, commit = {};
  std::string source = {};  // empty: measured here
  bool floor = false;
  std::vector<TrackFigures> tracks = {};
  std::optional<Figure> overall = {};
  static constexpr auto fields =
      field_list(field("policy", &TracksRow::policy, "who acted"),
                 field("commit", &TracksRow::commit, "of the program that ran it"),
                 field("source", &TracksRow::source, "key of who published it; empty: these runs"),
                 field("floor", &TracksRow::floor, "it knows nothing of what is asked for"),
                 field("tracks", &TracksRow::tracks, "those that it was run on"),
                 field("overall", &TracksRow::overall, "mean SR of all tracks, where it has all"));
};

struct TracksTable {
  std::string schema = "market-tracks/1";
  std::string version, realism;
  std::vector<TracksRow> rows;
  std::vector<robots::SourceRow> sources;
  static constexpr auto fields = field_list(
      field("schema", &TracksTable::schema, "schema tag", constant("market-tracks/1")),
      field("version", &TracksTable::version, "of the program"),
      field("realism", &TracksTable::realism, "of all runs"),
      field("rows", &TracksTable::rows, "measured ones by overall SR, floors last; then published"),
      field("sources", &TracksTable::sources, "of published rows"));
};

// A policy may have a run for each track. Intervals are bootstraps over stores
// (evaluation/store_bootstrap.h); strict shares have Wilson's. Errors: usage.bad_flag for a policy
// with two runs of a track; results.not_comparable when runs of a track are of other episodes, or
// any of another version or realism; results.incomplete.
Result<TracksTable> tracks_table(const std::vector<FinishedRun>& runs, const Published& published);

// In percent, with what was run and sources as notes.
TextTable text_of(const TracksTable& table);

}  // namespace marketgen::evaluation
