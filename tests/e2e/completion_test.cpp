// Completion in the shells themselves: each reads the script that the program prints for it, and is
// asked what it offers. What it should offer is read from the help of every command.
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>

#include "small_store.h"
#include "support/command_list.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;
using Offered = std::set<std::string>;

class Completion : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (run({GetParam(), "-c", "true"}).status == 127)
      GTEST_SKIP() << "there is no " << GetParam() << " here: tools/setup test installs it";
    const Ran ran = marketgen_run({"completion", GetParam()});
    ASSERT_EQ(ran.status, 0) << ran.err;
    std::ofstream(script_.path() / "script") << ran.out;
  }

  // For the last of the words, typed behind "marketgen" in a folder. A blank that a shell would put
  // after a backslash is a blank, and a folder has no slash at its end.
  Offered offered(const Words& words) const {
    const fs::path driver =
        fs::path(MARKETGEN_SOURCE_DIR) / "tests/support/shells" / ("complete." + GetParam());
    Words command{driver.string(), (script_.path() / "script").string(), "marketgen"};
    command.insert(command.end(), words.begin(), words.end());
    const Ran ran = run(command, folder_.path());
    EXPECT_EQ(ran.err, "") << joined(words);
    std::istringstream lines(std::regex_replace(ran.out, std::regex(R"(\\|/(?=\n))"), ""));
    Offered all;
    for (std::string line; std::getline(lines, line);)
      all.insert(line);
    return all;
  }

  static Words with(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  ScratchFolder script_, folder_;
};

TEST_P(Completion, EveryCommandAndAction) {
  const Words names = commands();
  EXPECT_EQ(offered({""}), Offered(names.begin(), names.end()));
  std::map<std::string, Offered> actions;
  for (const Words& command : whole_commands())
    if (command.size() > 1) actions[command[0]].insert(command[1]);
  ASSERT_GE(actions.size(), 2U);
  for (const auto& [command, of_it] : actions)
    EXPECT_EQ(offered({command, ""}), of_it) << command;
  EXPECT_EQ(offered({"exp"}), Offered{"export"});
}

TEST_P(Completion, EveryOptionOfEveryCommand) {
  for (const Words& command : whole_commands()) {
    Offered expected;
    for (const auto& [name, choice] : options_in(marketgen_run(with(command, {"--help"})).out))
      expected.insert(name);
    ASSERT_GE(expected.size(), 2U) << joined(command);
    EXPECT_EQ(offered(with(command, {"-"})), expected) << joined(command);
  }
}

TEST_P(Completion, EveryChoiceOfEveryOption) {
  int choices = 0;
  for (const Words& command : whole_commands()) {
    for (const auto& [name, choice] : options_in(marketgen_run(with(command, {"--help"})).out)) {
      if (choice.empty()) continue;
      ++choices;
      EXPECT_EQ(offered(with(command, {name, ""})), choice) << joined(command) << " " << name;
    }
  }
  EXPECT_GE(choices, 15);
  EXPECT_TRUE(offered({"query", "shop", ""}).contains("planogram"));
  const Offered behind_equals = offered({"render", "shop", "--quality=be"});
  EXPECT_EQ(behind_equals.size(), 1U);
  EXPECT_TRUE(behind_equals.begin()->ends_with("best"));
}

TEST_P(Completion, NamesOfRowsAndSets) {
  const auto offers = [this](const Words& words, const std::string& name) {
    const Offered all = offered(words);
    EXPECT_TRUE(all.contains(name)) << joined(words) << " offers " << all.size();
  };
  offers({"eval", "--episodes", "v1/"}, "v1/checkout");
  offers({"generate", "--style", "vi"}, "victorian");
  offers({"generate", "--profile", ""}, "supermarket-eu");
  offers({"assets", "list", "--zone", ""}, "dairy");
  offers({"render", "shop", "--robot", "realman"}, "realman-rm75@");
  offers({"eval", "--realism", "h"}, "hard");
  offers({"generate", "--planner", "o"}, "offline");
  offers({"grasps", "--tool", "p"}, "panda-hand");
  offers({"bench", ""}, "generate");
  // Those that every store has.
  const std::string cameras =
      marketgen_run({"render", small_store().string(), "--list-cameras"}).out;
  for (const std::string& camera : offered({"render", "shop", "--camera", ""}))
    EXPECT_NE(cameras.find(camera), std::string::npos) << camera;
}

TEST_P(Completion, FilesAndFolders) {
  fs::create_directory(folder_.path() / "a shop");
  std::ofstream(folder_.path() / "plan.json") << "{}";
  EXPECT_EQ(offered({"generate", "--plan", ""}), (Offered{"a shop", "plan.json"}));
  EXPECT_EQ(offered({"export", "shop", "-o", "pl"}), Offered{"plan.json"});
  EXPECT_EQ(offered({"merge", "one", ""}), Offered{"a shop"});  // and one after another
  EXPECT_EQ(offered({"render", ""}), Offered{"a shop"});
  EXPECT_EQ(offered({"render", "--seed", ""}), Offered{});
}

INSTANTIATE_TEST_SUITE_P(Shells,
                         Completion,
                         testing::Values("bash", "fish", "zsh"),
                         [](const auto& shell) { return shell.param; });

TEST(CompletionCommand, UnknownShellIsToldThose) {
  const Ran ran = marketgen_run({"completion", "tcsh"});
  EXPECT_EQ(ran.status, 2);
  EXPECT_EQ(ran.out, "");
  EXPECT_NE(ran.err.find("error[usage.bad_flag]"), std::string::npos) << ran.err;
  EXPECT_NE(ran.err.find("bash, fish, zsh"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace marketgen
