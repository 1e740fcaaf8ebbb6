#include "manual_pages.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>
#include <map>
#include <sstream>

#include "base/build_info.h"

namespace marketgen::app {
namespace {

// A text among roff: nothing in it is a request or an escape, and signs are those of ASCII.
std::string roff(const std::string& text) {
  static const std::map<char, std::string> escapes{
      {'\\', "\\e"}, {'-', "\\-"}, {'\'', "\\(aq"}, {'`', "\\(ga"}, {'^', "\\(ha"}, {'~', "\\(ti"}};
  std::string out = text.starts_with('.') ? "\\&" : "";
  for (const char c : text) {
    const auto escape = escapes.find(c);
    out += escape == escapes.end() ? std::string(1, c) : escape->second;
    if (c == '\n') out += "\\&";
  }
  return out;
}

std::string bold(const std::string& text) {
  return "\\fB" + roff(text) + "\\fR";
}

std::string italic(const std::string& text) {
  return "\\fI" + roff(text) + "\\fR";
}

std::string upper(std::string text) {
  for (char& c : text)
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

// "marketgen-export"; the program itself without words.
std::string page_name(const CommandFacts& command) {
  return command.words.empty() ? "marketgen" : "marketgen-" + command.words.front();
}

std::string entry(const std::string& tag, const std::string& text) {
  return fmt::format(".TP\n{}\n{}\n", tag, text);
}

std::string synopsis(const CommandFacts& command) {
  std::string text = bold(fmt::format("marketgen {}", fmt::join(command.words, " ")));
  if (command.words.empty()) return bold("marketgen") + " " + italic("command") + " ...";
  text += " [" + italic("option") + "]...";
  for (const OptionFacts& option : command.options)
    if (option.required)
      text += fmt::format(" {} {}", bold(option.names.back()), italic(option.value));
  for (const OptionFacts& argument : command.arguments) {
    const std::string name = italic(argument.argument) + (argument.many ? "..." : "");
    text += argument.required ? " " + name : " [" + name + "]";
  }
  return text;
}

std::string option_entry(const OptionFacts& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.names)
    names.push_back(bold(name));
  std::string tag =
      option.names.empty() ? italic(option.argument) : fmt::format("{}", fmt::join(names, ", "));
  if (!option.value.empty() && !option.names.empty()) tag += " " + italic(option.value);
  std::string text = roff(option.text);
  if (option.names.empty() && option.value.find('{') != std::string::npos)
    text += ": " + roff(option.value);
  if (!option.value.empty() && !option.fallback.empty())
    text += "; " + roff(option.fallback) + " by itself";
  if (option.required && !option.names.empty()) text += "; must be given";
  return entry(tag, text);
}

std::string options_text(const CommandFacts& command) {
  std::string text;
  for (const std::vector<OptionFacts>& group : {command.arguments, command.options})
    for (const OptionFacts& option : group)
      text += option_entry(option);
  return text;
}

// What stands below a command's help: "Formats:" with lines of its own, "Example:  marketgen …".
std::string footer_sections(const std::string& footer) {
  std::string text, line;
  bool open = false;
  std::istringstream lines(footer);
  while (std::getline(lines, line)) {
    const std::size_t colon = line.find(':');
    if (!line.empty() && line[0] != ' ' && colon != std::string::npos) {
      if (open) text += ".EE\n";
      const std::string heading = line.substr(0, colon);
      text += fmt::format(".SH {}\n.EX\n", heading == "Example" ? "EXAMPLES" : upper(heading));
      open = true;
      line.erase(0, colon + 1);
    }
    const std::size_t start = line.find_first_not_of(' ');
    if (start != std::string::npos) text += roff(line.substr(start)) + "\n";
  }
  return text + (open ? ".EE\n" : "");
}

std::string lists(bool whole_program) {
  std::string statuses = ".SH EXIT STATUS\n", variables = ".SH ENVIRONMENT\n",
              files = ".SH FILES\n";
#define EXIT_STATUS(number, text) statuses += entry(bold(number), roff(text));
#define ENVIRONMENT(name, text) variables += entry(bold(name), roff(text));
#define FILES(name, text) files += entry(italic(name), roff(text));
#include "manual_lists.inc"
#undef EXIT_STATUS
#undef ENVIRONMENT
#undef FILES
  return whole_program ? statuses + variables + files : statuses;
}

std::string page_head(const CommandFacts& command) {
  std::string what = command.text;
  what[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(what[0])));
  if (what.ends_with('.')) what.pop_back();
  return fmt::format(
      ".\\\" Made by `marketgen manual` from the program's own help.\n"
      ".TH {} 1 \"\" \"MarketGen {}\" \"MarketGen manual\"\n.SH NAME\n{} \\- {}\n.SH "
      "SYNOPSIS\n{}\n",
      roff(upper(page_name(command))),
      program_version,
      roff(page_name(command)),
      roff(what),
      synopsis(command));
}

std::string command_page(const CommandFacts& command) {
  std::string text = page_head(command);
  if (const std::string options = options_text(command); !options.empty())
    text += ".SH OPTIONS\n" + options;
  if (!command.actions.empty()) text += ".SH ACTIONS\n";
  for (const CommandFacts& action : command.actions)
    text += fmt::format(".SS {}\n{}\n.PP\n{}.\n{}",
                        roff(action.words.back()),
                        synopsis(action),
                        roff(action.text),
                        options_text(action));
  return text + footer_sections(command.footer) + lists(false) +
         ".SH SEE ALSO\n.BR marketgen (1),\nwhich has environment variables and files.\n";
}

std::string program_page(const CommandFacts& program) {
  std::string text =
      page_head(program) + ".SH DESCRIPTION\n" + roff(program.text) +
      "\nIt runs on a CPU, offline; the same words and seed give the same store, byte "
      "for byte.\n.SH OPTIONS\n" +
      options_text(program) + ".SH COMMANDS\n";
  for (const CommandFacts& command : program.actions)
    text += fmt::format(".TP\n.BR {} (1)\n{}\n", roff(page_name(command)), roff(command.text));
  return text + footer_sections(program.footer) + lists(true);
}

}  // namespace

std::vector<ManualPage> manual_pages(const CommandFacts& program) {
  std::vector<ManualPage> pages{{page_name(program) + ".1", program_page(program)}};
  for (const CommandFacts& command : program.actions)
    pages.push_back({page_name(command) + ".1", command_page(command)});
  return pages;
}

}  // namespace marketgen::app
