// `marketgen episodes` where a store does not have every task that is asked for.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "support/run_program.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr int asked = 20;

// In stores that stay as they are, tasks whose shortest way is `way` times the store's longer side:
// nothing is planned, so that only the way decides.
Ran drawn_with_way(double way, bool skip_impossible, const fs::path& folder) {
  const fs::path dials = folder / "far.json";
  std::ofstream(dials) << Json{{"schema", "market-difficulty/1"},
                               {"name", "far"},
                               {"goals", {{"min", 2}, {"max", 4}}},
                               {"others", {{"min", 4}, {"max", 8}}},
                               {"way", way}};
  std::vector<std::string> command{"episodes",
                                   "v1/aisle",
                                   "--track",
                                   "aisle",
                                   "--split",
                                   "all",
                                   "--frozen",
                                   "--difficulty",
                                   dials.string(),
                                   "--seed",
                                   "3",
                                   "--count",
                                   std::to_string(asked),
                                   "-o",
                                   (folder / "far.jsonl").string()};
  if (skip_impossible) command.push_back("--skip-impossible");
  return marketgen_run(command);
}

TEST(DrawingTasks, ThoseThatAStoreHasNotAreLeftOut) {
  const ScratchFolder scratch;
  const Ran ended = drawn_with_way(1.5, false, scratch.path());
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.err.find("error[episode.impossible]"), std::string::npos) << ended.err;
  EXPECT_FALSE(fs::exists(scratch.path() / "far.jsonl"));

  const Ran ran = drawn_with_way(1.5, true, scratch.path());
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("left out: aisle/gripper/own-"), std::string::npos) << ran.out;
  std::ifstream lines(scratch.path() / "far.jsonl");
  std::string line;
  ASSERT_TRUE(std::getline(lines, line));
  const Json header = Json::parse(line);
  std::set<std::string> ids;
  while (std::getline(lines, line))
    ids.insert(Json::parse(line)["id"]);
  EXPECT_EQ(static_cast<int>(ids.size()), header["episodes"]);
  EXPECT_GT(ids.size(), 0U);
  EXPECT_LT(ids.size(), static_cast<std::size_t>(asked));
  EXPECT_EQ(header["stores"].size(), 10U) << "a store without any stays named";
}

TEST(DrawingTasks, NoneAtAllIsAnError) {
  const ScratchFolder scratch;
  const Ran ran = drawn_with_way(5, true, scratch.path());
  EXPECT_EQ(ran.status, 2);
  EXPECT_NE(ran.err.find("error[episode.impossible]"), std::string::npos) << ran.err;
  EXPECT_FALSE(fs::exists(scratch.path() / "far.jsonl"));
}

}  // namespace
}  // namespace marketgen
