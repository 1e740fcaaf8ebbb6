// Evaluations that are broken off: nothing that was finished is lost, and nothing is left running.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "small_store.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr int episode_count = 6;
constexpr double short_limit_s = 4;

// Baskets of the small store, with little time for each; drawn once.
const fs::path& drawn_tasks() {
  static const ScratchFolder scratch;
  static const fs::path drawn = scratch.path() / "drawn.jsonl";
  if (fs::exists(drawn)) return drawn;
  const Ran made = marketgen_run({"episodes",
                                  small_store().string(),
                                  "--count",
                                  std::to_string(episode_count),
                                  "--seed",
                                  "2",
                                  "--quiet",
                                  "-o",
                                  drawn.string()});
  EXPECT_EQ(made.status, 0) << made.err;
  return drawn;
}

fs::path short_tasks(const fs::path& folder) {
  const fs::path file = folder / "tasks.jsonl";
  std::istringstream lines(contents_of(drawn_tasks()));
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

// A line that was cut off is none.
std::vector<Json> rows_in(const fs::path& file) {
  std::istringstream lines(contents_of(file));
  std::vector<Json> rows;
  for (std::string line; std::getline(lines, line) && !lines.eof();)
    rows.push_back(Json::parse(line));
  return rows;
}

// The lines of results.jsonl without their wall times.
std::vector<Json> results_in(const fs::path& folder) {
  std::vector<Json> results = rows_in(folder / "results.jsonl");
  for (Json& result : results)
    result.erase("wall_s");
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
  ASSERT_EQ(results_in(whole).size(), static_cast<std::size_t>(episode_count));

  Started killed(eval_command(tasks, broken));
  wait_for_results(broken, 2);
  killed.end_at_once();
  ASSERT_EQ(killed.wait().status, 128 + SIGKILL);
  const std::vector<Json> kept = results_in(broken);
  ASSERT_GE(kept.size(), 2U);
  ASSERT_LT(kept.size(), static_cast<std::size_t>(episode_count))
      << "it was over before it was killed";
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

// ---- Of three baskets, a second for each: what is asked of is not how well they are done. ----

class ShortEvaluation : public testing::Test {
 protected:
  ShortEvaluation() {
    std::istringstream lines(contents_of(drawn_tasks()));
    std::string line;
    std::getline(lines, line);
    header_ = Json::parse(line);
    while (specs_.size() < 3 && std::getline(lines, line)) {
      specs_.push_back(Json::parse(line));
      specs_.back()["limit_s"] = 1;
    }
  }

  fs::path written(const std::string& name = "tasks.jsonl") {
    header_["episodes"] = specs_.size();
    std::ofstream out(scratch_.path() / name);
    out << header_.dump() << "\n";
    for (const Json& spec : specs_)
      out << spec.dump() << "\n";
    return scratch_.path() / name;
  }

  // Its robot would begin outside the store: nothing that the file alone tells.
  static void put_outside(Json& spec) {
    spec["track"] = "aisle";
    spec["robot"] = "realman-rm75";
    spec.erase("items");
    spec.erase("cameras");
    spec.erase("lane");
    spec.erase("certificate");  // of the counter
    spec["start"] = {{"x_m", -900}, {"y_m", -900}, {"heading_deg", 0}};
  }

  Ran evaluated(const fs::path& tasks, const std::string& folder, bool resume = false) {
    std::vector<std::string> command = eval_command(tasks, scratch_.path() / folder);
    if (resume) command.push_back("--resume");
    return run(command);
  }

  std::vector<Json> results(const std::string& folder) {
    return results_in(scratch_.path() / folder);
  }

  ScratchFolder scratch_;
  Json header_;
  std::vector<Json> specs_;
};

// A pipe can be read but once, by one process.
TEST_F(ShortEvaluation, EpisodesComeThroughAPipe) {
  const fs::path tasks = written();
  ASSERT_EQ(evaluated(tasks, "whole").status, 0);
  for (const std::string from : {"/dev/stdin", "-"}) {
    std::string shell = "cat '" + tasks.string() + "' | timeout 300";
    for (const std::string& word : eval_command(from, scratch_.path() / ("of" + from)))
      shell += " '" + word + "'";
    const Ran piped = run({"/bin/sh", "-c", shell});
    ASSERT_EQ(piped.status, 0) << piped.err;
    EXPECT_EQ(results("of" + from), results("whole")) << from;
  }
}

// The other baskets are measured.
TEST_F(ShortEvaluation, ABasketThatCannotBeLookedAtIsARow) {
  put_outside(specs_[0]);
  const Ran ran = run({MARKETGEN_BINARY,
                       "eval",
                       "--perception",
                       "--episodes",
                       written().string(),
                       "-o",
                       (scratch_.path() / "run").string()});
  EXPECT_EQ(ran.status, 2) << ran.err;
  EXPECT_NE(ran.err.find("1 of 3 episodes could not be run"), std::string::npos) << ran.err;
  const std::vector<Json> rows = rows_in(scratch_.path() / "run/perception.jsonl");
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0]["episode"], specs_[0]["id"]);
  EXPECT_NE(rows[0]["error"], "");
  EXPECT_NE(rows[0]["detail"], "");
  for (const std::size_t sound : {1U, 2U}) {
    EXPECT_EQ(rows[sound]["error"], "");
    EXPECT_EQ(rows[sound]["targets"].size(), specs_[sound]["goals"].size());
  }
  const Json summary = Json::parse(ran.out);
  EXPECT_EQ(summary["baskets"], 2);
  EXPECT_EQ(summary["errors"][0]["error"], rows[0]["error"]);
}

// It is a result of its own kind, and no share counts it; once it is mended, only it is run.
TEST_F(ShortEvaluation, AnEpisodeThatCannotBeRunIsAResult) {
  const Json sound = specs_[1];
  put_outside(specs_[1]);
  const Ran ran = evaluated(written(), "run");
  EXPECT_EQ(ran.status, 2) << ran.err;
  EXPECT_NE(ran.err.find("1 of 3 episodes could not be run"), std::string::npos) << ran.err;
  const std::vector<Json> rows = results("run");
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[1]["episode"], specs_[1]["id"]);
  EXPECT_EQ(rows[1]["failure"], "NotRun");
  EXPECT_NE(rows[1]["error"], "");
  const Json summary = Json::parse(contents_of(scratch_.path() / "run" / "summary.json"));
  EXPECT_EQ(summary["episodes"], 2);
  EXPECT_EQ(summary["strict"]["of"], 2);
  EXPECT_EQ(summary["errors"][0]["error"], rows[1]["error"]);

  specs_[1] = sound;
  const Ran mended = evaluated(written(), "run", true);
  EXPECT_EQ(mended.status, 0) << mended.err;
  EXPECT_EQ(results("run")[0], rows[0]);
  EXPECT_EQ(results("run")[1]["error"], "");
}

TEST_F(ShortEvaluation, FaultsOfAFileAreSaidBeforeAnythingIsRun) {
  specs_[2]["id"] = specs_[0]["id"];
  const Ran twice = evaluated(written(), "twice");
  EXPECT_EQ(twice.status, 2);
  EXPECT_NE(twice.err.find("error[episode.duplicate_id] tasks.jsonl:4/id"), std::string::npos)
      << twice.err;
  EXPECT_FALSE(fs::exists(scratch_.path() / "twice"));
  specs_[2]["id"] = "another";
  specs_[2]["robot"] = "realman-rm75";
  const Ran robot = evaluated(written(), "robot");
  EXPECT_NE(robot.err.find("error[robot.unknown] tasks.jsonl:4/robot"), std::string::npos)
      << robot.err;
}

TEST_F(ShortEvaluation, TwoRunsDoNotShareAFolder) {
  for (Json& spec : specs_)
    spec["limit_s"] = 20;
  const fs::path tasks = written();
  Started first(eval_command(tasks, scratch_.path() / "run"));
  for (int i = 0; i < 1200 && !fs::exists(scratch_.path() / "run/.lock"); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  const Ran second = evaluated(tasks, "run");
  EXPECT_EQ(second.status, 3);
  EXPECT_NE(second.err.find("error[io.in_use]"), std::string::npos) << second.err;
  first.interrupt();
  const Ran ended = first.wait();
  EXPECT_EQ(ended.status, 130);
  EXPECT_NE(ended.err.find("interrupted; "), std::string::npos) << ended.err;
  EXPECT_EQ(ended.err.find("nothing was left behind"), std::string::npos) << ended.err;
  EXPECT_FALSE(fs::exists(scratch_.path() / "run/.lock"));
  EXPECT_TRUE(fs::exists(scratch_.path() / "run/summary.json"));
}

// In parts, on as many machines, and joined: the results of a run that was not cut. Ranked beside a
// floor, printed as a table and as JSON, and shown as pages that load nothing.
TEST_F(ShortEvaluation, ShardsAreJoinedAndRanked) {
  const fs::path tasks = written(), folder = scratch_.path();
  ASSERT_EQ(evaluated(tasks, "whole").status, 0);
  std::vector<std::string> merge{MARKETGEN_BINARY, "merge"};
  for (const std::string part : {"2", "1"}) {
    std::vector<std::string> command = eval_command(tasks, folder / part);
    command.insert(command.end(), {"--shard", part + "/2"});
    const Ran ran = run(command);
    ASSERT_EQ(ran.status, 0) << ran.err;
    merge.push_back((folder / part).string());
  }
  EXPECT_EQ(results("1").size(), 2U);
  const Ran part = marketgen_run({"leaderboard", (folder / "1").string()});
  EXPECT_EQ(part.status, 2);
  EXPECT_NE(part.err.find("of 3 episodes 1 have no result"), std::string::npos) << part.err;
  merge.insert(merge.end(), {"-o", (folder / "joined").string()});
  const Ran merged = run(merge);
  ASSERT_EQ(merged.status, 0) << merged.err;
  EXPECT_EQ(results("joined"), results("whole"));
  EXPECT_EQ(contents_of(folder / "joined/run.json"), contents_of(folder / "whole/run.json"));

  std::vector<std::string> stop = eval_command(tasks, folder / "stop");
  std::ranges::replace(stop, "random", "stop");
  std::erase(stop, "--quiet");
  stop.insert(stop.end(), {"--against", (folder / "joined").string()});
  const Ran beside = run(stop);
  ASSERT_EQ(beside.status, 0) << beside.err;
  EXPECT_NE(beside.out.find("random (floor)"), std::string::npos) << beside.out;
  const fs::path page = folder / "board.html";
  const Ran board = marketgen_run({"leaderboard",
                                   (folder / "joined").string(),
                                   (folder / "stop").string(),
                                   "--json",
                                   "--html",
                                   page.string()});
  ASSERT_EQ(board.status, 0) << board.err;
  const Json ranked = Json::parse(board.out);
  EXPECT_EQ(ranked["tracks"][0]["entries"].size(), 2U);
  EXPECT_EQ(ranked["tracks"][0]["entries"][0]["episodes"], 3);
  const fs::path report = folder / "report.html";
  const Ran shown =
      marketgen_run({"report", (folder / "joined").string(), "-o", report.string(), "--quiet"});
  ASSERT_EQ(shown.status, 0) << shown.err;
  for (const fs::path& file : {page, report}) {
    const std::string html = contents_of(file);
    EXPECT_NE(html.find("random"), std::string::npos);
    EXPECT_EQ(html.find("http"), std::string::npos) << "it loads something";
    EXPECT_EQ(html.find("<script"), std::string::npos);
  }
}

// Made once, by running episodes again; of other episodes, or of none, none is.
TEST_F(ShortEvaluation, AReportHasFilmStrips) {
  const fs::path tasks = written(), folder = scratch_.path();
  ASSERT_EQ(evaluated(tasks, "run").status, 0);
  const std::string results = (folder / "run").string(), page = (folder / "page.html").string();
  const auto report = [&](const std::string& file) {
    return marketgen_run(
        {"report", results, "--strips", "2", "--episodes", file, "-o", page, "--quiet"});
  };
  const Ran shown = report(tasks.string());
  ASSERT_EQ(shown.status, 0) << shown.err;
  const std::string html = contents_of(page);
  std::size_t pictures = 0;
  for (std::size_t at = html.find("data:image/png"); at != std::string::npos;
       at = html.find("data:image/png", at + 1))
    ++pictures;
  EXPECT_EQ(pictures, 2U) << "of three with one failure code";
  const fs::path strip = folder / "run" / "strips" / (specs_[0]["id"].get<std::string>() + ".png");
  const std::string first = contents_of(strip);
  EXPECT_GT(first.size(), 10'000U);
  const auto written_at = fs::last_write_time(strip);
  ASSERT_EQ(report(tasks.string()).status, 0);
  EXPECT_EQ(fs::last_write_time(strip), written_at);
  specs_.pop_back();
  const Ran other = report(written("two.jsonl").string());
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.err.find("error[results.not_comparable]"), std::string::npos) << other.err;
}

// Told before an episode is run.
TEST_F(ShortEvaluation, RunsThatCannotBeComparedWithAreSaidFirst) {
  const fs::path tasks = written();
  ASSERT_EQ(evaluated(tasks, "three").status, 0);
  specs_.pop_back();
  std::vector<std::string> command = eval_command(written("two.jsonl"), scratch_.path() / "two");
  command.insert(command.end(), {"--against", (scratch_.path() / "three").string()});
  const Ran refused = run(command);
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("error[results.not_comparable]"), std::string::npos) << refused.err;
  EXPECT_FALSE(fs::exists(scratch_.path() / "two"));
}

// Before an episode of minutes is run.
TEST_F(ShortEvaluation, ReplayLooksAtTheResultsFirst) {
  const fs::path tasks = written();
  ASSERT_EQ(evaluated(tasks, "run").status, 0);
  const auto replayed = [&](const fs::path& results, const std::string& policy) {
    return marketgen_run({"replay",
                          "--episodes",
                          tasks.string(),
                          "--episode",
                          "1",
                          "--policy",
                          policy,
                          "--results",
                          results.string()});
  };
  const fs::path results = scratch_.path() / "run" / "results.jsonl";
  const Ran same = replayed(results, "random");
  EXPECT_EQ(same.status, 0) << same.err;
  EXPECT_NE(same.out.find("the same"), std::string::npos) << same.out;
  const Ran missing = replayed(scratch_.path() / "none.jsonl", "random");
  EXPECT_EQ(missing.status, 2);
  EXPECT_NE(missing.err.find("input.not_found"), std::string::npos) << missing.err;
  EXPECT_EQ(missing.out, "");
  const Ran other = replayed(results, "oracle");
  EXPECT_NE(other.err.find("was run by \"random\""), std::string::npos) << other.err;
  EXPECT_EQ(other.out, "");
  specs_[1]["limit_s"] = 2;
  written();
  const Ran edited = replayed(results, "random");
  EXPECT_NE(edited.err.find("has changed since"), std::string::npos) << edited.err;
}

// The whole set may be moved; the scene that a lane needs is opened from it.
TEST(FrozenEvaluation, RunsWhereTheSetLies) {
  const ScratchFolder scratch;
  const fs::path drawn = scratch.path() / "drawn", moved = scratch.path() / "moved";
  const auto draw = [&](const std::string& output) {
    return marketgen_run({"episodes",
                          small_store().string(),
                          "--count",
                          "1",
                          "--seed",
                          "2",
                          "--quiet",
                          "--frozen",
                          "-o",
                          output});
  };
  const Ran made = draw((drawn / "tasks.jsonl.gz").string());
  ASSERT_EQ(made.status, 0) << made.err;
  fs::rename(drawn, moved);
  const Ran ran = marketgen_run({"eval",
                                 "--episodes",
                                 (moved / "tasks.jsonl.gz").string(),
                                 "--policy",
                                 "stop",
                                 "--quiet",
                                 "-o",
                                 (scratch.path() / "run").string()});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(rows_in(scratch.path() / "run" / "results.jsonl").size(), 1U);
  const Ran piped = draw("/dev/stdout");
  EXPECT_EQ(piped.status, 2);
  EXPECT_NE(piped.err.find("--frozen: writes the stores' scenes beside"), std::string::npos)
      << piped.err;
}

}  // namespace
}  // namespace marketgen
