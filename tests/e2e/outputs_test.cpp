// Every output of every command, under every fault that a disk and a person can make. Devices are
// copies in a folder of the test's: a program at fault as root would replace the machine's own.
#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "small_store.h"
#include "support/command_list.h"
#include "support/glb_bytes.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

// A command with one of its outputs at {out}. Also {store}, {episodes}, {model}, {spare}: another
// place that can be written.
struct Output {
  Words command;
  std::string flag;
  Words arguments;
  bool is_folder = false;
  bool is_quick = false;  // its whole work is done in about a second
};

const std::vector<Output>& outputs() {
  const Words render{"{store}", "--size", "16x9", "--quality", "fast", "-o", "{spare}.png"};
  const auto plane = [&](const std::string& flag) {
    Words words = render;
    words.insert(words.end(), {flag, "{out}"});
    return Output{{"render"}, flag, words};
  };
  static const std::vector<Output> all{
      {{"generate"},
       "--output",
       {"a tiny shop", "--size=8x6m", "--no-previews", "-o", "{out}"},
       true,
       true},
      {{"generate"},
       "--record",
       {"a tiny shop",
        "--size=8x6m",
        "--no-previews",
        "-o",
        "{spare}",
        "--planner",
        "openai:x",
        "--record",
        "{out}"},
       true},
      {{"edit"}, "--output", {"{store}", "--say", "a ceiling height of 4 m", "-o", "{out}"}, true},
      {{"report"}, "--output", {"{store}", "-o", "{out}"}},
      {{"query"}, "--output", {"{store}", "products", "-o", "{out}"}, false, true},
      {{"shop"},
       "--record",
       {"{store}", "milk", "--planner", "openai:x", "--record", "{out}"},
       true},
      {{"render"}, "--output", {"{store}", "--size", "16x9", "--quality", "fast", "-o", "{out}"}},
      plane("--depth"),
      plane("--segmentation"),
      plane("--object-ids"),
      plane("--annotations"),
      plane("--categories"),
      plane("--normals"),
      {{"render"},
       "--channels",
       {"{store}", "--size", "16x9", "-o", "{spare}.png", "--channels", "{out}"},
       true},
      {{"pick"}, "--output", {"{store}", "canned-tuna-chunks-150g", "-o", "{out}"}},
      {{"episodes"}, "--output", {"{store}", "--count", "1", "-o", "{out}"}},
      {{"eval"}, "--output", {"--episodes", "{episodes}", "-o", "{out}"}, true},
      {{"eval"},
       "--model-record",
       {"--episodes",
        "{episodes}",
        "-o",
        "{spare}",
        "--policy",
        "vlm",
        "--model",
        "openai:x",
        "--model-record",
        "{out}"},
       true},
      {{"merge"}, "--output", {"{spare}", "-o", "{out}"}, true},
      {{"tables", "tracks"}, "--output", {"{spare}", "-o", "{out}"}},
      {{"tables", "shapes"}, "--output", {"{spare}", "-o", "{out}"}},
      {{"tables", "modules"}, "--output", {"{spare}", "-o", "{out}"}},
      {{"tables", "swap"}, "--output", {"{spare}", "-o", "{out}"}},
      {{"tables", "realism"}, "--output", {"{spare}", "-o", "{out}"}},
      {{"tables", "goals"}, "--output", {"{spare}", "-o", "{out}"}},
      {{"tables", "generator"}, "--output", {"{spare}", "-o", "{out}"}},
      {{"leaderboard"}, "--html", {"{spare}", "--html", "{out}"}},
      {{"replay"}, "--film", {"--episodes", "{episodes}", "--episode", "0", "--film", "{out}"}},
      {{"replay"}, "--strip", {"--episodes", "{episodes}", "--episode", "0", "--strip", "{out}"}},
      {{"export"}, "--output", {"{store}", "--format", "mjcf", "-o", "{out}"}},
      {{"assets", "show"}, "--picture", {"gondola", "--picture", "{out}"}},
      {{"assets", "show"},
       "--label",
       {"beverages-cola-original-330ml", "--label", "{out}"},
       false,
       true},
      {{"assets", "sheet"}, "--output", {"--only", "materials", "-o", "{out}"}, true},
      {{"assets", "import"},
       "--output",
       {"{model}",
        "--no-coacd",
        "--category",
        "beverages",
        "--subcategory",
        "soft drinks",
        "--name",
        "Lemon soda",
        "-o",
        "{out}"},
       true,
       true},
      {{"assets", "import"},
       "--vlm-record",
       {"{model}", "--no-coacd", "-o", "{spare}", "--vlm", "openai:x", "--vlm-record", "{out}"},
       true},
      {{"assets", "heaps"}, "--output", {"-o", "{out}"}},
      {{"manual"}, "--output", {"-o", "{out}"}, true, true},
      {{"schemas"}, "--output", {"-o", "{out}"}, true, true}};
  return all;
}

// The extension that the flag's file must have, if any.
std::string extension_of(const Output& output) {
  static const std::map<std::string, std::string> of_flag{
      {"--annotations", ".json"}, {"--film", ".mp4"}, {"--html", ".html"}, {"--label", ".png"}};
  if (output.is_folder) return "";
  if (const auto found = of_flag.find(output.flag); found != of_flag.end()) return found->second;
  if (output.command[0] == "render" || output.command[0] == "pick" || output.flag != "--output")
    return ".png";
  if (output.command[0] == "export") return ".xml";
  return output.command[0] == "query" ? ".csv" : ".out";
}

class Gate : public testing::Test {
 protected:
  static const fs::path& episodes() {
    static const ScratchFolder scratch;
    static const fs::path file = [] {
      fs::path drawn = scratch.path() / "tasks.jsonl";
      const Ran ran = marketgen_run(
          {"episodes", small_store().string(), "--count", "1", "--quiet", "-o", drawn.string()});
      EXPECT_EQ(ran.status, 0) << ran.err;
      return drawn;
    }();
    return file;
  }

  Words command_of(const Output& output, const std::string& out) {
    Words words = output.command;
    const std::map<std::string, std::string> places{
        {"{out}", out},
        {"{store}", small_store().string()},
        {"{episodes}", episodes().string()},
        {"{model}", model().string()},
        {"{spare}", (scratch_.path() / "spare").string()},
        {"{spare}.png", (scratch_.path() / "spare.png").string()}};
    for (const std::string& word : output.arguments)
      words.push_back(places.contains(word) ? places.at(word) : word);
    return words;
  }

  fs::path model() {
    const fs::path file = scratch_.path() / "model.glb";
    std::ofstream(file, std::ios::binary) << box_glb(0.066F, 0.115F, 0.066F, R"({"mesh": 0})");
    return file;
  }

  static std::set<std::string> names_in(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      names.insert(entry.path().lexically_relative(folder).string());
    return names;
  }

  // Fails before any work: one line on stderr, an error of this kind, and nothing is left.
  void expect_refused(const Output& output, const Ran& ran, int status, const std::string& fault) {
    const std::string what = joined(output.command) + " " + output.flag + ": " + fault;
    EXPECT_EQ(ran.status, status) << what << ": " << ran.err;
    EXPECT_EQ(std::ranges::count(ran.err, '\n'), 1) << what << " after some work: " << ran.err;
    EXPECT_TRUE(
        ran.err.starts_with(status == 2 ? "error[usage.bad_flag]" : "error[io.cannot_write]"))
        << what << ": " << ran.err;
    fs::remove(scratch_.path() / "model.glb");
    EXPECT_TRUE(fs::is_empty(scratch_.path()))
        << what << " left " << *names_in(scratch_.path()).begin();
  }

  ScratchFolder scratch_;
};

TEST_F(Gate, EveryOutputOfEveryCommandIsHere) {
  std::set<std::string> known;
  for (const Output& output : outputs())
    known.insert(joined(output.command) + " " + output.flag);
  std::set<std::string> found;
  const std::regex option("(--[a-z-]+) OUTPUT");
  for (Words command : whole_commands()) {
    const std::string name = joined(command);
    command.push_back("--help");
    const std::string help = marketgen_run(command).out;
    for (auto it = std::sregex_iterator(help.begin(), help.end(), option);
         it != std::sregex_iterator();
         ++it)
      found.insert(name + " " + std::string((*it)[1]));
  }
  EXPECT_EQ(found, known);
}

TEST_F(Gate, NoName) {
  for (const Output& output : outputs())
    expect_refused(output, marketgen_run(command_of(output, "")), 2, "no name");
}

TEST_F(Gate, NowhereToWrite) {
  for (const Output& output : outputs()) {
    const std::string out = "/proc/marketgen/out" + extension_of(output);
    expect_refused(output, marketgen_run(command_of(output, out)), 3, "a place without room");
  }
}

TEST_F(Gate, BelowAFile) {
  for (const Output& output : outputs()) {
    const std::string out = (small_store() / "plan.json/out").string() + extension_of(output);
    expect_refused(output, marketgen_run(command_of(output, out)), 3, "below a file");
  }
}

TEST_F(Gate, AFolderForAFile) {
  for (const Output& output : outputs()) {
    if (output.is_folder) continue;
    const ScratchFolder other;
    const fs::path folder = other.path() / ("folder" + extension_of(output));
    fs::create_directory(folder);
    expect_refused(output, marketgen_run(command_of(output, folder.string())), 3, "a folder");
  }
}

TEST_F(Gate, AWorkingFolderThatIsGone) {
  for (const Output& output : outputs()) {
    const ScratchFolder other;
    Words command{"sh", "-c", "rmdir \"$PWD\" && exec \"$@\"", "sh", MARKETGEN_BINARY};
    const Words words = command_of(output, "out" + extension_of(output));
    command.insert(command.end(), words.begin(), words.end());
    fs::create_directory(other.path() / "gone");
    expect_refused(output, run(command, other.path() / "gone"), 3, "no working folder");
  }
}

// Filled to the last byte. Needs the right to mount.
class FullDisk {
 public:
  explicit FullDisk(const fs::path& folder) : folder_(folder) {
    fs::create_directory(folder);
    mounted_ = mount("none", folder.c_str(), "tmpfs", 0, "size=64k") == 0;
  }
  ~FullDisk() {
    if (mounted_) umount(folder_.c_str());
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
  bool mounted() const { return mounted_; }
  void fill() const {
    std::ofstream filler(folder_ / "filler", std::ios::binary);
    while (filler.put('x').flush()) {
    }
  }

 private:
  fs::path folder_;
  bool mounted_ = false;
};

TEST_F(Gate, AFullDiskIsAnErrorAndTheOldFileStays) {
  const ScratchFolder other;
  const fs::path folder = other.path() / "disk";
  const FullDisk disk(folder);
  if (!disk.mounted()) GTEST_SKIP() << "only root can mount a small disk";
  for (const Output& output : outputs())
    if (!output.is_folder) std::ofstream(folder / ("old" + extension_of(output))) << "old";
  disk.fill();
  const auto before = names_in(folder);
  for (const Output& output : outputs()) {
    if (!output.is_quick) continue;
    const fs::path out = folder / (output.is_folder ? "new" : "old" + extension_of(output));
    const Ran ran = marketgen_run(command_of(output, out.string()));
    EXPECT_EQ(ran.status, 3) << joined(output.command) << ": " << ran.err;
    EXPECT_NE(ran.err.find("No space left"), std::string::npos) << ran.err;
    EXPECT_EQ(names_in(folder), before) << joined(output.command);
    if (output.is_folder) continue;
    EXPECT_EQ(contents_of(out), "old") << joined(output.command);
  }
}

TEST_F(Gate, DevicesAndPipesAreWrittenTo) {
  const ScratchFolder other;
  const fs::path null = other.path() / "null", full = other.path() / "full",
                 pipe = other.path() / "pipe";
  if (mknod(null.c_str(), S_IFCHR | 0666U, makedev(1, 3)) != 0 ||
      mknod(full.c_str(), S_IFCHR | 0666U, makedev(1, 7)) != 0)
    GTEST_SKIP() << "devices can be made by root only";
  for (const Output& output : outputs()) {
    if (output.is_folder || !output.is_quick || !extension_of(output).starts_with(".csv")) continue;
    EXPECT_EQ(marketgen_run(command_of(output, null.string())).status, 0);
    const Ran ran = marketgen_run(command_of(output, full.string()));
    EXPECT_EQ(ran.status, 3) << ran.err;
    EXPECT_NE(ran.err.find("No space left"), std::string::npos) << ran.err;
  }
  EXPECT_TRUE(fs::is_character_file(null) && fs::is_character_file(full));
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string query =
      std::string(MARKETGEN_BINARY) + " query " + small_store().string() + " products";
  const Ran piped = run({"sh", "-c", "cat pipe & " + query + " -o pipe; wait"}, other.path());
  const Ran told = run({"sh", "-c", query + " -o /dev/stdout"});
  const Ran printed = run({"sh", "-c", query});
  EXPECT_EQ(piped.out, printed.out);
  EXPECT_EQ(told.out, printed.out);
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST_F(Gate, OfSeveralOutputsAllOrNoneAreNew) {
  const ScratchFolder other;
  std::ofstream(other.path() / "a.png") << "old";
  const Ran ran = marketgen_run({"render",
                                 small_store().string(),
                                 "--size",
                                 "16x9",
                                 "--quality",
                                 "fast",
                                 "-o",
                                 "a.png",
                                 "--depth",
                                 "/proc/marketgen/depth.png"},
                                other.path());
  EXPECT_EQ(ran.status, 3) << ran.err;
  EXPECT_EQ(contents_of(other.path() / "a.png"), "old");
  const Ran twice = marketgen_run(
      {"render", small_store().string(), "-o", "a.png", "--depth", "./a.png"}, other.path());
  EXPECT_EQ(twice.status, 2) << twice.err;
  EXPECT_EQ(names_in(other.path()), std::set<std::string>{"a.png"});
}

// ---- Standard output. ----

TEST_F(Gate, WhatCannotBePrintedIsAnError) {
  const ScratchFolder other;
  const fs::path full = other.path() / "full";
  if (mknod(full.c_str(), S_IFCHR | 0666U, makedev(1, 7)) != 0)
    GTEST_SKIP() << "devices can be made by root only";
  const std::string shop = small_store().string();
  const std::vector<Words> printing{{"--help"},
                                    {"--version"},
                                    {"doctor"},
                                    {"doctor", "--json"},
                                    {"generate",
                                     "a tiny shop",
                                     "--size=8x6m",
                                     "--no-previews",
                                     "-o",
                                     (scratch_.path() / "new").string()},
                                    {"check", shop},
                                    {"check", shop, "--json"},
                                    {"query", shop, "products"},
                                    {"query", shop, "zones", "--format", "json"},
                                    {"render", shop, "--list-cameras"},
                                    {"assets", "list"},
                                    {"assets", "search", "milk"},
                                    {"assets", "show", "gondola"},
                                    {"bench", "--help"},
                                    {"completion", "bash"}};
  for (const Words& words : printing) {
    Words command{"sh", "-c", "exec \"$@\" > " + full.string(), "sh", MARKETGEN_BINARY};
    command.insert(command.end(), words.begin(), words.end());
    const Ran ran = run(command);
    EXPECT_EQ(ran.status, 3) << joined(words);
    EXPECT_NE(ran.err.find("error[io.cannot_write] standard output"), std::string::npos)
        << joined(words) << ": " << ran.err;
  }
}

TEST_F(Gate, AReaderWhoHasSeenEnoughIsNoError) {
  const std::string query = std::string(MARKETGEN_BINARY) + " query " + small_store().string() +
                            " products; echo status $? >&2";
  const Ran ran = run({"sh", "-c", "(" + query + ") | head -1"});
  EXPECT_EQ(std::ranges::count(ran.out, '\n'), 1);
  EXPECT_EQ(ran.err, "status 141\n");
}

// ---- What dead processes left. ----

TEST_F(Gate, WhatAKilledRunLeftIsSwept) {
  Started generate({MARKETGEN_BINARY, "generate", "a supermarket", "-o", "shop"}, scratch_.path());
  for (int tries = 0; tries < 3000 && fs::is_empty(scratch_.path()); ++tries)
    usleep(10'000);
  generate.end_at_once();
  generate.wait();
  ASSERT_FALSE(fs::is_empty(scratch_.path())) << "was killed before it began";
  const Ran ran = marketgen_run(
      {"generate", "a tiny shop", "--size=8x6m", "--no-previews", "--quiet", "-o", "shop"},
      scratch_.path());
  EXPECT_EQ(ran.status, 0) << ran.err;
  for (const auto& entry : fs::directory_iterator(scratch_.path()))
    EXPECT_EQ(entry.path().filename(), "shop");
}

TEST_F(Gate, ACacheThatCannotBeWrittenIsToldOfOnce) {
  const Ran ran = run({"env",
                       "MARKETGEN_CACHE=/proc/marketgen",
                       MARKETGEN_BINARY,
                       "assets",
                       "show",
                       "beverages-cola-original-330ml",
                       "--picture",
                       (scratch_.path() / "cola.png").string(),
                       "--size",
                       "64"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  const Ran build =
      run({"env", "MARKETGEN_CACHE=/proc/marketgen", MARKETGEN_BINARY, "assets", "build"});
  EXPECT_EQ(build.status, 3) << build.err;  // nothing would be kept of what it draws
  const Ran grasps = run({"env",
                          "MARKETGEN_CACHE=/proc/marketgen",
                          MARKETGEN_BINARY,
                          "grasps",
                          "beverages-cola-original-330ml",
                          "--tool",
                          "panda-hand"});
  EXPECT_EQ(grasps.status, 3) << grasps.err;  // before the study, whose only output it is
  EXPECT_EQ(std::ranges::count(grasps.err, '\n'), 1) << grasps.err;
}

}  // namespace
}  // namespace marketgen
