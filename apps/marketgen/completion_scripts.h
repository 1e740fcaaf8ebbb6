// Scripts with which a shell completes the program's commands, options and values.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "command_tree.h"
#include "value_kinds.h"

namespace marketgen::app {

enum class Shell { bash, fish, zsh };
constexpr std::array<std::string_view, 3> names_of(Shell) {
  return {"bash", "fish", "zsh"};
}

struct Completions {
  CommandFacts program;
  std::vector<ValueKind> kinds;
};

// The kind of a value as help shows it; null for a choice ("{csv,json}").
const ValueKind* kind_of(const Completions& all, const std::string& value);

// Each is one text that the shell reads; it calls no program when it completes. What is not known
// without a store (its cameras, zones, items) is not completed.
std::string bash_script(const Completions& all);
std::string fish_script(const Completions& all);
std::string zsh_script(const Completions& all);

}  // namespace marketgen::app
