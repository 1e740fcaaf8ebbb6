// Evaluations that are broken off: nothing that was finished is lost, and nothing is left running.
#include <gtest/gtest.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "small_store.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr int episodes = 6;
constexpr double short_limit_s = 4;

// Baskets of the small store, with little time for each.
fs::path short_tasks(const fs::path& folder) {
  const fs::path drawn = folder / "drawn.jsonl", file = folder / "tasks.jsonl";
  const Ran made = marketgen_run({"episodes",
                                  small_store().string(),
                                  "--count",
                                  std::to_string(episodes),
                                  "--seed",
                                  "2",
                                  "--quiet",
                                  "-o",
                                  drawn.string()});
  EXPECT_EQ(made.status, 0) << made.err;
  std::istringstream lines(contents_of(drawn));
  std::ofstream out(file);
  std::string line;
  std::getline(lines, line);
  out << line << "\n";
  while (std::getline(lines, line)) {
    Json spec = Json::parse(line);
    spec["limit_s"] = short_limit_s;
    out << spec.dump() << "\n";
  }
  return file;
}

std::vector<std::string> eval_command(const fs::path& tasks, const fs::path& folder) {
  return {MARKETGEN_BINARY,
          "eval",
          "--episodes",
          tasks.string(),
          "--policy",
          "random",
          "--jobs",
          "2",
          "--quiet",
          "-o",
          folder.string()};
}

// The lines of results.jsonl without their wall times; a line that was cut off is none.
std::vector<Json> results_in(const fs::path& folder) {
  std::istringstream lines(contents_of(folder / "results.jsonl"));
  std::vector<Json> results;
  for (std::string line; std::getline(lines, line) && !lines.eof();) {
    results.push_back(Json::parse(line));
    results.back().erase("wall_s");
  }
  return results;
}

void wait_for_results(const fs::path& folder, std::size_t count) {
  for (int i = 0; i < 4800 && results_in(folder).size() < count; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
}

// Processes that have `word` in their command line.
int running_with(const std::string& word) {
  int found = 0;
  for (const auto& entry : fs::directory_iterator("/proc"))
    found += contents_of(entry.path() / "cmdline").find(word) != std::string::npos ? 1 : 0;
  return found;
}

TEST(Evaluation, KillNineLosesNothingThatWasFinished) {
  const ScratchFolder scratch;
  const fs::path tasks = short_tasks(scratch.path());
  const fs::path whole = scratch.path() / "whole", broken = scratch.path() / "broken";
  const Ran unbroken = run(eval_command(tasks, whole));
  ASSERT_EQ(unbroken.status, 0) << unbroken.err;
  ASSERT_EQ(results_in(whole).size(), static_cast<std::size_t>(episodes));

  Started killed(eval_command(tasks, broken));
  wait_for_results(broken, 2);
  killed.end_at_once();
  ASSERT_EQ(killed.wait().status, 128 + SIGKILL);
  const std::vector<Json> kept = results_in(broken);
  ASSERT_GE(kept.size(), 2U);
  ASSERT_LT(kept.size(), static_cast<std::size_t>(episodes)) << "it was over before it was killed";
  for (int i = 0; i < 100 && running_with(tasks.string()) > 0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_EQ(running_with(tasks.string()), 0) << "workers outlived the run";
  std::ofstream(broken / "results.jsonl", std::ios::app) << R"({"schema": "market-res)";

  const Ran refused = run(eval_command(tasks, broken));
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("--resume"), std::string::npos) << refused.err;
  std::vector<std::string> resume = eval_command(tasks, broken);
  resume.push_back("--resume");
  const Ran resumed = run(resume);
  ASSERT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_EQ(results_in(broken), results_in(whole));
  Json summary = Json::parse(contents_of(broken / "summary.json"));
  Json expected = Json::parse(contents_of(whole / "summary.json"));
  for (Json* each : {&summary, &expected})
    each->erase("mean_wall_s");
  EXPECT_EQ(summary, expected);
}

TEST(Evaluation, InOneProcessOrInWorkersIsTheSame) {
  const ScratchFolder scratch;
  const fs::path tasks = short_tasks(scratch.path());
  std::vector<std::string> together = eval_command(tasks, scratch.path() / "together");
  together.insert(together.end(), {"--act-limit-s", "0"});
  const Ran in_one = run(together), in_many = run(eval_command(tasks, scratch.path() / "apart"));
  ASSERT_EQ(in_one.status, 0) << in_one.err;
  ASSERT_EQ(in_many.status, 0) << in_many.err;
  EXPECT_EQ(results_in(scratch.path() / "together"), results_in(scratch.path() / "apart"));
}

}  // namespace
}  // namespace marketgen
