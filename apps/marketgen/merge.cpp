// marketgen merge: the shards of one run as a whole.
#include "command.h"
#include "evaluation/merge_runs.h"
#include "io/json.h"
#include "say.h"

namespace marketgen::app {
namespace {

struct MergeFlags {
  CommonFlags common;
  std::vector<std::string> folders;
  std::string output;
};

Result<void> merge(const MergeFlags& flags) {
  if (flags.output.empty())
    return Error{"usage.bad_flag", "--output", "name a folder for the whole run"};
  MARKETGEN_TRY(const evaluation::FinishedRun whole,
                evaluation::merge_folders(flags.folders, flags.output));
  if (flags.common.json)
    fmt::print("{}", io::write_json(evaluation::summarize(whole.results)));
  else if (!flags.common.quiet)
    say("merged      {} episodes of {} shards, policy {}: {}\n",
        whole.results.size(),
        flags.folders.size(),
        whole.record.policy,
        flags.output);
  return {};
}

}  // namespace

Run add_merge(CLI::App& app) {
  auto flags = std::make_shared<MergeFlags>();
  CLI::App* command = app.add_subcommand("merge", "Join the shards of a run (eval --shard)");
  command->add_option("results", flags->folders, "folders of eval")
      ->type_name("RESULTS")
      ->required();
  add_output(*command, "-o,--output", flags->output, "folder for the whole run");
  add_common_flags(*command, flags->common, Takes::json);
  command->footer("Example:  marketgen merge part-1 part-2 -o results");
  return [flags] {
    const auto done = merge(*flags);
    return done.ok() ? 0 : fail(done.error());
  };
}

}  // namespace marketgen::app
