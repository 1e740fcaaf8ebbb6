// --skin: another look for a store, and nothing else.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/png.h"
#include "small_store.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

json generated(const fs::path& folder, const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"generate",
                                     "a tiny corner shop with drinks",
                                     "--size=8x6m",
                                     "--seed",
                                     "5",
                                     "--no-previews",
                                     "--quiet",
                                     "-o",
                                     folder.string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Ran ran = marketgen_run(arguments);
  EXPECT_EQ(ran.status, 0) << ran.err;
  return json::parse(contents_of(folder / "store.json"));
}

TEST(Skin, GenerateChangesTheLookAndMovesNothing) {
  const ScratchFolder scratch;
  const json plain = generated(scratch.path() / "plain", {});
  const json skinned = generated(scratch.path() / "skinned", {"--skin", "retro-diner"});
  EXPECT_EQ(plain["scene_hash"], skinned["scene_hash"]);
  EXPECT_NE(plain["look_hash"], skinned["look_hash"]);
  EXPECT_EQ(skinned["brief"]["skin"], "retro-diner");
  const json plan = json::parse(contents_of(scratch.path() / "skinned/plan.json"));
  EXPECT_EQ(plan["look"]["floor"], "tile-chequer-black");  // as data/styles.json has it
  EXPECT_EQ(plan["look"]["light_kelvin"], 3800);
}

TEST(Skin, RenderDrawsTheSameThingsInOtherColours) {
  const ScratchFolder scratch;
  const auto draw = [&](const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"render",
                                       small_store().string(),
                                       "--size=160x90",
                                       "--quality=fast",
                                       "--quiet",
                                       "-o",
                                       (scratch.path() / (name + ".png")).string(),
                                       "--depth",
                                       (scratch.path() / (name + "-depth.png")).string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ran ran = marketgen_run(arguments);
    EXPECT_EQ(ran.status, 0) << ran.err;
    return contents_of(scratch.path() / (name + ".png"));
  };
  // Of the same lamp fittings: these are things, and a style's own.
  EXPECT_NE(draw("plain", {}), draw("skinned", {"--skin", "retro-diner"}));
  EXPECT_EQ(contents_of(scratch.path() / "plain-depth.png"),
            contents_of(scratch.path() / "skinned-depth.png"));
}

TEST(Skin, ExportNamesTheStylesMaterials) {
  const ScratchFolder scratch;
  const fs::path file = scratch.path() / "shop.glb";
  const Ran ran = marketgen_run({"export",
                                 small_store().string(),
                                 "--format",
                                 "glb",
                                 "--skin",
                                 "victorian",
                                 "--quiet",
                                 "--check",
                                 "-o",
                                 file.string()});
  ASSERT_EQ(ran.status, 0) << ran.err;
  const std::string bytes = contents_of(file);
  EXPECT_NE(bytes.find("\"hex-blue\""), std::string::npos);
  EXPECT_NE(bytes.find("\"tile-metro-green\""), std::string::npos);
}

TEST(Skin, AnUnknownStyleNamesTheNearest) {
  const ScratchFolder scratch;
  const std::string file = (scratch.path() / "x").string();
  for (const std::vector<std::string>& arguments : {
           std::vector<std::string>{"render", small_store().string(), "-o", file},
           {"export", small_store().string(), "--format", "glb", "-o", file},
           {"generate", "a shop", "--no-previews", "-o", file},
       }) {
    std::vector<std::string> all = arguments;
    all.insert(all.end(), {"--quiet", "--skin", "victorain"});
    const Ran ran = marketgen_run(all);
    EXPECT_EQ(ran.status, 2) << arguments[0];
    EXPECT_NE(ran.err.find("error[catalog.unknown_kind] --skin"), std::string::npos) << ran.err;
    EXPECT_NE(ran.err.find("\"victorian\""), std::string::npos) << ran.err;
    EXPECT_FALSE(fs::exists(file)) << arguments[0];
  }
}

}  // namespace
}  // namespace marketgen
