#include "evaluation/tracks_table.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "environments/policy_name.h"
#include "evaluation/evaluation_summary.h"
#include "evaluation/same_runs.h"
#include "evaluation/table_remarks.h"

namespace marketgen::evaluation {
namespace {

TrackFigures figures_of(const std::vector<episodes::EpisodeResult>& results,
                        episodes::Track track) {
  const EvaluationSummary summary = summarize(results);
  TrackFigures made{track, summary.episodes, summary.stores};
  made.sr = figure_of(summary.partial);
  made.strict = Figure{summary.strict.share, summary.strict.low, summary.strict.high};
  if (const auto spl = spl_of(results)) {
    made.spl = figure_of(*spl);
    std::vector<ScoredEpisode> driven;
    for (const episodes::EpisodeResult& result : results)
      driven.push_back({store_of(result), result.path_m});
    made.path_m = figure_of(estimate_of(driven));
  }
  return made;
}

TracksRow published_row(const PublishedPolicy& policy) {
  TracksRow row{policy.policy, "", policy.source};
  for (const PublishedTrack& track : policy.tracks) {
    TrackFigures figures{track.track};
    figures.sr = {track.sr};
    if (track.spl) figures.spl = Figure{*track.spl};
    if (track.path_m) figures.path_m = Figure{*track.path_m};
    row.tracks.push_back(figures);
  }
  row.overall = Figure{policy.overall_sr};
  return row;
}

// Of one policy, track by track, as they are found.
struct PolicyRuns {
  TracksRow row;
  std::vector<std::vector<ScoredEpisode>> scores;  // of its tracks
};

Result<void> add_run(const FinishedRun& run, PolicyRuns& policy) {
  for (const episodes::Track track : tracks_of(run)) {
    if (std::ranges::find(policy.row.tracks, track, &TrackFigures::track) !=
        policy.row.tracks.end())
      return Error{
          "usage.bad_flag",
          run.folder.string(),
          fmt::format("is a second run of {} on {}: name one", run.record.policy, name_of(track))};
    const std::vector<episodes::EpisodeResult> results = results_of(run, track);
    policy.row.tracks.push_back(figures_of(results, track));
    policy.scores.push_back(partial_scores(results));
  }
  const std::string commit = run.record.commit();
  if (policy.row.commit.empty())
    policy.row.commit = commit;
  else if (policy.row.commit != commit)
    policy.row.commit += ", " + commit;
  return {};
}

Result<std::vector<PolicyRuns>> runs_by_policy(const std::vector<FinishedRun>& runs) {
  std::vector<PolicyRuns> policies;
  for (const FinishedRun& run : runs) {
    MARKETGEN_CHECK(check_complete(run));
    const std::string& name = run.record.policy;
    auto at = std::ranges::find_if(
        policies, [&](const PolicyRuns& policy) { return policy.row.policy == name; });
    if (at == policies.end()) {
      at = policies.insert(at, PolicyRuns{{name}, {}});
      at->row.floor = environments::is_floor(name);
    }
    MARKETGEN_CHECK(add_run(run, *at));
  }
  for (PolicyRuns& policy : policies)
    if (policy.scores.size() == episodes::all_tracks.size())
      policy.row.overall = figure_of(estimate_of_mean(policy.scores));
  return policies;
}

// Those of a track must be of the same episodes, and all of one version and realism.
Result<void> check_alike(const std::vector<FinishedRun>& runs) {
  std::map<episodes::Track, std::vector<FinishedRun>> tracks;
  for (const FinishedRun& run : runs)
    for (const episodes::Track track : tracks_of(run))
      tracks[track].push_back(run);
  for (const auto& [track, of_track] : tracks)
    MARKETGEN_CHECK(check_same_episodes(of_track));
  return check_same_world(runs);
}

double rank(const TracksRow& row) {
  if (row.overall) return row.overall->value;
  double sum = 0;
  for (const TrackFigures& track : row.tracks)
    sum += track.sr.value;
  return sum / static_cast<double>(episodes::all_tracks.size());
}

// ---- As text ----

std::string metres(const std::optional<Figure>& figure) {
  if (!figure) return "";
  if (!figure->low || !figure->high) return fmt::format("{:.2f}", figure->value);
  return fmt::format("{:.1f} ({:.1f} to {:.1f})", figure->value, *figure->low, *figure->high);
}

const TrackFigures* find_track(const TracksRow& row, episodes::Track track) {
  const auto at = std::ranges::find(row.tracks, track, &TrackFigures::track);
  return at == row.tracks.end() ? nullptr : &*at;
}

// A track has columns of the way driven where a row has such figures.
bool is_driven(const TracksTable& table, episodes::Track track) {
  return std::ranges::any_of(table.rows, [&](const TracksRow& row) {
    const TrackFigures* figures = find_track(row, track);
    return figures != nullptr && figures->path_m.has_value();
  });
}

std::vector<std::string> header(const TracksTable& table) {
  std::vector<std::string> names{"policy"};
  for (const episodes::Track track : episodes::all_tracks) {
    const std::string name(name_of(track));
    for (const char* figure : {" n", " SR %", " strict %"})
      names.push_back(name + figure);
    if (!is_driven(table, track)) continue;
    for (const char* figure : {" SPL %", " PL m"})
      names.push_back(name + figure);
  }
  names.emplace_back("overall SR %");
  return names;
}

std::vector<std::string> cells(const TracksTable& table, const TracksRow& row) {
  std::vector<std::string> out{row.policy + (row.floor ? " (floor)" : "") +
                               (row.source.empty() ? "" : " [" + row.source + "]")};
  for (const episodes::Track track : episodes::all_tracks) {
    const TrackFigures* found = find_track(row, track);
    const TrackFigures figures = found != nullptr ? *found : TrackFigures{track};
    out.push_back(figures.episodes > 0
                      ? fmt::format("{} of {} stores", figures.episodes, figures.stores)
                      : "");
    out.push_back(found != nullptr ? percent(figures.sr) : "");
    out.push_back(percent(figures.strict));
    if (!is_driven(table, track)) continue;
    out.push_back(percent(figures.spl));
    out.push_back(metres(figures.path_m));
  }
  out.push_back(percent(row.overall));
  return out;
}

}  // namespace

Result<TracksTable> tracks_table(const std::vector<FinishedRun>& runs, const Published& published) {
  if (runs.empty()) return Error{"usage.bad_flag", "results", "name a folder of results"};
  MARKETGEN_CHECK(check_alike(runs));
  MARKETGEN_TRY(const std::vector<PolicyRuns> policies, runs_by_policy(runs));
  TracksTable table;
  table.version = runs.front().record.version;
  table.realism = runs.front().record.realism;
  for (const PolicyRuns& policy : policies)
    table.rows.push_back(policy.row);
  std::ranges::stable_sort(table.rows, [](const TracksRow& a, const TracksRow& b) {
    return a.floor != b.floor ? b.floor : rank(a) > rank(b);
  });
  for (const PublishedPolicy& policy : published.policies)
    table.rows.push_back(published_row(policy));
  std::vector<std::string> keys;
  for (const TracksRow& row : table.rows)
    keys.push_back(row.source);
  table.sources = cited_sources(published.sources, keys);
  return table;
}

TextTable text_of(const TracksTable& table) {
  TextTable text{header(table), {}, {}};
  for (const TracksRow& row : table.rows)
    text.rows.push_back(cells(table, row));
  text.notes.push_back(
      fmt::format("SR: mean share of goals; 95 % intervals over stores; version {}, realism {}.",
                  table.version,
                  table.realism));
  for (std::string& remark :
       table_remarks(std::ranges::any_of(table.rows, &TracksRow::floor), table.realism))
    text.notes.push_back(std::move(remark));
  for (const TracksRow& row : table.rows)
    if (!row.commit.empty()) text.notes.push_back(row.policy + ": " + row.commit);
  for (const robots::SourceRow& source : table.sources)
    text.notes.push_back("[" + source.key + "] " + source.text);
  return text;
}

}  // namespace marketgen::evaluation
