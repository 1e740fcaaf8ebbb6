// marketgen query: tables of a store as CSV or JSON.
#include <fmt/format.h>

#include "command.h"
#include "io/output.h"
#include "named_flag.h"
#include "scene/query.h"
#include "scene/query_tables.h"
#include "store/store.h"

namespace marketgen::app {
namespace {

struct QueryFlags {
  CommonFlags common;
  std::string folder, table, format = "csv", where, output;
};

Result<void> query(const QueryFlags& flags) {
  io::Outputs outputs;
  MARKETGEN_CHECK(outputs.add({{"--output", flags.output}}));
  MARKETGEN_TRY(const scene::Scene scene, store::open_store_scene(flags.folder));
  MARKETGEN_TRY(const scene::Table table, scene::query_scene(scene, flags.table, flags.where));
  const bool json = flags.common.json || flags.format == "json";
  const std::string text = json ? scene::to_json(table) : scene::to_csv(table);
  if (flags.output.empty()) {
    fmt::print("{}", text);
    return {};
  }
  MARKETGEN_CHECK(outputs.put(flags.output, text));
  return outputs.commit();
}

}  // namespace

Run add_query(CLI::App& app) {
  auto flags = std::make_shared<QueryFlags>();
  CLI::App* command = app.add_subcommand("query", "Print a table of a store as CSV or JSON");
  command->add_option("folder", flags->folder, "store folder")->type_name("STORE")->required();
  command->add_option("table", flags->table, "which table")
      ->type_name(choice_of(scene::query_tables))
      ->required();
  command->add_option("--format", flags->format, "how it is written")
      ->check(CLI::IsMember({"csv", "json"}))
      ->capture_default_str();
  command
      ->add_option("--where",
                   flags->where,
                   "keep rows with column=value (also != < <= > >= ~), commas mean \"and\"")
      ->type_name("FILTER");
  add_output(*command, "-o,--output", flags->output, "write to a file instead");
  add_common_flags(*command, flags->common, Takes::json);
  command->footer(
      "Example:  marketgen query shop products --where zone=dairy,level=2 --format json");
  return [flags] {
    const auto done = query(*flags);
    return done.ok() ? 0 : fail(done.error());
  };
}

}  // namespace marketgen::app
