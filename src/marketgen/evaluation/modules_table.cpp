#include "evaluation/modules_table.h"

#include <array>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "evaluation/same_runs.h"

namespace marketgen::evaluation {
namespace {

constexpr auto all_modules = names_of(PolicyModule{});

// Goals of one run's track, one module at a time.
struct TrackFailures {
  ModulesRow row;
  std::map<PolicyModule, int> missed;
  std::map<PolicyModule, std::vector<ScoredEpisode>> shares;  // one entry an episode
};

void add_episode(const episodes::EpisodeResult& result,
                 const EpisodeDecisions& decisions,
                 TrackFailures& track) {
  ++track.row.episodes;
  std::map<PolicyModule, int> missed;
  int asked = 0;
  for (const JudgedGoal& goal : decisions.goals) {
    asked += goal.count;
    if (goal.module != PolicyModule::done) missed[goal.module] += goal.count - goal.reached;
  }
  track.row.goals += asked;
  for (std::size_t i = 0; i < all_modules.size(); ++i) {
    const auto module = static_cast<PolicyModule>(i);
    const auto number = missed.contains(module) ? missed[module] : 0;
    track.missed[module] += number;
    track.row.missed += number;
    track.shares[module].push_back(
        {result.store, static_cast<double>(number), static_cast<double>(asked)});
  }
}

ModulesRow finished(TrackFailures track) {
  for (const auto& [module, number] : track.missed)
    if (number > 0)
      track.row.modules.push_back({module, number, figure_of(estimate_of(track.shares[module]))});
  return std::move(track.row);
}

Result<void> add_run(const FinishedRun& run, ModulesTable& table) {
  for (const episodes::Track track : tracks_of(run)) {
    TrackFailures failures;
    failures.row.policy = run.record.policy;
    failures.row.track = name_of(track);
    failures.row.commit = run.record.commit();
    for (const episodes::EpisodeResult& result : results_of(run, track)) {
      if (!result.error.empty()) continue;
      MARKETGEN_TRY(const EpisodeDecisions decisions, read_decisions(run.folder, result.episode));
      if (decisions.episode_hash != result.episode_hash || decisions.policy != result.policy)
        return Error{"results.changed",
                     decisions_file(run.folder, result.episode).string(),
                     "its decisions are not of the run's result: run the episode again"};
      add_episode(result, decisions, failures);
    }
    table.rows.push_back(finished(std::move(failures)));
  }
  return {};
}

}  // namespace

Result<ModulesTable> modules_table(const std::vector<FinishedRun>& runs) {
  if (runs.empty()) return Error{"usage.bad_flag", "results", "name a folder of results"};
  MARKETGEN_CHECK(check_same_world(runs));
  ModulesTable table;
  table.version = runs.front().record.version;
  table.realism = runs.front().record.realism;
  for (const FinishedRun& run : runs) {
    MARKETGEN_CHECK(check_complete(run));
    MARKETGEN_CHECK(add_run(run, table));
  }
  return table;
}

TextTable text_of(const ModulesTable& table) {
  TextTable text{{"policy", "track", "goals", "missed"}, {}, {}};
  for (std::size_t i = 1; i < all_modules.size(); ++i)
    text.columns.push_back(fmt::format("{} %", all_modules[i]));
  for (const ModulesRow& row : table.rows) {
    std::vector<std::string> cells{
        row.policy, row.track, std::to_string(row.goals), std::to_string(row.missed)};
    cells.resize(text.columns.size());
    for (const ModuleFailures& failures : row.modules)
      cells[3 + static_cast<std::size_t>(failures.module)] = percent(failures.share);
    text.rows.push_back(std::move(cells));
    text.notes.push_back(fmt::format("{}, {}: {}", row.policy, row.track, row.commit));
  }
  text.notes.push_back(
      fmt::format("Of all goals, those that were not reached because that module was wrong first, "
                  "and was not put right; 95 % intervals over stores; version {}, realism {}.",
                  table.version,
                  table.realism));
  return text;
}

}  // namespace marketgen::evaluation
