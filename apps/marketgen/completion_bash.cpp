#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/build_info.h"
#include "completion_scripts.h"

namespace marketgen::app {
namespace {

std::string bash_word(const std::string& word) {
  return "'" + word + "'";  // no name and no kind has a quote in it
}

std::string bash_list(const std::vector<std::string>& words) {
  std::vector<std::string> all;
  for (const std::string& word : words)
    all.push_back(bash_word(word));
  return fmt::format("({})", fmt::join(all, " "));
}

// One branch of _marketgen_offer().
std::string bash_kind(const ValueKind& kind) {
  std::string body;
  if (!kind.words.empty()) body += fmt::format(" words={};", bash_list(kind.words));
  if (kind.paths == Paths::files) body += " _marketgen_paths -f \"$2\";";
  if (kind.paths == Paths::folders) body += " _marketgen_paths -d \"$2\";";
  return body.empty() ? "" : fmt::format("    {}){};\n", kind.name, body);
}

// One branch of _marketgen_of(): "name=KIND" for options with a value, "KIND*" for arguments that
// may follow one another.
std::string bash_command(const CommandFacts& command) {
  std::vector<std::string> actions, options, arguments;
  for (const CommandFacts& action : command.actions)
    actions.push_back(action.words.back());
  for (const OptionFacts& option : command.options)
    for (const std::string& name : option.names)
      options.push_back(option.value.empty() ? name : name + "=" + option.value);
  for (const OptionFacts& argument : command.arguments)
    arguments.push_back(argument.value + (argument.many ? "*" : ""));
  return fmt::format("    '{}')\n      actions={}\n      options={}\n      arguments={} ;;\n",
                     fmt::join(command.words, " "),
                     bash_list(actions),
                     bash_list(options),
                     bash_list(arguments));
}

constexpr const char* bash_head =
    R"(# bash completion for marketgen {}; `marketgen completion bash` prints it.

_marketgen_paths() {{  # -f|-d CURRENT
  local found=()
  mapfile -t found < <(compgen "$1" -- "$2")
  COMPREPLY+=("${{found[@]}}")
  compopt -o filenames 2> /dev/null
}}

)";

constexpr const char* bash_offer = R"(_marketgen_offer() {{  # KIND CURRENT: what may stand there
  local words=() word
  case $1 in
    *'{{'*'}}') word=${{1#*'{{'}}; IFS=, read -ra words <<< "${{word%'}}'}}" ;;
{}  esac
  for word in "${{words[@]}}"; do
    if [[ $word == "$2"* ]]; then COMPREPLY+=("$word"); fi
  done
  # What is only the beginning of a value gets no blank behind it.
  if [[ ${{#COMPREPLY[@]}} = 1 && ${{COMPREPLY[0]}} == *[@:] ]]; then compopt -o nospace 2> /dev/null; fi
}}

)";

constexpr const char* bash_tree =
    R"(_marketgen_of() {{  # COMMAND: sets actions, options and arguments
  case $1 in
{}  esac
}}

)";

constexpr const char* bash_body = R"(_marketgen() {
  local current=${COMP_WORDS[COMP_CWORD]} command='' expected='' place=0 i word option
  local actions options arguments
  COMPREPLY=()
  _marketgen_of ''
  for ((i = 1; i < COMP_CWORD; i++)); do
    word=${COMP_WORDS[i]}
    if [[ $word == '=' ]]; then  # bash splits --name=value there, and so it does column=value
      if [[ -z $expected ]]; then ((i += 1)); fi
    elif [[ -n $expected ]]; then
      expected=''
    elif [[ $word == -* ]]; then
      for option in "${options[@]}"; do
        if [[ $option == "$word="* ]]; then expected=${option#*=}; fi
      done
    elif [[ " ${actions[*]} " == *" $word "* ]]; then
      command=${command:+$command }$word
      _marketgen_of "$command"
    else
      ((place += 1))
    fi
  done
  if [[ $current == '=' ]]; then current=''; fi

  if [[ -n $expected ]]; then
    _marketgen_offer "$expected" "$current"
  elif [[ $current == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "${options[*]%%=*}" -- "$current")
  elif ((${#actions[@]})); then
    mapfile -t COMPREPLY < <(compgen -W "${actions[*]}" -- "$current")
  elif ((place < ${#arguments[@]})); then
    _marketgen_offer "${arguments[place]%'*'}" "$current"
  elif ((${#arguments[@]})) && [[ ${arguments[-1]} == *'*' ]]; then
    _marketgen_offer "${arguments[-1]%'*'}" "$current"
  fi
}

complete -F _marketgen marketgen
)";

}  // namespace

std::string bash_script(const Completions& all) {
  std::string kinds, tree;
  for (const ValueKind& kind : all.kinds)
    kinds += bash_kind(kind);
  for (const CommandFacts* command : all_commands(all.program))
    tree += bash_command(*command);
  return fmt::format(bash_head, program_version) + fmt::format(bash_offer, kinds) +
         fmt::format(bash_tree, tree) + bash_body;
}

}  // namespace marketgen::app
