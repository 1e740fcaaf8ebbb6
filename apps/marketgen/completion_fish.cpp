#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/build_info.h"
#include "completion_scripts.h"

namespace marketgen::app {
namespace {

std::string fish_quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') out += '\\';
    out += c;
  }
  return out + "'";
}

std::string fish_kind(const ValueKind& kind) {
  if (kind.words.empty()) return "";
  return fmt::format(
      "    case {}\n      printf '%s\\n' {}\n", kind.name, fmt::join(kind.words, " "));
}

// The flags of `complete` for a value, or for an argument.
std::string fish_offer(const Completions& all, const std::string& value) {
  const std::vector<std::string> choices = choices_in(value);
  if (!choices.empty()) return " -a " + fish_quoted(fmt::format("{}", fmt::join(choices, " ")));
  const ValueKind* kind = kind_of(all, value);
  if (kind == nullptr) return "";
  std::string flags;
  if (!kind->words.empty()) flags += fmt::format(" -a '(__marketgen_words {})'", kind->name);
  if (kind->paths == Paths::files) flags += " -F";
  if (kind->paths == Paths::folders) flags += " -a '(__fish_complete_directories)'";
  return flags;
}

std::string fish_option(const Completions& all,
                        const std::string& when,
                        const OptionFacts& option) {
  std::string line = "complete -c marketgen -n " + when;
  for (const std::string& name : option.names)
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  // -r: it has a value; -f: which is no file, unless -F says so.
  const std::string offer = fish_offer(all, option.value);
  if (!option.value.empty()) line += offer.ends_with(" -F") ? " -r" : " -r -f";
  return line + offer + " -d " + fish_quoted(option.text) + "\n";
}

std::string fish_command(const Completions& all, const CommandFacts& command) {
  const bool whole = command.actions.empty();
  const std::string when = fish_quoted(
      fmt::format("__marketgen_{} {}", whole ? "in" : "at", fmt::join(command.words, " ")));
  std::string lines;
  for (const CommandFacts& action : command.actions)
    lines += fmt::format("complete -c marketgen -n {} -a {} -d {}\n",
                         when,
                         action.words.back(),
                         fish_quoted(action.text));
  for (const OptionFacts& option : command.options)
    lines += fish_option(all, when, option);
  for (const OptionFacts& argument : command.arguments)
    if (const std::string offer = fish_offer(all, argument.value); !offer.empty())
      lines += fmt::format("complete -c marketgen -n {}{}\n", when, offer);
  return lines;
}

constexpr const char* fish_head =
    R"(# fish completion for marketgen {}; `marketgen completion fish` prints it.

# What was typed before the cursor are these words and no more.
function __marketgen_at
  set -l words (commandline -opc)
  test "$words[2..]" = "$argv"
end

# ... begins with these words.
function __marketgen_in
  set -l words (commandline -opc)
  set -l end (math 1 + (count $argv))
  test (count $words) -ge $end; and test "$words[2..$end]" = "$argv"
end

function __marketgen_words  # KIND
  switch $argv[1]
{}  end
end

complete -c marketgen -f
)";

}  // namespace

std::string fish_script(const Completions& all) {
  std::string kinds;
  for (const ValueKind& kind : all.kinds)
    kinds += fish_kind(kind);
  std::string text = fmt::format(fish_head, program_version, kinds);
  for (const CommandFacts* command : all_commands(all.program))
    text += fish_command(all, *command);
  return text;
}

}  // namespace marketgen::app
