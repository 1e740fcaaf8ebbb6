// Which modules of a policy were first wrong where goals were not reached: market-modules/1, of
// runs whose decisions were kept (eval --record-decisions).
#pragma once
#include <string>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "evaluation/decision_record.h"
#include "evaluation/figure.h"
#include "evaluation/finished_run.h"
#include "evaluation/text_table.h"

namespace marketgen::evaluation {

struct ModuleFailures {
  PolicyModule module = PolicyModule::unknown;
  int goals = 0;
  Figure share = {};
  static constexpr auto fields =
      field_list(field("module", &ModuleFailures::module, "that was wrong first"),
                 field("goals", &ModuleFailures::goals, "that were not reached by that"),
                 field("share", &ModuleFailures::share, "of all goals, 0..1"));
};

struct ModulesRow {
  std::string policy, track, commit;
  int episodes = 0, goals = 0, missed = 0;
  std::vector<ModuleFailures> modules = {};  // those that were wrong, in the order of a goal's way
  static constexpr auto fields =
      field_list(field("policy", &ModulesRow::policy, "who acted"),
                 field("track", &ModulesRow::track, "what kind of task"),
                 field("commit", &ModulesRow::commit, "of the program that ran it"),
                 field("episodes", &ModulesRow::episodes, "that could be run"),
                 field("goals", &ModulesRow::goals, "that were asked for"),
                 field("missed", &ModulesRow::missed, "that were not reached"),
                 field("modules", &ModulesRow::modules, "what was wrong with these"));
};

struct ModulesTable {
  std::string schema = "market-modules/1";
  std::string version, realism;
  std::vector<ModulesRow> rows;
  static constexpr auto fields =
      field_list(field("schema", &ModulesTable::schema, "schema tag", constant("market-modules/1")),
                 field("version", &ModulesTable::version, "of the program"),
                 field("realism", &ModulesTable::realism, "of all runs"),
                 field("rows", &ModulesTable::rows, "one a run and track"));
};

// Errors: usage.bad_flag for no runs; results.incomplete; results.not_comparable for runs of other
// versions or realisms; those of read_decisions; results.changed for decisions of another episode
// than the result's.
Result<ModulesTable> modules_table(const std::vector<FinishedRun>& runs);

// In percent of all goals, with their intervals.
TextTable text_of(const ModulesTable& table);

}  // namespace marketgen::evaluation
