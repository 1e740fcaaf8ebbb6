// Scores that others have published, as rows: data/benchmark/published.json, market-published/1.
// They stand beside ours and are not compared with them: other stores and other episodes.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "episodes/track.h"
#include "robots/robot_row.h"

namespace marketgen::evaluation {

// Shares are 0..1; `sr` is of goals (EvaluationSummary::success_partial), as the paper's SR is.
struct PublishedTrack {
  episodes::Track track = episodes::Track::checkout;
  double sr = 0;
  std::optional<double> spl, path_m;
  static constexpr auto fields =
      field_list(field("track", &PublishedTrack::track, "what kind of task", required()),
                 field("sr", &PublishedTrack::sr, "mean share of goals", required(), range(0, 1)),
                 field("spl", &PublishedTrack::spl, "weighted by path length", range(0, 1)),
                 field("path_m", &PublishedTrack::path_m, "driven, an episode", range(0, 1e4)));
};

struct PublishedPolicy {
  std::string policy;
  std::vector<PublishedTrack> tracks;
  double overall_sr = 0;
  std::string source;
  static constexpr auto fields =
      field_list(field("policy", &PublishedPolicy::policy, "who acted", required()),
                 field("tracks", &PublishedPolicy::tracks, "its scores", required()),
                 field("overall_sr", &PublishedPolicy::overall_sr, "of all tracks", range(0, 1)),
                 field("source", &PublishedPolicy::source, "keys, by blanks", required()));
};

struct Published {
  std::string schema = "market-published/1";
  std::vector<robots::SourceRow> sources;
  std::vector<PublishedPolicy> policies;
  static constexpr auto fields =
      field_list(field("schema", &Published::schema, "schema tag", constant("market-published/1")),
                 field("sources", &Published::sources, "where the figures are from"),
                 field("policies", &Published::policies, "that were scored"));
};

// `data`: usually data_folder(). Errors: io.*; those of read_json; catalog.bad_row for a source
// that the file does not list.
Result<Published> load_published(const std::filesystem::path& data);

}  // namespace marketgen::evaluation
