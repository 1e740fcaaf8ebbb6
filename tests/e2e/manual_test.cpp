// The manual pages that `marketgen manual` writes: one of every command, with all that its help
// has, and nothing in them that groff or mandoc warns of.
#include <gtest/gtest.h>

#include <set>

#include "support/command_list.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

class Manual : public testing::Test {
 protected:
  void SetUp() override {
    const Ran ran = marketgen_run({"manual", "-o", pages_.path().string()});
    ASSERT_EQ(ran.status, 0) << ran.err;
  }
  fs::path page(const std::string& command) const {
    return pages_.path() / ("marketgen" + (command.empty() ? "" : "-" + command) + ".1");
  }
  // As it is read: without the fonts.
  std::string read(const std::string& command) const {
    const Ran ran = run({"mandoc", "-T", "ascii", page(command).string()});
    return std::regex_replace(ran.out, std::regex(".\b"), "");
  }
  static bool missing(const std::string& program) {
    return run({program, "--version"}).status == 127;
  }

  ScratchFolder pages_;
};

TEST_F(Manual, EveryCommandHasAPage) {
  Names expected{"marketgen.1"}, found;
  for (const std::string& command : commands())
    expected.insert("marketgen-" + command + ".1");
  for (const auto& entry : fs::directory_iterator(pages_.path()))
    found.insert(entry.path().filename().string());
  EXPECT_EQ(found, expected);
}

TEST_F(Manual, GroffHasNothingToWarnOf) {
  if (missing("groff")) GTEST_SKIP() << "there is no groff here: tools/setup test installs it";
  for (const auto& entry : fs::directory_iterator(pages_.path())) {
    const Ran ran = run({"groff", "-man", "-ww", "-z", "-K", "utf8", "-T", "utf8", entry.path()});
    EXPECT_EQ(ran.status, 0) << entry.path();
    EXPECT_EQ(ran.err, "") << entry.path();
  }
}

TEST_F(Manual, MandocHasNothingToWarnOf) {
  if (missing("mandoc")) GTEST_SKIP() << "there is no mandoc here: tools/setup test installs it";
  // They have no date, so that the same sources make the same pages.
  const std::regex dateless("[^\n]*missing date[^\n]*\n");
  for (const auto& entry : fs::directory_iterator(pages_.path())) {
    const Ran ran = run({"mandoc", "-T", "lint", "-W", "warning", entry.path()});
    EXPECT_EQ(std::regex_replace(ran.out, dateless, ""), "") << entry.path();
    EXPECT_EQ(ran.err, "");
  }
}

TEST_F(Manual, EveryOptionOfEveryCommand) {
  if (missing("mandoc")) GTEST_SKIP() << "there is no mandoc here: tools/setup test installs it";
  for (const std::vector<std::string>& command : whole_commands()) {
    std::vector<std::string> help = command;
    help.push_back("--help");
    const std::string text = read(command[0]);
    const auto options = options_in(marketgen_run(help).out);
    ASSERT_GE(options.size(), 2U);
    for (const auto& [name, choice] : options)
      EXPECT_NE(text.find(name), std::string::npos) << joined(command) << " " << name;
    EXPECT_NE(text.find("marketgen " + joined(command)), std::string::npos) << joined(command);
    EXPECT_NE(text.find("EXAMPLES"), std::string::npos) << joined(command);
  }
}

// The first cells of the rows of a table in docs/commands.md, with several names in one of them.
Names first_cells(const std::string& docs, const std::string& heading) {
  Names cells;
  const std::size_t table = docs.find("\n| " + heading + " |");
  std::istringstream lines(docs.substr(docs.find("|---", table)));
  std::string line;
  std::getline(lines, line);
  const std::regex name("[A-Z0-9_]+");
  while (std::getline(lines, line) && line.starts_with("| ")) {
    const std::string cell = line.substr(2, line.find(" |", 2) - 2);
    for (auto it = std::sregex_iterator(cell.begin(), cell.end(), name);
         it != std::sregex_iterator();
         ++it)
      cells.insert(it->str());
  }
  return cells;
}

// The entries of a section of a page.
Names entries(const std::string& page, const std::string& section) {
  const std::size_t begin = page.find(".SH " + section + "\n");
  if (begin == std::string::npos) return {};
  const std::string text = page.substr(begin, page.find("\n.SH ", begin + 1) - begin);
  Names names;
  const std::regex tag(R"(\n\.TP\n\\f[BI](\S+)\\fR\n)");
  for (auto it = std::sregex_iterator(text.begin(), text.end(), tag); it != std::sregex_iterator();
       ++it)
    names.insert((*it)[1]);
  return names;
}

TEST_F(Manual, StatusesAndVariablesAreThoseOfTheDocs) {
  const std::string docs = contents_of(fs::path(MARKETGEN_SOURCE_DIR) / "docs/commands.md");
  const std::string program = contents_of(page(""));
  const Names statuses = first_cells(docs, "exit status"),
              variables = first_cells(docs, "environment");
  ASSERT_GE(statuses.size(), 5U);
  ASSERT_GE(variables.size(), 5U);
  EXPECT_EQ(entries(program, "EXIT STATUS"), statuses);
  EXPECT_EQ(entries(program, "ENVIRONMENT"), variables);
  for (const std::string& command : commands())
    EXPECT_EQ(entries(contents_of(page(command)), "EXIT STATUS"), statuses) << command;
}

}  // namespace
}  // namespace marketgen
