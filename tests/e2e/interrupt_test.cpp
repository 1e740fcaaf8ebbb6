// Every command ends soon after Ctrl-C, SIGTERM or a closed terminal, whatever it is at; what was
// finished is kept, nothing is half-written.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "small_store.h"
#include "support/command_list.h"
#include "support/glb_bytes.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;
using Clock = std::chrono::steady_clock;

// Five times and more what is wanted: a second.
constexpr double soon_s = 8;

struct Work {
  Words arguments;
  bool is_long = true;   // it would go on for more than a few seconds
  bool ends_so = false;  // it has done what it was asked for when it is interrupted
};

// Each command at its work; those that need an episodes file have {episodes}.
const std::map<std::string, Work>& works() {
  static const std::map<std::string, Work> all{
      {"doctor", {{}, false}},
      {"generate", {{"a supermarket", "--size=60x40m", "--count", "50", "-o", "{out}"}}},
      {"edit", {{"{store}", "--say", "a ceiling height of 4 m", "-o", "{out}"}, false}},
      {"check", {{"{store}"}, false}},
      {"report",
       {{"{store}",
         "{store}",
         "{store}",
         "{store}",
         "{store}",
         "{store}",
         "{store}",
         "{store}",
         "{store}",
         "{store}",
         "{store}",
         "{store}",
         "-o",
         "{out}"}}},
      {"query", {{"{store}", "products", "-o", "{out}"}, false}},
      {"shop", {{"{store}", "milk"}, false}},
      {"render",
       {{"{store}", "--mode", "path", "--spp", "4096", "--size", "1280x720", "-o", "{out}.png"}}},
      {"view", {{"{store}", "--no-open"}, true, true}},
      {"pick", {{"{store}", "canned-tuna-chunks-150g", "-o", "{out}.png"}, false}},
      {"episodes", {{"{store}", "--count", "1000", "-o", "{out}"}}},
      {"eval", {{"--episodes", "{episodes}", "--policy", "classical", "-o", "{out}"}}},
      {"merge", {{"{store}", "-o", "{out}"}, false}},
      {"leaderboard", {{"{store}"}, false}},
      {"tables tracks", {{"{store}"}, false}},
      {"tables shapes", {{"{store}"}, false}},
      {"tables modules", {{"{store}"}, false}},
      {"tables swap", {{"{store}"}, false}},
      {"tables realism", {{"{store}"}, false}},
      {"tables goals", {{"{store}"}, false}},
      {"tables generator", {{"{store}"}, false}},
      {"replay",
       {{"--episodes",
         "{episodes}",
         "--episode",
         "0",
         "--policy",
         "classical",
         "--strip",
         "{out}.png"}}},
      {"export", {{"{store}", "--format", "glb", "-o", "{out}"}, false}},
      {"assets list", {{}, false}},
      {"assets show", {{"gondola", "--picture", "{out}.png", "--size", "4096"}, false}},
      {"assets search", {{"milk"}, false}},
      {"assets sheet", {{"--pixels", "1024", "-o", "{out}"}}},
      {"assets import", {{"{model}", "-o", "{out}"}, false}},
      {"assets build", {{}}},
      {"assets heaps", {{"-o", "{out}"}}},
      {"grasps", {{"--tries", "20"}}},
      {"bench", {{}}},
      {"completion", {{"bash"}, false}},
      {"manual", {{"-o", "{out}"}, false}},
      {"schemas", {{"-o", "{out}"}, false}}};
  return all;
}

class EveryCommand : public testing::Test {
 protected:
  static fs::path episodes() {
    static const ScratchFolder scratch;
    static const fs::path file = scratch.path() / "tasks.jsonl";
    static const Ran drawn = marketgen_run(
        {"episodes", small_store().string(), "--count", "2", "--quiet", "-o", file.string()});
    EXPECT_EQ(drawn.status, 0) << drawn.err;
    return file;
  }

  Words command_of(const std::string& name, const Work& work) {
    const fs::path model = inputs_.path() / "model.glb";
    std::ofstream(model, std::ios::binary) << box_glb(0.066F, 0.115F, 0.066F, R"({"mesh": 0})");
    const std::string out = (scratch_.path() / "out").string();
    const std::map<std::string, std::string> places{{"{store}", small_store().string()},
                                                    {"{model}", model.string()},
                                                    {"{out}", out},
                                                    {"{out}.png", out + ".png"}};
    std::ofstream(inputs_.path() / "index.html") << "<!doctype html>";
    // A cache of its own: nothing is there yet that would shorten the work.
    Words words{"env",
                "MARKETGEN_CACHE=" + (inputs_.path() / "cache").string(),
                "MARKETGEN_VIEWER=" + inputs_.path().string(),
                MARKETGEN_BINARY};
    for (const std::string& word : split_words(name))
      words.push_back(word);
    for (const std::string& word : work.arguments) {
      if (word == "{episodes}")
        words.push_back(episodes().string());
      else
        words.push_back(places.contains(word) ? places.at(word) : word);
    }
    return words;
  }

  static Words split_words(const std::string& name) {
    std::istringstream in(name);
    Words words;
    for (std::string word; in >> word;)
      words.push_back(word);
    return words;
  }

  static bool is_at_work(const Started& command, const Work& work, int number) {
    return command.handles(number) &&
           (!work.ends_so || command.output_so_far().find("Ctrl-C ends it") != std::string::npos);
  }

  static void expect_end(const Work& work, const Ran& ran, const std::string& name) {
    if (work.ends_so) {
      EXPECT_EQ(ran.status, 0) << name << ": " << ran.err;
      EXPECT_EQ(ran.err, "") << name;
      return;
    }
    const bool finished = !work.is_long && ran.status <= 3;
    EXPECT_TRUE(ran.status == 130 || finished) << name << ": " << ran.status << " " << ran.err;
    EXPECT_TRUE(finished || ran.err.find("error[internal.interrupted]") != std::string::npos)
        << name << ran.err;
  }

  std::vector<std::string> hidden() const {
    std::vector<std::string> names;
    for (const auto& folder : {scratch_.path(), inputs_.path()})
      for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().filename().string().starts_with("."))
          names.push_back(entry.path().string());
    return names;
  }

  ScratchFolder scratch_, inputs_;
};

TEST_F(EveryCommand, IsHere) {
  std::vector<std::string> known, found;
  for (const auto& [name, work] : works())
    known.push_back(name);
  for (const Words& command : whole_commands())
    found.push_back(joined(command));
  std::ranges::sort(found);
  EXPECT_EQ(known, found);
}

TEST_F(EveryCommand, EndsSoonAndLeavesNoParts) {
  constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP};
  int turn = 0;
  for (const auto& [name, work] : works()) {
    Started command(command_of(name, work), scratch_.path());
    const int number = signals[turn++ % 3];
    for (int looks = 0; looks < 2000 && !is_at_work(command, work, number); ++looks)
      usleep(5'000);
    if (work.is_long) usleep(700'000);  // well into it
    const auto sent = Clock::now();
    command.send(number);
    const Ran ran = command.wait();
    const double took_s = std::chrono::duration<double>(Clock::now() - sent).count();
    EXPECT_LT(took_s, soon_s) << name;
    expect_end(work, ran, name);
    EXPECT_TRUE(hidden().empty()) << name << " left " << hidden().front();
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(scratch_.path()))
      fs::remove_all(entry.path(), ignored);
  }
}

std::size_t lines_in(const fs::path& file) {
  const std::string text = contents_of(file);
  return static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

using SlowEveryCommand = EveryCommand;

// Broken off after the first, gone on with: the same bytes as a draw that was left alone.
TEST_F(SlowEveryCommand, EpisodesThatWereDrawnAreKept) {
  const auto command = [&](const std::string& out, bool resume) {
    Words words{MARKETGEN_BINARY,
                "episodes",
                small_store().string(),
                "--count",
                "3",
                "--seed",
                "5",
                "--quiet",
                "--threads",
                "1",
                "-o",
                out};
    if (resume) words.push_back("--resume");
    return words;
  };
  const fs::path part = scratch_.path() / "part.jsonl", journal = part.string() + ".unfinished";
  Started drawing(command(part.string(), false));
  for (int looks = 0; looks < 12'000 && lines_in(journal) < 2; ++looks)
    usleep(5'000);
  drawing.interrupt();
  const Ran broken = drawing.wait();
  ASSERT_EQ(broken.status, 130) << broken.err;
  EXPECT_FALSE(fs::exists(part));
  const std::size_t kept = lines_in(journal);
  ASSERT_GE(kept, 2U);
  std::ofstream(journal, std::ios::app) << R"({"number": 2, "episode": {"sch)";  // cut off
  const Ran resumed = run(command(part.string(), true));
  EXPECT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_FALSE(fs::exists(journal));
  const fs::path whole = scratch_.path() / "whole.jsonl";
  EXPECT_EQ(run(command(whole.string(), false)).status, 0);
  EXPECT_EQ(contents_of(part), contents_of(whole));
}

// The journal of another draw is not gone on with.
TEST_F(EveryCommand, EpisodesOfAnotherDrawAreNotMixedIn) {
  const std::string out = (scratch_.path() / "tasks.jsonl").string();
  std::ofstream(out + ".unfinished") << R"({"schema": "market-drawing/1", "draw": "another"})"
                                     << "\n";
  const Ran ran =
      marketgen_run({"episodes", small_store().string(), "--count", "1", "--resume", "-o", out});
  EXPECT_EQ(ran.status, 2);
  EXPECT_NE(ran.err.find("--resume"), std::string::npos) << ran.err;
}

// Broken off, gone on with and broken off again: what was settled first is not settled anew.
TEST_F(SlowEveryCommand, HeapsThatWereSettledAreKept) {
  const fs::path out = scratch_.path() / "heaps.json", journal = out.string() + ".unfinished";
  const auto broken_off = [&](Words words, std::size_t lines) {
    words.insert(words.begin(), {MARKETGEN_BINARY, "assets", "heaps", "-o", out.string()});
    Started settling(words);
    for (int looks = 0; looks < 24'000 && lines_in(journal) < lines; ++looks)
      usleep(5'000);
    settling.interrupt();
    return settling.wait();
  };
  const Ran first = broken_off({}, 2);
  ASSERT_EQ(first.status, 130) << first.err;
  EXPECT_NE(first.err.find("go on with --resume"), std::string::npos) << first.err;
  const std::string kept = contents_of(journal);
  const Ran second = broken_off({"--resume"}, lines_in(journal) + 1);
  ASSERT_EQ(second.status, 130) << second.err;
  EXPECT_TRUE(contents_of(journal).starts_with(kept));
  EXPECT_FALSE(fs::exists(out));

  std::set<std::size_t> numbers;
  const std::string rows = contents_of(fs::path(MARKETGEN_SOURCE_DIR) / "data/heaps.json");
  const nlohmann::json known = nlohmann::json::parse(rows);
  std::istringstream lines(contents_of(journal));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    const nlohmann::json settled = nlohmann::json::parse(line);
    const std::size_t number = settled["number"];
    EXPECT_TRUE(numbers.insert(number).second) << number << " twice";
    EXPECT_EQ(settled["heap"], known.at(number));
  }
}

// The rates of products that were finished lie in the cache, also while the study goes on.
TEST_F(EveryCommand, GraspsThatWereStudiedAreKept) {
  Started study({"env",
                 "MARKETGEN_CACHE=" + inputs_.path().string(),
                 MARKETGEN_BINARY,
                 "grasps",
                 "--tries",
                 "1",
                 "--tool",
                 "suction-cup"});
  const fs::path database = inputs_.path() / "grasps/grasps.sqlite";
  for (int looks = 0; looks < 12'000 && !fs::exists(database); ++looks)
    usleep(10'000);
  study.interrupt();
  EXPECT_EQ(study.wait().status, 130);
  EXPECT_GT(fs::file_size(database), 0U);
}

}  // namespace
}  // namespace marketgen
