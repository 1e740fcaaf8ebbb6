// marketgen: the command line. Reads the arguments, runs one command, turns errors into exit
// statuses.
#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <system_error>

#include "base/interrupt.h"
#include "base/progress.h"
#include "base/text.h"
#include "build_facts.h"
#include "command.h"
#include "io/destination.h"

namespace marketgen::app {
namespace {

struct Entry {
  CLI::App* app;
  Run run;
};

std::vector<Entry> add_commands(CLI::App& app) {
  std::vector<Entry> entries;
  const auto add = [&](Run run) {
    entries.push_back({app.get_subcommands({}).back(), std::move(run)});
  };
#define COMMAND(name) add(add_##name(app));
#include "commands.inc"
#undef COMMAND
  return entries;
}

// The command whose flags were being read when parsing failed, and the first word after its name.
struct Question {
  const CLI::App* command;
  std::string next;
};

Question question_of(const CLI::App& app, int argc, char** argv) {
  Question question{&app, argc > 1 ? argv[1] : ""};
  for (int i = 1; i < argc; ++i) {
    for (const CLI::App* sub : question.command->get_subcommands({})) {
      if (sub->get_name() == argv[i]) question = {sub, i + 1 < argc ? argv[i + 1] : ""};
    }
  }
  return question;
}

std::vector<std::string> known_flags(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames())
      names.push_back("--" + name);
  }
  return names;
}

Error unknown_command(const CLI::App& app, const std::string& word) {
  std::vector<std::string_view> names;
  for (const CLI::App* sub : app.get_subcommands({}))
    names.push_back(sub->get_name());
  return {"usage.unknown_command",
          word,
          fmt::format("there is no such command; commands are: {}{}",
                      fmt::join(names, ", "),
                      did_you_mean(word, names))};
}

// As it is typed: "marketgen assets show".
std::string full_name(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return parent == nullptr ? "marketgen" : full_name(*parent) + " " + command.get_name();
}

// CLI11's message in our form, with the nearest flag when one was misspelt.
int report_usage(const CLI::App& app, const CLI::ParseError& error, int argc, char** argv) {
  if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
  const auto [found, next] = question_of(app, argc, argv);
  const CLI::App& command = *found;
  const bool wants_command = !command.get_subcommands({}).empty();
  if (wants_command && !next.empty() && next[0] != '-') return fail(unknown_command(command, next));
  const std::vector<std::string> flags = known_flags(command);
  const std::vector<std::string_view> names(flags.begin(), flags.end());
  std::string hint;
  for (int i = 1; i < argc; ++i) {
    const std::string word = split(argv[i], '=')[0];
    if (word.starts_with("--") && std::find(flags.begin(), flags.end(), word) == flags.end())
      hint = did_you_mean(word, names);
  }
  const std::string name = full_name(command);
  return fail(
      {"usage.bad_flag", name, fmt::format("{}{} (see: {} --help)", error.what(), hint, name)});
}

int run(int argc, char** argv) {
  CLI::App app("Turns a sentence into a complete, stocked supermarket that robots can work in.",
               "marketgen");
  app.set_version_flag(
      "--version", version_text, "Print what this build is, and its libraries, and exit");
  app.require_subcommand(1);
  app.footer(
      "Start with:  marketgen generate \"a small supermarket with a bakery by the entrance\" -o "
      "shop");
  const std::vector<Entry> entries = add_commands(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return report_usage(app, error, argc, argv);
  }
  for (const Entry& entry : entries) {
    if (entry.app->parsed()) return entry.run();
  }
  return 2;
}

// What was printed must have gone out; a reader who has closed the pipe has seen what he wanted.
int checked_output(int status, int fault) {
  constexpr int ended_by_closed_pipe = 128 + SIGPIPE;
  if (fault == 0 && std::fflush(stdout) != 0) fault = errno;
  if (fault == 0 && std::ferror(stdout) != 0) fault = EIO;
  if (fault == 0) return status;
  if (fault == EPIPE) return ended_by_closed_pipe;
  return fail(io::cannot_write("standard output", "cannot be written", fault));
}

int run_safely(int argc, char** argv) {
  try {
    return checked_output(run(argc, argv), 0);
  } catch (const Interrupted&) {
    return fail(interrupted_error());
  } catch (const std::bad_alloc&) {
    return fail(
        {"io.out_of_memory", "", "there is not enough memory; try a smaller store or picture"});
  } catch (const std::system_error& error) {
    if (std::ferror(stdout) != 0) return checked_output(0, error.code().value());
    return fail({"internal.bug", "", error.what()});
  } catch (const std::exception& error) {
    return fail({"internal.bug", "", error.what()});
  }
}

}  // namespace
}  // namespace marketgen::app

int main(int argc, char** argv) {
  marketgen::watch_for_interrupts();
  if (const char* const level = std::getenv("MARKETGEN_LOG")) marketgen::set_log_level(level);
  return marketgen::app::run_safely(argc, argv);
}
