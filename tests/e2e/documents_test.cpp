// What the documents promise: the README's commands and the examples work as written.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "small_store.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;

const fs::path& root() {
  static const fs::path folder = MARKETGEN_SOURCE_DIR;
  return folder;
}

TEST(Readme, ItsCommandsWorkInTheirOrder) {
  const std::string program = "build/release/marketgen";
  std::istringstream readme(contents_of(root() / "README.md"));
  const ScratchFolder scratch;
  int commands = 0;
  for (std::string line; std::getline(readme, line);) {
    if (!line.starts_with(program + " ")) continue;
    const std::string command = MARKETGEN_BINARY + line.substr(program.size());
    const Ran ran = run({"sh", "-c", command}, scratch.path());
    EXPECT_EQ(ran.status, 0) << line << "\n" << ran.err;
    ++commands;
  }
  EXPECT_GE(commands, 3);
  EXPECT_TRUE(
      fs::exists(scratch.path() / "shop/previews/entrance.png"));  // the first one draws previews
}

TEST(Examples, PlansAreValid) {
  int plans = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(root() / "examples")) {
    if (entry.path().extension() != ".json") continue;
    const ScratchFolder scratch;
    const Ran ran = marketgen_run(
        {"generate", "--plan", entry.path().string(), "--strict", "--no-previews", "-o", "shop"},
        scratch.path());
    EXPECT_EQ(ran.status, 0) << entry.path() << ": " << ran.err;
    ++plans;
  }
  EXPECT_GT(plans, 0);
}

}  // namespace
}  // namespace marketgen
