#include "evaluation/differences_table.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "environments/policy_name.h"
#include "evaluation/evaluation_summary.h"
#include "evaluation/leaderboard.h"
#include "evaluation/leaderboard_page.h"
#include "evaluation/paired_tests.h"
#include "evaluation/same_runs.h"

namespace marketgen::evaluation {
namespace {

// "+masks+target", or "standard".
std::string variant_of(const FinishedRun& run, Varied varied) {
  if (varied == Varied::realism) return run.record.realism;
  const std::string& policy = run.record.policy;
  const std::size_t at = policy.find('+');
  return at == std::string::npos ? "" : policy.substr(at);
}

std::string unchanged(Varied varied) {
  return varied == Varied::realism ? "ideal" : "";
}

std::string base_policy(const FinishedRun& run, Varied varied) {
  const std::string& policy = run.record.policy;
  return varied == Varied::realism ? policy : policy.substr(0, policy.find('+'));
}

Error bad(const FinishedRun& run, const std::string& message) {
  return {"usage.bad_flag", run.folder.string(), message};
}

using RunOf = std::pair<std::string, const FinishedRun*>;  // its variant

// The unchanged one first, the others by name.
Result<std::vector<RunOf>> in_order(const std::vector<FinishedRun>& runs, Varied varied) {
  std::map<std::string, const FinishedRun*> variants;
  for (const FinishedRun& run : runs) {
    MARKETGEN_CHECK(check_complete(run));
    const std::string variant = variant_of(run, varied);
    if (!variants.emplace(variant, &run).second)
      return bad(run, fmt::format("is a second run of {} \"{}\"", name_of(varied), variant));
  }
  const auto first = variants.find(unchanged(varied));
  if (first == variants.end())
    return bad(runs.front(),
               varied == Varied::realism
                   ? "no run with realism ideal is named to compare with"
                   : "no run without true modules is named to compare with: run `eval --policy " +
                         base_policy(runs.front(), varied) + "`");
  std::vector<RunOf> ordered{*first};
  variants.erase(first);
  ordered.insert(ordered.end(), variants.begin(), variants.end());
  if (ordered.size() == 1)
    return bad(runs.front(), "there is nothing to compare with: name two runs or more");
  return ordered;
}

Result<void> check_alike(const std::vector<FinishedRun>& runs, Varied varied) {
  for (const FinishedRun& run : runs)
    if (base_policy(run, varied) != base_policy(runs.front(), varied))
      return Error{"results.not_comparable",
                   run.folder.string(),
                   fmt::format("is of {}, {} of {}: name runs of one policy",
                               run.record.policy,
                               runs.front().folder.string(),
                               runs.front().record.policy)};
  return varied == Varied::realism ? check_same_but_realism(runs) : check_same_episodes(runs);
}

DifferenceRow row_of(const RunOf& run,
                     const std::vector<episodes::EpisodeResult>& results,
                     const std::vector<episodes::EpisodeResult>& before) {
  const EvaluationSummary summary = summarize(results);
  DifferenceRow row{run.first, run.second->record.commit(), summary.strict, summary.clean};
  row.sr = summary.partial;
  if (&results == &before) return row;
  const PairedComparison pair = compared(results, before);
  row.gain = estimate_of(differences(partial_scores(results), partial_scores(before)));
  row.p_sr = pair.p_partial;
  row.p_strict = pair.p_strict;
  return row;
}

// For how many there are, all but the first.
void correct(std::vector<DifferenceRow>& rows, std::optional<double> DifferenceRow::*p) {
  std::vector<double> measured;
  for (std::size_t row = 1; row < rows.size(); ++row)
    measured.push_back((rows[row].*p).value());
  const std::vector<double> corrected = holm(measured);
  for (std::size_t row = 1; row < rows.size(); ++row)
    rows[row].*p = corrected[row - 1];
}

Result<DifferencesTrack> track_of(const std::vector<FinishedRun>& runs,
                                  episodes::Track track,
                                  Varied varied) {
  MARKETGEN_CHECK(check_alike(runs, varied));
  MARKETGEN_TRY(const std::vector<RunOf> ordered, in_order(runs, varied));
  const std::vector<episodes::EpisodeResult> before = results_of(*ordered.front().second, track);
  const EvaluationSummary summary = summarize(before);
  DifferencesTrack made{track, summary.episodes, summary.stores, {}};
  made.rows.push_back(row_of(ordered.front(), before, before));
  for (auto run = ordered.begin() + 1; run != ordered.end(); ++run)
    made.rows.push_back(row_of(*run, results_of(*run->second, track), before));
  correct(made.rows, &DifferenceRow::p_sr);
  correct(made.rows, &DifferenceRow::p_strict);
  return made;
}

std::string p_text(const std::optional<double>& p) {
  return p ? fmt::format("{:.4f}", *p) : "";
}

// With its sign.
std::string gain_text(const std::optional<Estimate>& gain) {
  if (!gain) return "";
  return fmt::format(
      "{:+.1f} ({:+.1f} to {:+.1f})", 100 * gain->value, 100 * gain->low, 100 * gain->high);
}

template <class Share>
std::string share_text(const Share& share) {
  return percent_with_interval(share.share, share.low, share.high);
}

}  // namespace

Result<DifferencesTable> differences_table(const std::vector<FinishedRun>& runs, Varied varied) {
  if (runs.empty()) return Error{"usage.bad_flag", "results", "name folders of results"};
  DifferencesTable table;
  table.varied = varied;
  table.version = runs.front().record.version;
  table.policy = base_policy(runs.front(), varied);
  std::map<episodes::Track, std::vector<FinishedRun>> tracks;
  for (const FinishedRun& run : runs)
    for (const episodes::Track track : tracks_of(run))
      tracks[track].push_back(run);
  for (const auto& [track, of_track] : tracks) {
    MARKETGEN_TRY(DifferencesTrack made, track_of(of_track, track, varied));
    table.tracks.push_back(std::move(made));
  }
  return table;
}

TextTable text_of(const DifferencesTable& table) {
  TextTable text{
      {"track", "run", "n", "SR %", "gain, points", "p", "strict %", "p strict", "clean %"},
      {},
      {}};
  for (const DifferencesTrack& track : table.tracks)
    for (const DifferenceRow& row : track.rows) {
      const bool is_policy = table.varied == Varied::truth;
      text.rows.push_back({std::string(name_of(track.track)),
                           (is_policy ? table.policy : "") + row.run,
                           fmt::format("{} of {} stores", track.episodes, track.stores),
                           percent_with_interval(row.sr.value, row.sr.low, row.sr.high),
                           gain_text(row.gain),
                           p_text(row.p_sr),
                           share_text(row.strict),
                           p_text(row.p_strict),
                           share_text(row.clean)});
    }
  text.notes.push_back(fmt::format(
      "Policy {}, version {}. SR: mean share of goals; 95 % intervals and p of SR over stores, "
      "p of strict successes by McNemar; every p corrected for how many there are (Holm).",
      table.policy,
      table.version));
  return text;
}

}  // namespace marketgen::evaluation
