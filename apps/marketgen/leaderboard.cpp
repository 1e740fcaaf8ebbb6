// marketgen leaderboard: policies side by side on the same episodes.
#include "evaluation/leaderboard.h"
#include "command.h"
#include "evaluation/leaderboard_page.h"
#include "io/json.h"
#include "io/output.h"
#include "leaderboard_table.h"
#include "say.h"

namespace marketgen::app {
namespace {

struct LeaderboardFlags {
  CommonFlags common;
  std::vector<std::string> folders;
  std::string html;
};

Result<void> leaderboard(const LeaderboardFlags& flags) {
  io::Outputs outputs;
  MARKETGEN_CHECK(outputs.add({{"--html", flags.html}}));
  MARKETGEN_TRY(const std::vector<evaluation::FinishedRun> runs,
                evaluation::read_runs(flags.folders));
  MARKETGEN_TRY(const evaluation::Leaderboard board, evaluation::leaderboard_of(runs));
  if (!flags.html.empty()) {
    MARKETGEN_CHECK(outputs.put(flags.html, evaluation::leaderboard_html(board)));
    MARKETGEN_CHECK(outputs.commit());
  }
  if (flags.common.json)
    fmt::print("{}", io::write_json(board));
  else if (!flags.common.quiet)
    print_leaderboard(board);
  return {};
}

}  // namespace

Run add_leaderboard(CLI::App& app) {
  auto flags = std::make_shared<LeaderboardFlags>();
  CLI::App* command = app.add_subcommand(
      "leaderboard", "Rank policies on the same episodes, with intervals and paired tests");
  command->add_option("results", flags->folders, "folders of eval or merge")
      ->type_name("RESULTS")
      ->required();
  add_output(*command, "--html", flags->html, "HTML page of the same");
  add_common_flags(*command, flags->common, Takes::json);
  command->footer(
      "Example:  marketgen leaderboard oracle classical random --html leaderboard.html");
  return [flags] {
    const auto done = leaderboard(*flags);
    return done.ok() ? 0 : fail(done.error());
  };
}

}  // namespace marketgen::app
