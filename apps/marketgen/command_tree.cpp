#include "command_tree.h"

namespace marketgen::app {
namespace {

OptionFacts facts_of(const CLI::Option& option) {
  OptionFacts facts;
  for (const std::string& name : option.get_snames())
    facts.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames())
    facts.names.push_back("--" + name);
  if (facts.names.empty()) facts.argument = option.get_name(true);
  if (option.get_type_size() != 0) facts.value = option.get_type_name();
  facts.text = option.get_description();
  facts.fallback = option.get_default_str();
  facts.required = option.get_required();
  facts.many = option.get_items_expected_max() > 1;
  return facts;
}

CommandFacts facts_of(const CLI::App& command, std::vector<std::string> words) {
  CommandFacts facts;
  facts.words = std::move(words);
  facts.text = command.get_description();
  facts.footer = command.get_footer();
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group().empty()) continue;  // hidden
    (option->nonpositional() ? facts.options : facts.arguments).push_back(facts_of(*option));
  }
  for (const CLI::App* action : command.get_subcommands({})) {
    std::vector<std::string> below = facts.words;
    below.push_back(action->get_name());
    facts.actions.push_back(facts_of(*action, std::move(below)));
  }
  return facts;
}

}  // namespace

CommandFacts command_tree(const CLI::App& program) {
  return facts_of(program, {});
}

std::vector<const CommandFacts*> all_commands(const CommandFacts& program) {
  std::vector<const CommandFacts*> all{&program};
  for (const CommandFacts& action : program.actions)
    for (const CommandFacts* below : all_commands(action))
      all.push_back(below);
  return all;
}

}  // namespace marketgen::app
