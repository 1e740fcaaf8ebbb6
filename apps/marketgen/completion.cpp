// marketgen completion: prints the script with which a shell completes what is typed.
#include <fmt/format.h>

#include "command.h"
#include "completion_scripts.h"
#include "named_flag.h"

namespace marketgen::app {

const ValueKind* kind_of(const Completions& all, const std::string& value) {
  const auto found = std::ranges::find(all.kinds, value, &ValueKind::name);
  return found == all.kinds.end() ? nullptr : &*found;
}

namespace {

// Every option is of a kind that is known, so that none is forgotten in silence.
Result<void> check_kinds(const Completions& all) {
  for (const CommandFacts* command : all_commands(all.program)) {
    for (const std::vector<OptionFacts>& group : {command->options, command->arguments}) {
      for (const OptionFacts& option : group) {
        if (option.value.empty() || !choices_in(option.value).empty()) continue;
        if (kind_of(all, option.value) == nullptr)
          return Error{
              "internal.bug",
              option.names.empty() ? option.argument : option.names.back(),
              fmt::format("takes {}, a kind that value_kinds.cpp does not have", option.value)};
      }
    }
  }
  return {};
}

Result<std::string> script_for(const CLI::App& program, const std::string& name) {
  MARKETGEN_TRY(const Shell shell, value_of_flag<Shell>("shell", "there is no shell", name));
  Completions all{command_tree(program), {}};
  MARKETGEN_TRY(all.kinds, value_kinds());
  MARKETGEN_CHECK(check_kinds(all));
  switch (shell) {
    case Shell::bash:
      return bash_script(all);
    case Shell::fish:
      return fish_script(all);
    case Shell::zsh:
      return zsh_script(all);
  }
  return Error{"internal.bug", "shell", "has no script"};
}

}  // namespace

Run add_completion(CLI::App& app) {
  auto shell = std::make_shared<std::string>();
  CLI::App* command =
      app.add_subcommand("completion", "Print the script that completes commands in a shell");
  command->add_option("shell", *shell, "for which one")
      ->type_name(choice_of(names_of(Shell{})))
      ->required();
  command->footer(
      "Example:  source <(marketgen completion bash)    # this shell\n"
      "          marketgen completion bash > ~/.local/share/bash-completion/completions/marketgen\n"
      "          marketgen completion zsh > ~/.zfunc/_marketgen    # a folder of $fpath\n"
      "          marketgen completion fish > ~/.config/fish/completions/marketgen.fish");
  return [shell, &app] {
    const auto script = script_for(app, *shell);
    if (!script.ok()) return fail(script.error());
    fmt::print("{}", *script);
    return 0;
  };
}

}  // namespace marketgen::app
