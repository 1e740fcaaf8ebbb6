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

// Shares of tries at which one grasp model took up products of four shapes.
struct PublishedShapes {
  std::string place;  // "simulation", "real robot"
  int tries = 0;
  double bottles = 0, cans = 0, boxes = 0, bags = 0;
  std::string source;
  static constexpr auto fields = field_list(
      field("place", &PublishedShapes::place, "where it was tried", required()),
      field("tries", &PublishedShapes::tries, "of each shape", required(), range(1, 1e6)),
      field("bottles", &PublishedShapes::bottles, "share that succeeded", range(0, 1)),
      field("cans", &PublishedShapes::cans, "share that succeeded", range(0, 1)),
      field("boxes", &PublishedShapes::boxes, "share that succeeded", range(0, 1)),
      field("bags", &PublishedShapes::bags, "share that succeeded", range(0, 1)),
      field("source", &PublishedShapes::source, "keys, by blanks", required()));
};

// What a generator of scenes was measured at, by itself or by others.
struct PublishedGenerator {
  std::string generator, metric;  // a metric of market-generator/1
  double value = 0;
  std::string source;
  static constexpr auto fields =
      field_list(field("generator", &PublishedGenerator::generator, "its name", required()),
                 field("metric", &PublishedGenerator::metric, "of market-generator/1", required()),
                 field("value", &PublishedGenerator::value, "in the metric's unit", required()),
                 field("source", &PublishedGenerator::source, "keys, by blanks", required()));
};

struct Published {
  std::string schema = "market-published/1";
  std::vector<robots::SourceRow> sources;
  std::vector<PublishedPolicy> policies;
  std::vector<PublishedShapes> shapes;
  std::vector<PublishedGenerator> generators;
  static constexpr auto fields =
      field_list(field("schema", &Published::schema, "schema tag", constant("market-published/1")),
                 field("sources", &Published::sources, "where the figures are from"),
                 field("policies", &Published::policies, "that were scored"),
                 field("shapes", &Published::shapes, "grasps by shape"),
                 field("generators", &Published::generators, "of scenes"));
};

// `data`: usually data_folder(). Errors: io.*; those of read_json; catalog.bad_row for a source
// that the file does not list.
Result<Published> load_published(const std::filesystem::path& data);

}  // namespace marketgen::evaluation
