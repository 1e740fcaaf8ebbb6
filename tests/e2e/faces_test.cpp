// Packs by photographs of their sides: from pictures to an asset, to a store, to pictures of it.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "small_store.h"
#include "support/face_pictures.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int front_blue = 10, back_blue = 240;

class PhotographedPacks : public testing::Test {
 protected:
  void SetUp() override {
    write_png_face(path("photos/front.png"), graded_picture(120, 240, front_blue));
    write_bytes(path("photos/back.jpg"),
                io::encode_jpeg(graded_picture(120, 240, back_blue)).value());
    write_png_face(path("photos/label.png"), graded_picture(414, 190, front_blue));
  }

  fs::path path(const std::string& name) const { return scratch_.path() / name; }
  Ran with_cache(const std::string& cache, std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(),
                     {"env", "MARKETGEN_CACHE=" + path(cache).string(), MARKETGEN_BINARY});
    return run(arguments, scratch_.path());
  }
  std::string out_of(const std::string& cache, const std::vector<std::string>& arguments) const {
    const Ran ran = with_cache(cache, arguments);
    EXPECT_EQ(ran.status, 0) << ran.err;
    return ran.out;
  }
  json import_tea(const std::string& folder) const {
    return json::parse(out_of("cache", {"assets",        "import",
                                        "--front",       "photos/front.png",
                                        "--back",        "photos/back.jpg",
                                        "--archetype",   "box",
                                        "--size-mm",     "60x60x120",
                                        "--mass-kg",     "0.2",
                                        "--name",        "Green Tea",
                                        "--category",    "dry_goods",
                                        "--subcategory", "tea",
                                        "--json",        "-o",
                                        folder}));
  }
  json import_cola(const std::string& folder) const {
    return json::parse(out_of("cache",
                              {"assets",
                               "import",
                               "--wrap",
                               "photos/label.png",
                               "--archetype",
                               "can",
                               "--size-mm",
                               "66x66x115",
                               "--name",
                               "Cherry Cola",
                               "--category",
                               "beverages",
                               "--subcategory",
                               "soft drinks",
                               "--json",
                               "-o",
                               folder}));
  }
  // A store in which both stand, and what its manifest says.
  json generate(const std::string& folder) const {
    json plan = json::parse(contents_of(small_store() / "plan.json"));
    plan["placements"] = json::array();
    for (const std::string asset : {"tea", "cola"})
      plan["placements"].push_back(
          {{"sku", json::parse(contents_of(path(asset + "/asset.json")))["product"]["sku"]},
           {"position_m", {1.0, asset == "tea" ? 1.0 : 1.2, 0.0}}});
    std::ofstream(path("plan.json")) << plan;
    out_of("cache",
           {"generate",
            "--plan",
            "plan.json",
            "--no-previews",
            "--catalog",
            "tea/asset.json",
            "--catalog",
            "cola/asset.json",
            "-o",
            folder});
    return json::parse(contents_of(path(folder + "/store.json")));
  }

  ScratchFolder scratch_;
};

TEST_F(PhotographedPacks, PicturesBecomeAnAsset) {
  const json tea = import_tea("tea");
  EXPECT_EQ(tea["schema"], "market-asset/1");
  const json& row = tea["product"];
  EXPECT_EQ(row["archetype"], "box");
  EXPECT_EQ(row["name"], "Green Tea");
  EXPECT_EQ(row["faces"]["front"], "front.png");
  EXPECT_EQ(row["faces"]["back"], "back.jpg");
  EXPECT_EQ(row["size_mm"], json({60, 60, 120}));
  EXPECT_EQ(row["mass_kg"], 0.2);
  EXPECT_EQ(row["material"], "cardboard");
  EXPECT_EQ(tea["source"]["file"], "front.png");
  EXPECT_NEAR(tea["estimates"]["volume_m3"].get<double>(), 0.06 * 0.06 * 0.12, 1e-5);
  EXPECT_TRUE(fs::exists(path("tea/front.png")));
  EXPECT_TRUE(fs::exists(path("tea/back.jpg")));
  EXPECT_EQ(import_tea("again"), tea);
  EXPECT_EQ(contents_of(path("again/back.jpg")), contents_of(path("tea/back.jpg")));
  fs::remove_all(path("photos"));
  const json shown = json::parse(out_of("cache",
                                        {"assets",
                                         "show",
                                         row["sku"],
                                         "--json",
                                         "--catalog",
                                         "tea/asset.json",
                                         "--picture",
                                         "tea.png",
                                         "--label",
                                         "label.png"}));
  EXPECT_GT(shown["triangles"], 0);
  const Image label = io::read_png(path("label.png")).value();
  // The net of a box 60 x 60 x 120: the front is its first quarter, the lower two thirds.
  const std::uint8_t* middle = label.at(label.width / 8, label.height * 2 / 3);
  EXPECT_NEAR(middle[0], 120, 3);
  EXPECT_NEAR(middle[1], 120, 3);
  EXPECT_NEAR(middle[2], front_blue, 2);
}

TEST_F(PhotographedPacks, APictureThatIsStretchedIsTold) {
  write_png_face(path("photos/front.png"), graded_picture(150, 240, front_blue));
  const std::string notes = import_tea("tea")["notes"].dump();
  EXPECT_NE(notes.find("the picture of the front is 1.2 times as wide"), std::string::npos)
      << notes;
  EXPECT_EQ(import_cola("cola")["notes"].dump().find("times as"), std::string::npos);
}

using SlowPhotographedPacks = PhotographedPacks;

// The store alone is enough: moved elsewhere, without photos, assets and cache, it is drawn and
// exported to the same bytes.
TEST_F(SlowPhotographedPacks, StandInStoresThatNeedNothingElse) {
  import_tea("tea");
  import_cola("cola");
  const json made = generate("shop");
  EXPECT_EQ(made["own"].size(), 2U);
  std::size_t carried = 0;
  for (const json& file : made["files"])
    carried += file["path"].get<std::string>().starts_with("faces/") ? 1 : 0;
  EXPECT_EQ(carried, 3U);
  const auto seen = [&](const std::string& cache, const std::string& store, const std::string& as) {
    fs::create_directory(path(as));
    out_of(cache,
           {"render",
            store,
            "--camera",
            "entrance",
            "--size=64x36",
            "--quality",
            "fast",
            "-o",
            as + "/shop.png"});
    out_of(cache, {"export", store, "--format", "mjcf", "-o", as + "/shop.xml"});
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(path(as))) {
      if (entry.is_regular_file())
        files[fs::relative(entry.path(), path(as)).string()] = contents_of(entry.path());
    }
    return files;
  };
  const auto before = seen("cache", "shop", "before");
  fs::rename(path("shop"), path("moved"));
  for (const char* gone : {"photos", "tea", "cola", "cache"})
    fs::remove_all(path(gone));
  const auto after = seen("elsewhere", "moved", "after");
  ASSERT_GT(before.size(), 2U);
  ASSERT_EQ(before.size(), after.size());
  for (const auto& [name, bytes] : before) {
    ASSERT_TRUE(after.contains(name)) << name;
    EXPECT_TRUE(after.at(name) == bytes) << name;
  }
}

// The pictures are the store's look, not its geometry.
TEST_F(PhotographedPacks, AnotherPictureIsAnotherLook) {
  import_tea("tea");
  import_cola("cola");
  const json one = generate("one");
  EXPECT_EQ(generate("two"), one);
  write_png_face(path("tea/front.png"), graded_picture(120, 240, front_blue + 50));
  const json other = generate("other");
  EXPECT_EQ(other["scene_hash"], one["scene_hash"]);
  EXPECT_NE(other["look_hash"], one["look_hash"]);
}

}  // namespace
}  // namespace marketgen
