// What commands there are, asked of the program itself.
#pragma once
#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "support/run_program.h"

namespace marketgen {

// As apps/marketgen/commands.inc lists them.
inline std::vector<std::string> commands() {
  const std::string list =
      contents_of(std::filesystem::path(MARKETGEN_SOURCE_DIR) / "apps/marketgen/commands.inc");
  const std::regex entry("COMMAND\\(([a-z]+)\\)");
  std::vector<std::string> names;
  for (auto it = std::sregex_iterator(list.begin(), list.end(), entry);
       it != std::sregex_iterator();
       ++it)
    names.push_back((*it)[1]);
  return names;
}

// Every command that does something, with its actions: {"query"}, {"assets", "list"}.
inline std::vector<std::vector<std::string>> whole_commands() {
  std::vector<std::vector<std::string>> all;
  for (const std::string& command : commands()) {
    const std::string help = marketgen_run({command, "--help"}).out;
    const std::size_t actions = help.find("\nSubcommands:\n");
    if (actions == std::string::npos) {
      all.push_back({command});
      continue;
    }
    const std::string list = help.substr(actions);
    const std::regex line("\n  ([a-z]+) ");
    for (auto it = std::sregex_iterator(list.begin(), list.end(), line);
         it != std::sregex_iterator();
         ++it)
      all.push_back({command, (*it)[1]});
  }
  return all;
}

// The options of a help text, each with the names of its choice.
inline std::map<std::string, std::set<std::string>> options_in(const std::string& help) {
  std::map<std::string, std::set<std::string>> options;
  const std::regex entry(R"(\n  (-[^ {\n]+)(?: [A-Z]*:?\{([^}\n]*)\})?)");
  for (auto it = std::sregex_iterator(help.begin(), help.end(), entry);
       it != std::sregex_iterator();
       ++it) {
    std::istringstream names((*it)[1]), choices((*it)[2]);
    std::set<std::string> choice;
    for (std::string word; std::getline(choices, word, ',');)
      choice.insert(word);
    for (std::string name; std::getline(names, name, ',');)
      options[name] = choice;
  }
  return options;
}

inline std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words)
    text += (text.empty() ? "" : " ") + word;
  return text;
}

}  // namespace marketgen
