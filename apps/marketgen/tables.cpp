// marketgen tables: results, and what stores give to ask for, as the tables that papers print.
#include <fmt/ranges.h>

#include "base/interrupt.h"
#include "base/parallel.h"
#include "command.h"
#include "environments/travelling_stores.h"
#include "evaluation/differences_table.h"
#include "evaluation/generator_table.h"
#include "evaluation/goals_table.h"
#include "evaluation/modules_table.h"
#include "evaluation/shapes_table.h"
#include "evaluation/tracks_table.h"
#include "io/file.h"
#include "io/json.h"
#include "io/output.h"
#include "named_flag.h"

namespace marketgen::app {
namespace {

struct TablesFlags {
  CommonFlags common;
  std::vector<std::string> folders;
  std::string format = "text", output;
};

using Action = std::function<Result<std::string>(const TablesFlags&)>;

template <class Table>
Result<std::string> text_of(const Table& table, const TablesFlags& flags) {
  if (flags.common.json) return io::write_json(table);
  MARKETGEN_TRY(
      const evaluation::TableFormat format,
      value_of_flag<evaluation::TableFormat>("--format", "there is no format", flags.format));
  return evaluation::written(evaluation::text_of(table), format);
}

Result<std::string> tracks(const TablesFlags& flags) {
  MARKETGEN_TRY(const std::vector<evaluation::FinishedRun> runs,
                evaluation::read_runs(flags.folders));
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  MARKETGEN_TRY(const evaluation::Published published, evaluation::load_published(data));
  MARKETGEN_TRY(const evaluation::TracksTable table, evaluation::tracks_table(runs, published));
  return text_of(table, flags);
}

Result<std::string> differences(const TablesFlags& flags, evaluation::Varied varied) {
  MARKETGEN_TRY(const std::vector<evaluation::FinishedRun> runs,
                evaluation::read_runs(flags.folders));
  MARKETGEN_TRY(const evaluation::DifferencesTable table,
                evaluation::differences_table(runs, varied));
  return text_of(table, flags);
}

Result<std::string> goals(const TablesFlags& flags) {
  const ThreadLimit limit(flags.common.threads);
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  MARKETGEN_TRY(catalog::Catalog rows, load_rows());
  MARKETGEN_TRY(const environments::NamedStores named,
                environments::open_named_stores(flags.folders, std::move(rows)));
  MARKETGEN_TRY(const evaluation::GoalsTable table,
                until_interrupted([&] { return evaluation::goals_table(named.opened, data); }));
  return text_of(table, flags);
}

Result<std::string> generator(const TablesFlags& flags) {
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  MARKETGEN_TRY(const evaluation::Published published, evaluation::load_published(data));
  MARKETGEN_TRY(const evaluation::GeneratorTable table,
                evaluation::generator_table(flags.folders, published));
  return text_of(table, flags);
}

Result<std::string> shapes(const TablesFlags& flags) {
  MARKETGEN_TRY(const std::vector<evaluation::FinishedRun> runs,
                evaluation::read_runs(flags.folders));
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  MARKETGEN_TRY(const evaluation::Published published, evaluation::load_published(data));
  MARKETGEN_TRY(const catalog::Catalog rows, load_rows());
  MARKETGEN_TRY(const evaluation::ShapesTable table,
                evaluation::shapes_table(runs, rows, published));
  return text_of(table, flags);
}

Result<std::string> modules(const TablesFlags& flags) {
  MARKETGEN_TRY(const std::vector<evaluation::FinishedRun> runs,
                evaluation::read_runs(flags.folders));
  MARKETGEN_TRY(const evaluation::ModulesTable table, evaluation::modules_table(runs));
  return text_of(table, flags);
}

Result<void> print_or_put(const TablesFlags& flags, const Action& action) {
  io::Outputs outputs;
  MARKETGEN_CHECK(outputs.add({{"--output", flags.output}}));
  MARKETGEN_CHECK(
      value_of_flag<evaluation::TableFormat>("--format", "there is no format", flags.format));
  MARKETGEN_TRY(const std::string text, action(flags));
  if (flags.output.empty()) {
    fmt::print("{}", text);
    return {};
  }
  MARKETGEN_CHECK(outputs.put(flags.output, text));
  return outputs.commit();
}

}  // namespace

Run add_tables(CLI::App& app) {
  auto flags = std::make_shared<TablesFlags>();
  auto action = std::make_shared<Action>(tracks);
  CLI::App* command = app.add_subcommand("tables",
                                         "Tables for papers: tracks and shapes beside published "
                                         "scores, swaps, realism, what is asked for");
  command->require_subcommand(1);
  const auto add = [&](const char* name,
                       const char* what,
                       const Action& run,
                       const char* of = "folders of eval or merge") {
    CLI::App* sub = command->add_subcommand(name, what);
    sub->callback([action, run] { *action = run; });
    sub->add_option("folders", flags->folders, of)->type_name("FOLDER")->required();
    sub->add_option("--format", flags->format, "how it is written")
        ->type_name(choice_of(evaluation::names_of(evaluation::TableFormat{})))
        ->capture_default_str();
    add_output(*sub, "-o,--output", flags->output, "file for the table");
    add_common_flags(*sub, flags->common, Takes::json);
  };
  add("tracks",
      "Policies on all tracks, and what others have published (the paper's table 2)",
      tracks);
  add("shapes",
      "Goals by shape (bottles, cans, boxes, bags), and what was published (the paper's table 3)",
      shapes);
  add("modules",
      "Which modules of a policy were first wrong where goals were missed (eval "
      "--record-decisions)",
      modules);
  add("swap",
      "One policy with the truth in the place of modules (eval --truth), beside itself",
      [](const TablesFlags& given) { return differences(given, evaluation::Varied::truth); });
  add("realism",
      "One policy at several levels of realism, beside itself at ideal",
      [](const TablesFlags& given) { return differences(given, evaluation::Varied::realism); });
  add("goals",
      "How much of what stores offer tasks may ask for, by track, tool, category, shape, fixture",
      goals,
      "stores; of a file or set of episodes (v1/checkout) all its stores");
  add("generator",
      "What generated stores are worth (collisions, floor, wishes, time), and published generators",
      generator,
      "stores");
  command->footer(
      "Example:  marketgen tables tracks checkout-run aisle-run --format latex -o table.tex");
  return [flags, action] {
    const auto done = print_or_put(*flags, *action);
    return done.ok() ? 0 : fail(done.error());
  };
}

}  // namespace marketgen::app
