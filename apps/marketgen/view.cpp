// marketgen view: stores in a browser.
#include <cstdio>

#include "base/parallel.h"
#include "command.h"
#include "number_flags.h"
#include "planner_flags.h"
#include "say.h"
#include "server/open_browser.h"
#include "server/serve.h"

namespace marketgen::app {
namespace {

struct ViewFlags {
  CommonFlags common;
  std::vector<std::string> folders;
  server::ServeOptions serve;
  bool no_open = false;
};

void tell(const ViewFlags& flags, const std::string& address) {
  say("view        {}\n", address);
  if (!flags.common.quiet) say("Ctrl-C ends it.\n");
  std::fflush(stdout);  // who reads it through a pipe waits for it
  if (!flags.no_open && !server::open_browser(address) && !flags.common.quiet)
    say("No browser could be started here: open the address in one.\n");
  std::fflush(stdout);
}

Result<void> view(const ViewFlags& flags) {
  const bool shows_something = !flags.folders.empty() || !flags.serve.results.empty();
  if (!shows_something && (flags.serve.read_only || flags.serve.embed))
    return Error{"usage.bad_flag",
                 flags.serve.embed ? "--embed" : "--read-only",
                 "without a store there is nothing to show: name a store folder"};
  const ThreadLimit limit(flags.common.threads);
  MARKETGEN_TRY(catalog::Catalog rows, load_rows());
  return server::serve(
      flags.serve, flags.folders, std::move(rows), [&](const std::string& address) {
        tell(flags, address);
      });
}

void add_what_is_shown(CLI::App& command, ViewFlags& flags) {
  command
      .add_option("folders",
                  flags.folders,
                  "folders of stores and of evaluations; none: the page in which stores are made")
      ->type_name("STORE");
  command
      .add_option("--results",
                  flags.serve.results,
                  "folder of an evaluation in one of the stores, or in those of a set of episodes; "
                  "may be given several times")
      ->type_name("RESULTS");
}

void add_where_it_is_served(CLI::App& command, ViewFlags& flags) {
  constexpr int max_port = 65535;
  command.add_option("--port", flags.serve.port, "port to listen on; 0 = any free one")
      ->check(whole_number(0, max_port))
      ->capture_default_str();
  command.add_flag("--no-open", flags.no_open, "print the address, start no browser");
  command
      .add_option("--host",
                  flags.serve.host,
                  "numeric address to listen on; any but loopback needs --token")
      ->type_name("ADDRESS")
      ->capture_default_str();
  command.add_option("--token", flags.serve.token, "secret that every request must carry")
      ->type_name("SECRET");
}

void add_what_is_made(CLI::App& command, ViewFlags& flags) {
  command
      .add_option("--make-in",
                  flags.serve.make_in,
                  "folder in which stores are kept that are made in the browser")
      ->type_name("FOLDER")
      ->capture_default_str();
  add_planner_choice(command, flags.serve.planner.name, flags.serve.planner.access);
  add_planner_limits(command, flags.serve.planner.access);
  command
      .add_option("--episodes",
                  flags.serve.episodes,
                  "episodes that are driven in the browser; without it they are drawn")
      ->type_name("EPISODES");
  command
      .add_option(
          "--drives", flags.serve.drives, "folder in which logs of what was driven are kept")
      ->type_name("FOLDER")
      ->capture_default_str();
}

void add_how_it_is_shown(CLI::App& command, ViewFlags& flags) {
  command.add_flag(
      "--read-only", flags.serve.read_only, "stores are shown; none is made, edited or driven");
  command.add_flag(
      "--embed",
      flags.serve.embed,
      "pages that this machine serves, as Jupyter's, may show it in a frame; not edited");
}

}  // namespace

Run add_view(CLI::App& app) {
  auto flags = std::make_shared<ViewFlags>();
  CLI::App* command =
      app.add_subcommand("view", "Make, show and edit stores in a browser, until Ctrl-C");
  add_what_is_shown(*command, *flags);
  add_where_it_is_served(*command, *flags);
  add_what_is_made(*command, *flags);
  add_how_it_is_shown(*command, *flags);
  add_common_flags(*command, flags->common, Takes::nothing);
  command->footer(
      "Example:  marketgen view                # describe a store, compare seeds, keep one\n"
      "          marketgen view shop\n"
      "          marketgen view shop other-shop --no-open --port 8080\n"
      "          marketgen view shop --results results   # episodes, with eval --record-motion");
  return [flags] {
    const auto done = view(*flags);
    return done.ok() ? 0 : fail(done.error());
  };
}

}  // namespace marketgen::app
