#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/build_info.h"
#include "base/text.h"
#include "completion_scripts.h"

namespace marketgen::app {
namespace {

std::string with_backslashes(const std::string& text, std::string_view before) {
  std::string out;
  for (const char c : text) {
    if (before.find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

std::string zsh_quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text)
    out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

// "_marketgen-assets-list"
std::string zsh_function(const CommandFacts& command) {
  return fmt::format("_marketgen-{}", fmt::join(command.words, "-"));
}

// What offers words; those that are only the beginning of a value get no blank behind them.
std::string zsh_offer(const std::vector<std::string>& words) {
  std::string whole, begun;
  for (const std::string& word : words)
    (word.ends_with('@') || word.ends_with(':') ? begun : whole) += " " + word;
  std::string text;
  if (!whole.empty()) text += " compadd --" + whole + ";";
  if (!begun.empty()) text += " compadd -S '' --" + begun + ";";
  return text;
}

std::string zsh_kind(const ValueKind& kind) {
  std::string body = zsh_offer(kind.words);
  if (kind.paths == Paths::files) body += " _files;";
  if (kind.paths == Paths::folders) body += " _files -/;";
  return body.empty() ? "" : fmt::format("    {}){};\n", kind.name, body);
}

// ":message:action" of a value.
std::string zsh_value(const std::string& value) {
  const std::vector<std::string> choices = choices_in(value);
  if (!choices.empty()) return fmt::format(":choice:({})", fmt::join(choices, " "));
  return fmt::format(":{}: _marketgen_value {}", value, value);
}

// As _arguments takes it, one a name: "(-o --output)--output=[text]:OUTPUT:…".
std::string zsh_option(const OptionFacts& option) {
  std::string specs;
  const std::string others = option.many ? "*" : fmt::format("({})", fmt::join(option.names, " "));
  for (const std::string& name : option.names) {
    const bool is_long = name.starts_with("--");
    const std::string spec = fmt::format("{}{}{}[{}]{}",
                                         others,
                                         name,
                                         is_long && !option.value.empty() ? "=" : "",
                                         with_backslashes(option.text, "\\[]"),
                                         option.value.empty() ? "" : zsh_value(option.value));
    specs += " \\\n    " + zsh_quoted(spec);
  }
  return specs;
}

std::string zsh_arguments(const CommandFacts& command) {
  std::string specs;
  for (std::size_t i = 0; i < command.arguments.size(); ++i) {
    const OptionFacts& argument = command.arguments[i];
    const std::string where = argument.many ? "*" : std::to_string(i + 1);
    specs += " \\\n    " + zsh_quoted(where + zsh_value(argument.value));
  }
  return specs;
}

// A command's function: its options and arguments, or which of its actions is meant.
std::string zsh_command(const CommandFacts& command) {
  std::string options, names, branches;
  for (const OptionFacts& option : command.options)
    options += zsh_option(option);
  if (command.actions.empty())
    return fmt::format("{}() {{\n  _arguments{}{}\n}}\n\n",
                       zsh_function(command),
                       options,
                       zsh_arguments(command));
  for (const CommandFacts& action : command.actions) {
    const std::string& name = action.words.back();
    names += "\n        " + zsh_quoted(name + ":" + with_backslashes(action.text, "\\:"));
    branches += fmt::format("        {}) {} ;;\n", name, zsh_function(action));
  }
  return fmt::format(R"({}() {{
  local state line
  typeset -A opt_args
  _arguments -C{} \
    '1:command:->command' '*::argument:->argument'
  case $state in
    command)
      local -a commands=({}
      )
      _describe -t commands command commands ;;
    argument)
      case $words[1] in
{}      esac ;;
  esac
}}

)",
                     zsh_function(command),
                     options,
                     names,
                     branches);
}

}  // namespace

std::string zsh_script(const Completions& all) {
  std::string text = fmt::format(
      "#compdef marketgen\n# zsh completion for marketgen {}; `marketgen completion zsh` prints "
      "it.\n\n_marketgen_value() {{  # KIND\n  case $1 in\n",
      program_version);
  for (const ValueKind& kind : all.kinds)
    text += zsh_kind(kind);
  text += "    *) _message \"$1\" ;;\n  esac\n}\n\n";
  for (const CommandFacts* command : all_commands(all.program))
    text += zsh_command(*command);
  // Found in $fpath the file is the function's body; sourced, it is a script.
  return text + R"(if [[ $funcstack[1] = _marketgen ]]; then
  _marketgen- "$@"
else
  _marketgen() { _marketgen- "$@" }
  compdef _marketgen marketgen
fi
)";
}

}  // namespace marketgen::app
