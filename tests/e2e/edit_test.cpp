// marketgen edit, as a person types it.
#include <gtest/gtest.h>

#include <map>

#include <nlohmann/json.hpp>

#include "io/file.h"
#include "io/json.h"
#include "small_store.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// Every file of a folder by its bytes.
std::map<std::string, std::string> files_of(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file())
      files[fs::relative(entry.path(), folder).string()] = contents_of(entry.path());
  }
  return files;
}

// A copy of the shared store, so that its default name is this test's own.
fs::path copied_store(const ScratchFolder& scratch) {
  fs::copy(small_store(), scratch.path() / "shop", fs::copy_options::recursive);
  return scratch.path() / "shop";
}

TEST(Edit, WordsMakeANewFolderAndLeaveTheOldOne) {
  const ScratchFolder scratch;
  const fs::path shop = copied_store(scratch);
  const auto before = files_of(shop);
  const Ran ran = marketgen_run({"edit",
                                 shop.string(),
                                 "--say",
                                 "fill the dairy to 50 % and a concrete floor",
                                 "--no-previews",
                                 "--quiet"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(files_of(shop), before);
  const fs::path edited = scratch.path() / "shop-edit-1";
  EXPECT_NE(ran.out.find("store       " + edited.string()), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("fixtures"), std::string::npos) << ran.out;
  const json manifest = json::parse(contents_of(edited / "store.json"));
  const json old = json::parse(contents_of(shop / "store.json"));
  EXPECT_EQ(manifest["brief"], old["brief"]);
  ASSERT_EQ(manifest["edits"].size(), 1U);
  EXPECT_EQ(manifest["edits"][0]["words"], "fill the dairy to 50 % and a concrete floor");
  EXPECT_EQ(manifest["edits"][0]["from"], old["scene_hash"]);
  const json plan = json::parse(contents_of(edited / "plan.json"));
  EXPECT_EQ(plan["look"]["floor"], "concrete-polished");
  const Ran check = marketgen_run({"check", edited.string()});
  EXPECT_EQ(check.status, 0) << check.out << check.err;
}

TEST(Edit, DryRunPrintsPatchesThatPatchTakes) {
  const ScratchFolder scratch;
  const fs::path shop = copied_store(scratch);
  const Ran dry = marketgen_run({"edit", shop.string(), "--say", "a concrete floor", "--dry-run"});
  ASSERT_EQ(dry.status, 0) << dry.err;
  EXPECT_EQ(json::parse(dry.out)["patches"],
            json::parse(R"([{"set_look": {"floor": "concrete-polished"}}])"));
  EXPECT_FALSE(fs::exists(scratch.path() / "shop-edit-1"));
  const fs::path file = scratch.path() / "patches.json";
  ASSERT_TRUE(io::write_file(file, dry.out).ok());
  const fs::path edited = scratch.path() / "grey";
  const Ran ran = marketgen_run({"edit",
                                 shop.string(),
                                 "--patch",
                                 file.string(),
                                 "-o",
                                 edited.string(),
                                 "--no-previews",
                                 "--json",
                                 "--quiet"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  const json output = json::parse(ran.out);
  EXPECT_EQ(output["folder"], edited.string());
  EXPECT_EQ(output["changes"]["products"]["moved"], 0);
  EXPECT_EQ(output["changes"]["products"]["gone"], 0);
}

TEST(Edit, StrictTakesNoWordThatIsNotUnderstood) {
  const ScratchFolder scratch;
  const fs::path shop = copied_store(scratch);
  const std::vector<std::string> said{"edit",
                                      shop.string(),
                                      "--say",
                                      "a concrete floor and a zeppelin",
                                      "--no-previews",
                                      "--quiet"};
  std::vector<std::string> strict = said;
  strict.emplace_back("--strict");
  const Ran refused = marketgen_run(strict);
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.out.find("unparsed    \"zeppelin\""), std::string::npos) << refused.out;
  EXPECT_FALSE(fs::exists(scratch.path() / "shop-edit-1"));
  const Ran taken = marketgen_run(said);
  EXPECT_EQ(taken.status, 0) << taken.err;
  EXPECT_NE(taken.out.find("unparsed    \"zeppelin\""), std::string::npos) << taken.out;
}

}  // namespace
}  // namespace marketgen
