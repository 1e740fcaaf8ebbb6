// The program's commands and options as values, read from CLI11's tree: what completion scripts and
// manual pages are made of.
#pragma once
#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace marketgen::app {

// An option, or an argument without a name.
struct OptionFacts {
  std::vector<std::string> names;  // {"-o", "--output"}; empty: an argument
  std::string argument;            // of an argument: "folder"
  std::string value;               // as help shows it (value_kinds.h); empty: takes none
  std::string text;                // what it is for
  std::string fallback;            // its value by itself, when help shows one
  bool required = false;
  bool many = false;  // values may follow one another
};

struct CommandFacts {
  std::vector<std::string> words;  // {"assets", "list"}; empty: the program
  std::string text, footer;
  std::vector<OptionFacts> options, arguments;  // in the order of the help; hidden ones left out
  std::vector<CommandFacts> actions;
};

CommandFacts command_tree(const CLI::App& program);

// The program, its commands and their actions, each before what is below it.
std::vector<const CommandFacts*> all_commands(const CommandFacts& program);

}  // namespace marketgen::app
