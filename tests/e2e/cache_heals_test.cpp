// Whatever befalls the files of the cache, commands answer as with a fresh one, name what they
// found and put it right.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "imported_soda.h"
#include "support/face_pictures.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string can = "beverages-cola-original-330ml";

// What the commands answer, and what they say besides.
struct Answers {
  std::map<std::string, std::string> of;
  std::string said;
};

class CacheHeals : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    scratch_ = std::make_unique<ScratchFolder>();
    const Ran imported = cached(soda_import(folder()));
    ASSERT_EQ(imported.status, 0) << imported.err;
    own_ = json::parse(imported.out)["product"]["sku"];
    write_png_face(folder() / "tea/front.png", graded_picture(60, 120, 30));
    write_bytes(folder() / "tea/own.json",
                R"([{"sku": "own-tea", "ean": "2999999999991", "name": "Tea",
      "category": "dry_goods", "subcategory": "tea", "archetype": "box", "size_mm": [60, 60, 120],
      "mass_kg": 0.1, "faces": {"front": "front.png"}}])");
    const Ran made = cached({"generate",
                             "a kiosk with snacks and cold drinks",
                             "--size",
                             "5x4m",
                             "--no-previews",
                             "--quiet",
                             "-o",
                             "kiosk"});
    ASSERT_EQ(made.status, 0) << made.err;
    fs::remove_all(folder() / "cache");
    fresh_ = answers();
    for (const auto& entry : fs::recursive_directory_iterator(folder() / "cache"))
      if (entry.is_regular_file()) files_[entry.path()] = contents_of(entry.path());
  }
  static void TearDownTestSuite() { scratch_.reset(); }

  static const fs::path& folder() { return scratch_->path(); }
  static Ran cached(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(),
                     {"env",
                      "MARKETGEN_CACHE=" + (folder() / "cache").string(),
                      "timeout",
                      "100",
                      MARKETGEN_BINARY});
    return run(arguments, folder());
  }

  // Of commands that together put every kind of file into the cache.
  static Answers answers() {
    Answers all;
    const auto ask = [&](const std::string& name, const std::vector<std::string>& arguments) {
      const Ran ran = cached(arguments);
      EXPECT_EQ(ran.status, 0) << name << ": " << ran.err;
      all.said += ran.err;
      all.of[name] = ran.out;
    };
    ask("search", {"assets", "search", "something to drink", "--json"});
    ask("own mesh", {"assets", "show", own_, "--json", "--catalog", "soda/asset.json"});
    ask("own faces", {"assets", "show", "own-tea", "--json", "--catalog", "tea/own.json"});
    ask("grasps", {"grasps", can, "--tool", "panda-hand", "--tries", "1", "--json", "--quiet"});
    ask("picture",
        {"render",
         "kiosk",
         "--camera",
         "entrance",
         "--size=64x36",
         "--quality",
         "fast",
         "--quiet",
         "-o",
         "out.png"});
    const json report = json::parse(all.of["grasps"], nullptr, false);
    all.of["grasps"] = report.is_object() ? report["rates"].dump() : "no JSON";
    all.of["picture"] = contents_of(folder() / "out.png");
    return all;
  }

  static std::unique_ptr<ScratchFolder> scratch_;
  static std::string own_;
  static Answers fresh_;
  static std::map<fs::path, std::string> files_;  // of the cache, as they were made
};
std::unique_ptr<ScratchFolder> CacheHeals::scratch_;
std::string CacheHeals::own_;
Answers CacheHeals::fresh_;
std::map<fs::path, std::string> CacheHeals::files_;

void replace(const fs::path& file, const std::string& content) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << content;
}

struct Damage {
  const char* name;
  std::function<void(const fs::path& file, std::string content)> make;
};

const std::vector<Damage>& damages() {
  static const std::vector<Damage> all{
      {"cut in half",
       [](const fs::path& f, std::string c) { replace(f, c.substr(0, c.size() / 2)); }},
      {"empty", [](const fs::path& f, const std::string&) { replace(f, ""); }},
      {"zeros",
       [](const fs::path& f, const std::string& c) { replace(f, std::string(c.size(), '\0')); }},
      {"a bit turned",
       [](const fs::path& f, std::string c) {
         c[c.size() / 2] = static_cast<char>(c[c.size() / 2] ^ 4);
         replace(f, c);
       }},
      {"its kind changed",
       [](const fs::path& f, std::string c) {
         c[c.size() - 24] = static_cast<char>(c[c.size() - 24] ^ 1);  // where the kind is noted
         replace(f, c);
       }},
      {"a folder",
       [](const fs::path& f, const std::string&) {
         fs::remove(f);
         fs::create_directory(f);
       }},
      {"a pipe",
       [](const fs::path& f, const std::string&) {
         fs::remove(f);
         mkfifo(f.c_str(), 0600);
       }},
      {"without rights",
       [](const fs::path& f, const std::string&) { fs::permissions(f, fs::perms::none); }},
  };
  return all;
}

TEST_F(CacheHeals, EveryKindOfFileIsThere) {
  std::map<std::string, int> kinds;
  for (const auto& [file, content] : files_)
    ++kinds[file.parent_path().filename().string()];
  for (const char* kind : {"assets", "faces", "grasps", "labels", "light", "made", "meshes"})
    EXPECT_GT(kinds[kind], 0) << kind;
  EXPECT_EQ(kinds.size(), 7U) << "another kind of cached file belongs into this test";
  EXPECT_EQ(fresh_.said, "");
}

using SlowCacheHeals = CacheHeals;

TEST_F(SlowCacheHeals, WhateverBefallsAllOfItsFiles) {
  for (const Damage& damage : damages()) {
    for (const auto& [file, content] : files_)
      damage.make(file, content);
    const Answers now = answers();
    for (const auto& [name, answer] : fresh_.of)
      EXPECT_TRUE(now.of.at(name) == answer) << name << ", " << damage.name;
    const bool read_anyhow = std::string_view(damage.name) == "without rights" && geteuid() == 0;
    for (const auto& [file, content] : files_) {
      EXPECT_TRUE(contents_of(file) == content) << file << " is not put right, " << damage.name;
      const bool is_named = now.said.find(file.string()) != std::string::npos;
      EXPECT_TRUE(is_named || read_anyhow) << file << ", " << damage.name;
    }
  }
}

// The rows of this program, of every subcategory the first product only.
void write_few_products(const fs::path& data) {
  fs::copy(fs::path(MARKETGEN_SOURCE_DIR) / "data", data, fs::copy_options::recursive);
  for (const auto& file : fs::directory_iterator(data / "products")) {
    std::set<std::string> seen;
    json few = json::array();
    for (const json& row : json::parse(contents_of(file.path())))
      if (seen.insert(row["subcategory"]).second) few.push_back(row);
    replace(file.path(), few.dump());
  }
}

// Large sheets find no room, as on a disk that fills up midway: no summary claims them.
TEST(CacheWithoutRoom, WhatIsNotKeptIsNotClaimed) {
  const ScratchFolder scratch;
  write_few_products(scratch.path() / "data");
  const std::string settings = "MARKETGEN_DATA=data MARKETGEN_CACHE=cache ";
  const std::string build = std::string(MARKETGEN_BINARY) + " assets build --quiet";
  const Ran short_of =
      run({"sh", "-c", "ulimit -f 100; " + settings + "exec " + build + " --json"}, scratch.path());
  EXPECT_EQ(short_of.status, 3) << short_of.err;
  const json report = json::parse(short_of.out);
  const auto kept = static_cast<std::size_t>(
      std::distance(fs::directory_iterator(scratch.path() / "cache/labels"), {}));
  EXPECT_EQ(report["kept"], kept);
  EXPECT_GT(kept, 0U);
  EXPECT_LT(kept, report["labels"].get<std::size_t>());
  const std::string lost = std::to_string(report["labels"].get<std::size_t>() - kept) + " of ";
  EXPECT_NE(short_of.err.find(lost), std::string::npos) << short_of.err;

  const Ran with_room = run({"sh", "-c", settings + "exec " + build}, scratch.path());
  EXPECT_EQ(with_room.status, 0) << with_room.err;
  EXPECT_NE(with_room.out.find("all kept in"), std::string::npos) << with_room.out;
}

}  // namespace
}  // namespace marketgen
