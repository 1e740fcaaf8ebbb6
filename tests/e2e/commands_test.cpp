// The commands, as a person or a script starts them: on one small store.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "imported_soda.h"
#include "io/png.h"
#include "small_store.h"
#include "support/command_list.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// Runs the program and expects success.
std::string output_of(const std::vector<std::string>& arguments, const fs::path& folder = {}) {
  const Ran ran = marketgen_run(arguments, folder);
  EXPECT_EQ(ran.status, 0) << arguments[0] << ": " << ran.err;
  return ran.out;
}

json json_of(const std::vector<std::string>& arguments, const fs::path& folder = {}) {
  const std::string text = output_of(arguments, folder);
  const json parsed = json::parse(text, nullptr, false);
  EXPECT_FALSE(parsed.is_discarded()) << arguments[0] << " prints no JSON: " << text.substr(0, 200);
  return parsed;
}

std::string shop() {
  return small_store().string();
}
json manifest() {
  return json::parse(contents_of(small_store() / "store.json"));
}

// ---- Help. ----

TEST(Help, EveryCommandHasAnExample) {
  ASSERT_GE(commands().size(), 9U);
  const std::string overview = output_of({"--help"});
  for (const std::string& command : commands()) {
    EXPECT_NE(overview.find(command), std::string::npos) << command;
    const std::string help = output_of({command, "--help"});
    EXPECT_NE(help.find("Example:"), std::string::npos) << command;
    EXPECT_NE(help.find("marketgen " + command), std::string::npos) << command;
  }
}

TEST(Help, EveryActionOnAssets) {
  for (const char* action : {"list", "show", "search", "sheet", "import"})
    EXPECT_NE(output_of({"assets", action, "--help"}).find("Usage"), std::string::npos) << action;
}

TEST(Help, VersionSaysWhatThisBuildIs) {
  const std::string text = output_of({"--version"});
  EXPECT_TRUE(std::regex_search(text, std::regex("^marketgen [0-9]+\\.[0-9]+\\.[0-9]+\n"))) << text;
  EXPECT_TRUE(std::regex_search(text, std::regex("\ncommit +([0-9a-f]{12}\\+?|unknown)\n")))
      << text;
  for (const char* fact : {"build", "compiler", "Embree", "Eigen", "OpenCV", "Pango", "Cairo"})
    EXPECT_TRUE(std::regex_search(text, std::regex("\n" + std::string(fact) + " +\\S"))) << text;
  // The one that was asked for is the one that runs.
  const std::string pins = contents_of(fs::path(MARKETGEN_SOURCE_DIR) / "tools/requirements.txt");
  std::smatch pinned;
  ASSERT_TRUE(std::regex_search(pins, pinned, std::regex("mujoco-core==(\\S+)")));
  EXPECT_NE(text.find("MuJoCo     " + pinned[1].str() + "\n"), std::string::npos) << text;
}

TEST(Help, DoctorKnowsTheSameBuild) {
  const std::string version = output_of({"--version"});
  std::smatch commit;
  ASSERT_TRUE(std::regex_search(version, commit, std::regex("commit +(\\S+)")));
  std::map<std::string, std::string> found;
  for (const json& finding : json_of({"doctor", "--json"}))
    found[finding["part"]] = finding["detail"];
  EXPECT_NE(found["program"].find("commit " + commit[1].str()), std::string::npos);
  EXPECT_NE(found["libraries"].find("MuJoCo"), std::string::npos);
}

// ---- generate. ----

TEST(Generate, JsonOfSeveralVariants) {
  const ScratchFolder scratch;
  const std::string text = output_of({"generate",
                                      "a tiny corner shop with drinks",
                                      "--size=8x6m",
                                      "--no-previews",
                                      "--quiet",
                                      "--json",
                                      "--count",
                                      "2",
                                      "-o",
                                      "shops"},
                                     scratch.path());
  std::istringstream lines(text);
  std::vector<json> stores;
  for (std::string line; std::getline(lines, line);)
    stores.push_back(json::parse(line));
  ASSERT_EQ(stores.size(), 2U);
  EXPECT_EQ(stores[0]["folder"], "shops/variant-1");
  EXPECT_EQ(stores[1]["folder"], "shops/variant-2");
  EXPECT_NE(stores[0]["manifest"]["scene_hash"], stores[1]["manifest"]["scene_hash"]);
  EXPECT_EQ(stores[0]["manifest"]["seed"], 1);
  EXPECT_EQ(stores[1]["manifest"]["seed"], 2);
  EXPECT_EQ(stores[0]["report"]["schema"], "market-report/1");
  EXPECT_TRUE(stores[0]["pictures"].empty());
  EXPECT_TRUE(fs::exists(scratch.path() / "shops/variant-2/scene.bin"));
}

TEST(Generate, QuietSaysNothingOnStderr) {
  const ScratchFolder scratch;
  const Ran ran = marketgen_run(
      {"generate", "a tiny corner shop", "--size=8x6m", "--no-previews", "--quiet", "-o", "shop"},
      scratch.path());
  EXPECT_EQ(ran.status, 0);
  EXPECT_EQ(ran.err, "");
  EXPECT_NE(ran.out.find("scene_hash"), std::string::npos);
}

TEST(Generate, PromptFromAFileAndPlanFromAStore) {
  const ScratchFolder scratch;
  std::ofstream(scratch.path() / "prompt.txt") << "a tiny corner shop with drinks\n";
  output_of({"generate",
             "--prompt-file",
             "prompt.txt",
             "--size=8x6m",
             "--no-previews",
             "--seed",
             "9",
             "-o",
             "one"},
            scratch.path());
  output_of({"generate", "--plan", "one/plan.json", "--no-previews", "--seed", "9", "-o", "two"},
            scratch.path());
  EXPECT_EQ(contents_of(scratch.path() / "one/scene.bin"),
            contents_of(scratch.path() / "two/scene.bin"));
}

TEST(Generate, ProductsOfOnesOwn) {
  const ScratchFolder scratch;
  std::ofstream(scratch.path() / "own.json")
      << R"([{"sku": "own-elderflower", "ean": "2999999999991", "name": "Elderflower Lemonade", "category": "beverages",
      "subcategory": "soft drinks", "archetype": "can", "size_mm": [66, 66, 115], "mass_kg": 0.35, "unit_of_measure": "l", "unit_amount": 0.33},
      {"sku": "own-giant", "ean": "2999999999984", "name": "Giant", "category": "beverages", "subcategory": "soft drinks",
      "archetype": "can", "size_mm": [66, 66, 1500], "mass_kg": 0.35}])";
  const json found = json_of({"assets", "search", "elderflower", "--json", "--catalog", "own.json"},
                             scratch.path());
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0]["id"], "own-elderflower");
  const std::string out = output_of({"generate",
                                     "a shop that sells only drinks",
                                     "--size=9x8m",
                                     "--no-previews",
                                     "--catalog",
                                     "own.json",
                                     "-o",
                                     "shop"},
                                    scratch.path());
  EXPECT_GE(json_of({"query", "shop", "products", "--where", "sku=own-elderflower", "--json"},
                    scratch.path())
                .size(),
            1U);
  EXPECT_NE(out.find("not stocked own-giant: it is 1500 mm tall"), std::string::npos) << out;
  const json report = json::parse(contents_of(scratch.path() / "shop/report.json"));
  ASSERT_EQ(report["unstocked"].size(), 1U);
  EXPECT_EQ(report["unstocked"][0]["sku"], "own-giant");
}

// A model becomes an asset, the asset stands in a store, and the store needs neither the model nor
// the cache to be drawn again.
TEST(Assets, ImportedModelsStandInStores) {
  const ScratchFolder scratch;
  const json asset = json_of(soda_import(scratch.path()), scratch.path());
  EXPECT_EQ(asset["schema"], "market-asset/1");
  EXPECT_EQ(asset["product"]["size_mm"], json({66, 66, 115}));
  const std::string sku = asset["product"]["sku"];
  const std::string catalogue = "soda/asset.json";
  const json shown =
      json_of({"assets", "show", sku, "--json", "--catalog", catalogue}, scratch.path());
  EXPECT_EQ(shown["triangles"], 12);
  EXPECT_EQ(shown["pieces"][0]["shape"], "hull");
  json plan = json::parse(contents_of(small_store() / "plan.json"));
  plan["placements"] = json::array({{{"sku", sku}, {"position_m", {1.0, 1.0, 0.0}}}});
  std::ofstream(scratch.path() / "plan.json") << plan;
  output_of(
      {"generate", "--plan", "plan.json", "--no-previews", "--catalog", catalogue, "-o", "shop"},
      scratch.path());
  EXPECT_GE(json_of({"query", "shop", "products", "--where", "sku=" + sku, "--format", "json"},
                    scratch.path())
                .size(),
            1U);  // the shelves may have taken some too
  EXPECT_FALSE(fs::is_empty(scratch.path() / "shop/meshes"));
  fs::remove_all(scratch.path() / "soda");
  const Ran drawn = run({"env",
                         "MARKETGEN_CACHE=" + (scratch.path() / "elsewhere").string(),
                         MARKETGEN_BINARY,
                         "render",
                         "shop",
                         "--camera",
                         "entrance",
                         "--size=64x36",
                         "--quality",
                         "fast",
                         "-o",
                         "entrance.png"},
                        scratch.path());
  EXPECT_EQ(drawn.status, 0) << drawn.err;
}

TEST(Generate, AnInterruptLeavesNothingBehind) {
  const ScratchFolder scratch;
  Started generate({MARKETGEN_BINARY, "generate", "a supermarket", "-o", "shop"}, scratch.path());
  for (int tries = 0; tries < 3000 && generate.errors_so_far().find("save") == std::string::npos;
       ++tries)
    usleep(10'000);
  generate.interrupt();  // while the pictures are drawn
  const Ran ran = generate.wait();
  EXPECT_EQ(ran.status, 130);
  EXPECT_NE(ran.err.find("error[internal.interrupted]"), std::string::npos) << ran.err;
  EXPECT_TRUE(fs::is_empty(scratch.path()));
}

// ---- check and report. ----

TEST(Check, StatusSaysWhetherAHardRuleIsBroken) {
  const Ran ran = marketgen_run({"check", shop(), "--json"});
  const json result = json::parse(ran.out);
  EXPECT_EQ(ran.status, result["ok"] ? 0 : 1);
  EXPECT_EQ(result["path"], shop());
  const bool hard = std::any_of(result["rules"].begin(),
                                result["rules"].end(),
                                [](const json& rule) { return rule["severity"] == "hard"; });
  EXPECT_EQ(hard, !result["ok"].get<bool>());
  EXPECT_EQ(result["requirements"].size(), manifest()["requirements"].size());
}

TEST(Check, AChangedStore) {
  const ScratchFolder scratch;
  fs::copy(small_store(), scratch.path() / "shop", fs::copy_options::recursive);
  std::ofstream(scratch.path() / "shop/planogram.csv", std::ios::app) << "one more row\r\n";
  const Ran ran = marketgen_run({"check", (scratch.path() / "shop").string()});
  EXPECT_EQ(ran.status, 1);
  EXPECT_NE(ran.err.find("error[store.changed]"), std::string::npos) << ran.err;
  EXPECT_NE(ran.err.find("planogram.csv"), std::string::npos) << ran.err;
}

TEST(Check, APlan) {
  const Ran ran = marketgen_run({"check", (small_store() / "plan.json").string()});
  EXPECT_TRUE(ran.status == 0 || ran.status == 1) << ran.err;
  EXPECT_NE(ran.out.find("plan.json"), std::string::npos);
}

TEST(Report, MeasuresWhatNeedsPhysics) {
  const ScratchFolder scratch;
  const json report =
      json_of({"report", shop(), "--json", "--quiet", "-o", "page.html"}, scratch.path());
  EXPECT_EQ(report["metrics"]["COL"], 0);
  EXPECT_EQ(report["metrics"]["OOB"], 0);
  EXPECT_EQ(report["metrics"]["stb_products"], 200);
  EXPECT_GE(report["metrics"]["STB"].get<double>(),
            0.95);  // goods stand still when they are let go
  EXPECT_GE(report["metrics"]["NAV"].get<double>(), 0.8);
  const std::string page = contents_of(scratch.path() / "page.html");
  EXPECT_TRUE(page.starts_with("<!doctype html>"));
  EXPECT_NE(page.find(manifest()["scene_hash"]), std::string::npos);
}

// ---- query. ----

TEST(Query, EveryTableAsJsonAndCsv) {
  const json counts = manifest()["counts"];
  for (const char* table : {"products", "fixtures", "zones", "prices", "materials", "planogram"}) {
    const json rows = json_of({"query", shop(), table, "--format", "json"});
    const std::string csv = output_of({"query", shop(), table});
    EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), rows.size() + 1)
        << table;
    EXPECT_FALSE(rows.empty()) << table;
    if (std::string(table) == "products") {
      EXPECT_EQ(rows.size(), counts["products"]);
    }
    if (std::string(table) == "fixtures") {
      EXPECT_EQ(rows.size(), counts["fixtures"]);
    }
    if (std::string(table) == "prices") {
      EXPECT_EQ(rows.size(), counts["skus"]);
    }
  }
  EXPECT_EQ(output_of({"query", shop(), "planogram"}),
            contents_of(small_store() / "planogram.csv"));
}

TEST(Query, WhereAndOutput) {
  const ScratchFolder scratch;
  output_of(
      {"query", shop(), "products", "--where", "zone=dairy,level=0", "--json", "-o", "low.json"},
      scratch.path());
  const json rows = json::parse(contents_of(scratch.path() / "low.json"));
  ASSERT_FALSE(rows.empty());
  for (const json& row : rows) {
    EXPECT_EQ(row["zone"], "dairy");
    EXPECT_EQ(row["level"], 0);
  }
}

TEST(Query, IdsAreUnique) {
  std::set<std::string> ids;
  const json rows = json_of({"query", shop(), "products", "--json"});
  for (const json& row : rows)
    ids.insert(row["id"]);
  EXPECT_EQ(ids.size(), rows.size());
}

// ---- render. ----

TEST(Render, PictureDepthSegmentationNormals) {
  const ScratchFolder scratch;
  output_of({"render",
             shop(),
             "--camera",
             "aisle",
             "--size",
             "160x90",
             "--quality",
             "fast",
             "--quiet",
             "-o",
             "aisle.png",
             "--depth",
             "depth.png",
             "--segmentation",
             "parts.png",
             "--normals",
             "normals.png"},
            scratch.path());
  for (const char* name : {"aisle.png", "parts.png", "normals.png"}) {
    const auto picture = io::read_png(scratch.path() / name);
    ASSERT_TRUE(picture.ok()) << name;
    EXPECT_EQ(picture->width, 160) << name;
    EXPECT_EQ(picture->height, 90) << name;
    const std::set<std::uint8_t> values(picture->pixels.begin(), picture->pixels.end());
    EXPECT_GT(values.size(), 16U) << name << " is nearly one colour";
  }
  EXPECT_GT(fs::file_size(scratch.path() / "depth.png"), 1000U);
}

TEST(Render, TheEndingOfAFilesNameSaysItsFormat) {
  const ScratchFolder scratch;
  std::vector<std::string> command{
      "render", shop(), "--camera=aisle", "--size=64x36", "--quality=fast", "--quiet", "-o"};
  command.emplace_back("aisle.jpg");
  output_of(command, scratch.path());
  EXPECT_EQ(contents_of(scratch.path() / "aisle.jpg").substr(0, 3), "\xFF\xD8\xFF");
  command.back() = "aisle.tiff";
  const Ran refused = marketgen_run(command, scratch.path());
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("error[usage.bad_flag] -o: \"aisle.tiff\""), std::string::npos)
      << refused.err;
  command.back() = "aisle.png";
  command.insert(command.end(), {"--depth", "depth.jpg"});
  EXPECT_EQ(marketgen_run(command, scratch.path()).status, 2);  // numbers do not survive JPEG
  EXPECT_FALSE(fs::exists(scratch.path() / "aisle.png"));
}

TEST(Render, StandardCamerasAndOnesOwn) {
  const std::string cameras = output_of({"render", shop(), "--list-cameras"});
  for (const char* name : {"top", "entrance", "aisle", "checkout"})
    EXPECT_NE(cameras.find(name), std::string::npos) << name;
  const ScratchFolder scratch;
  output_of({"render",
             shop(),
             "--from",
             "1,1,1.6",
             "--at",
             "6,6,1",
             "--size",
             "64x36",
             "--quality",
             "fast",
             "--quiet",
             "-o",
             "own.png"},
            scratch.path());
  EXPECT_TRUE(io::read_png(scratch.path() / "own.png").ok());
}

// The free floor nearest to the shop's middle, found by asking: the program names a clear place
// when the one it was given is blocked.
std::string place_for(const std::string& robot, const std::string& place) {
  const ScratchFolder scratch;
  const Ran ran = marketgen_run({"render",
                                 shop(),
                                 "--robot",
                                 robot + "@" + place,
                                 "--size=16x16",
                                 "--quality=fast",
                                 "--quiet",
                                 "-o",
                                 "try.png"},
                                scratch.path());
  if (ran.status == 0) return place;
  const std::string clear = "it is clear at ";
  const std::size_t at = ran.err.find(clear);
  EXPECT_NE(at, std::string::npos) << ran.err;
  return ran.err.substr(at + clear.size(), ran.err.find('\n') - at - clear.size());
}

TEST(Render, RobotsHaveTheirNumbersInEveryMode) {
  const std::string place = place_for("panda-on-stand", "6,4");
  const double x = std::stod(place), y = std::stod(place.substr(place.find(',') + 1));
  for (const char* mode : {"sensor", "path"}) {
    const ScratchFolder scratch;
    output_of({"render",    shop(),
               "--robot",   "panda-on-stand@" + place + ",90,joint1=10deg",
               "--from",    fmt::format("{},{},2.2", x + 0.2, y + 0.2),
               "--at",      fmt::format("{},{},0", x, y),
               "--size",    "64x48",
               "--mode",    mode,
               "--spp",     "1",
               "--quiet",   "-o",
               "robot.png", "--object-ids",
               "ids.png",   "--annotations",
               "seen.json", "--depth",
               "depth.png"},
              scratch.path());
    const json seen = json::parse(contents_of(scratch.path() / "seen.json"));
    const json robot = seen["objects"].back();
    EXPECT_EQ(robot["kind"], "actor");
    EXPECT_EQ(robot["name"], "panda-on-stand");
    const std::uint32_t number = robot["id"];
    const json counts = manifest()["counts"];
    EXPECT_EQ(
        number,
        2 + counts["fixtures"].get<std::uint32_t>() + counts["products"].get<std::uint32_t>());
    const auto ids = io::read_png(scratch.path() / "ids.png");
    ASSERT_TRUE(ids.ok());
    int pixels = 0;
    for (std::size_t i = 0; i + 2 < ids->pixels.size(); i += 3) {
      const std::uint32_t id =
          ids->pixels[i] + 256U * ids->pixels[i + 1] + 65'536U * ids->pixels[i + 2];
      pixels += id == number ? 1 : 0;
    }
    EXPECT_EQ(pixels, robot["pixels"]) << mode;
    EXPECT_GT(pixels, 300) << mode;
  }
}

// The camera block of annotations is a camera file: the picture it takes is the same one.
TEST(Render, AnnotationsHoldTheCameraForAnotherPicture) {
  const ScratchFolder scratch;
  output_of({"render",
             shop(),
             "--camera",
             "aisle",
             "--size",
             "64x48",
             "--quiet",
             "-o",
             "first.png",
             "--depth",
             "first.npy",
             "--annotations",
             "seen.json",
             "--object-ids",
             "first-ids.png"},
            scratch.path());
  const json seen = json::parse(contents_of(scratch.path() / "seen.json"));
  EXPECT_EQ(seen["schema"], "market-annotations/1");
  EXPECT_EQ(seen["scene_hash"], manifest()["scene_hash"]);
  std::ofstream(scratch.path() / "camera.json") << seen["camera"].dump();
  output_of({"render",
             shop(),
             "--camera-file",
             "camera.json",
             "--quiet",
             "-o",
             "second.png",
             "--object-ids",
             "second-ids.png"},
            scratch.path());
  const auto first = io::read_png(scratch.path() / "first-ids.png"),
             second = io::read_png(scratch.path() / "second-ids.png");
  ASSERT_TRUE(first.ok() && second.ok());
  int other = 0;
  for (std::size_t i = 0; i < first->pixels.size(); i += 3)
    other += std::equal(&first->pixels[i], &first->pixels[i] + 3, &second->pixels[i]) ? 0 : 1;
  EXPECT_LE(other, 3);  // a quaternion and a target differ in their last bits
  int pixels = 0;
  for (const json& object : seen["objects"])
    pixels += object["pixels"].get<int>();
  EXPECT_EQ(pixels, 64 * 48);  // something is everywhere in a shop
  EXPECT_EQ(contents_of(scratch.path() / "first.npy").size(), 128U + 4 * 64 * 48);
}

TEST(Render, ChannelsAndNoiseAreDrawnFromTheSeed) {
  const auto taken = [](const std::string& seed) {
    const ScratchFolder scratch;
    output_of({"render",
               shop(),
               "--camera",
               "aisle",
               "--size",
               "64x48",
               "--noise",
               "d435",
               "--seed",
               seed,
               "--channels",
               "channels",
               "--depth",
               "d.npy",
               "--quiet",
               "-o",
               "picture.png",
               "--categories",
               "categories.png"},
              scratch.path());
    for (const char* name : {"color",
                             "boxes",
                             "depth",
                             "instances",
                             "categories",
                             "normals",
                             "matter",
                             "noisy-color",
                             "noisy-depth",
                             "sheet"}) {
      EXPECT_TRUE(io::read_png(scratch.path() / "channels" / (std::string(name) + ".png")).ok())
          << name;
    }
    EXPECT_EQ(contents_of(scratch.path() / "picture.png"),
              contents_of(scratch.path() / "channels" / "noisy-color.png"));
    return contents_of(scratch.path() / "d.npy");
  };
  const std::string first = taken("1");
  EXPECT_EQ(taken("1"), first);
  EXPECT_NE(taken("2"), first);
}

TEST(Render, ACameraInAThingIsRefusedByItsName) {
  const json products = json_of({"query", shop(), "products", "--format", "json"});
  ASSERT_FALSE(products.empty());
  const json& item = products[0];
  const double x = item["x_m"], y = item["y_m"], z = item["z_m"];
  const ScratchFolder scratch;
  const Ran ran = marketgen_run({"render",
                                 shop(),
                                 "--from",
                                 fmt::format("{},{},{}", x, y, z + 0.01),
                                 "--at",
                                 "5,5,1",
                                 "-o",
                                 "inside.png"},
                                scratch.path());
  EXPECT_EQ(ran.status, 2);
  EXPECT_NE(ran.err.find("error[camera.inside_object] --from"), std::string::npos) << ran.err;
  EXPECT_NE(ran.err.find(item["id"].get<std::string>()), std::string::npos) << ran.err;
}

TEST(Render, ARobotInAFixtureIsRefusedWithAClearPlace) {
  const json fixtures = json_of({"query", shop(), "fixtures", "--format", "json"});
  const auto is_gondola = [](const json& row) {
    return row["kind"].get<std::string>().starts_with("gondola");  // of whatever make
  };
  const auto gondola = std::ranges::find_if(fixtures, is_gondola);
  ASSERT_NE(gondola, fixtures.end());
  const ScratchFolder scratch;
  const json& row = *gondola;
  const std::string place =
      fmt::format("{},{}", row["x_m"].get<double>(), row["y_m"].get<double>());
  const Ran ran = marketgen_run(
      {"render", shop(), "--robot", "realman-rm65@" + place, "-o", "robot.png"}, scratch.path());
  EXPECT_EQ(ran.status, 2);
  EXPECT_NE(ran.err.find("error[robot.blocked] --robot realman-rm65@" + place), std::string::npos)
      << ran.err;
  EXPECT_TRUE(fs::is_empty(scratch.path()));
}

// ---- export. ----

TEST(Export, GlbAndMjcfReadBack) {
  const ScratchFolder scratch;
  const json counts = manifest()["counts"];
  for (const char* format : {"glb", "mjcf"}) {
    const std::string file = std::string("shop.") + (std::string(format) == "glb" ? "glb" : "xml");
    const json summary = json_of(
        {"export", shop(), "--format", format, "-o", file, "--check", "--json"}, scratch.path());
    EXPECT_EQ(summary["products"], counts["products"]) << format;
    EXPECT_LT(summary["worst_position_error_m"].get<double>(), 1e-4) << format;
    EXPECT_EQ(summary["looks"], std::string(format) == "mjcf" ? counts["products"] : json(0));
    EXPECT_TRUE(fs::exists(scratch.path() / file));
  }
}

TEST(Export, UsdReadsBackWithOpenUsd) {
  const ScratchFolder scratch;
  const json counts = manifest()["counts"];
  const json summary =
      json_of({"export", shop(), "--format", "usd", "-o", "shop.usda", "--check", "--json"},
              scratch.path());
  EXPECT_EQ(summary["products"], counts["products"]);
  const json other = json_of(
      {"export", shop(), "--format", "glb", "-o", "shop.glb", "--check", "--json"}, scratch.path());
  EXPECT_EQ(summary["skus"], other["skus"]);
  EXPECT_LT(summary["worst_position_error_m"].get<double>(), 1e-4);
  for (const char* name : {"room.usda",
                           "fixtures.usda",
                           "goods.usda",
                           "lights.usda",
                           "products.usda",
                           "modules.usda",
                           "geometry.usdc",
                           "LICENCES.md"})
    EXPECT_TRUE(fs::exists(scratch.path() / "shop_assets" / name)) << name;
}

TEST(Export, MapsAndPlanogramsReadBack) {
  const ScratchFolder scratch;
  const json counts = manifest()["counts"];
  const json maps =
      json_of({"export", shop(), "--format", "nav2", "-o", "shop.yaml", "--check", "--json"},
              scratch.path());
  EXPECT_EQ(maps["fixtures"], counts["fixtures"]);
  EXPECT_GT(maps["waypoints"], 2);
  EXPECT_GT(maps["free_m2"], 10.0);
  for (const char* name : {"map.pgm", "keepout_mask.yaml", "speed_mask.pgm", "waypoints.yaml"})
    EXPECT_TRUE(fs::exists(scratch.path() / "shop_assets" / name)) << name;
  const json planogram =
      json_of({"export", shop(), "--format", "planogram", "-o", "shop.csv", "--check", "--json"},
              scratch.path());
  EXPECT_EQ(planogram["units"], counts["products"]);
}

// ---- assets, doctor, bench. ----

TEST(Assets, ListShowSearch) {
  const json list = json_of({"assets", "list", "--json"});
  EXPECT_GE(list["goods"], 80);
  EXPECT_GE(list["facilities"], 15);
  EXPECT_GE(list["archetypes"], 10);
  EXPECT_GE(list["by_category"].size(), 10U);
  EXPECT_EQ(list["rows"].size(),
            list["goods"].get<std::size_t>() + list["facilities"].get<std::size_t>() +
                list["materials"].get<std::size_t>());
  const std::string sku = list["rows"][0]["id"];
  EXPECT_EQ(json_of({"assets", "show", sku, "--json"})["sku"], sku);
  EXPECT_EQ(json_of({"assets", "show", "gondola", "--json"})["kind"], "gondola");
  EXPECT_NE(
      json_of({"assets", "search", "milk", "--json"})[0]["id"].get<std::string>().find("milk"),
      std::string::npos);
  const ScratchFolder scratch;
  output_of(
      {"assets", "show", sku, "--label", "label.png", "--picture", "picture.png", "--size", "64"},
      scratch.path());
  EXPECT_TRUE(io::read_png(scratch.path() / "label.png").ok());
  EXPECT_EQ(io::read_png(scratch.path() / "picture.png")->width, 64);
}

TEST(Doctor, FindsEverythingHere) {
  for (const json& finding : json_of({"doctor", "--json"}))
    EXPECT_NE(finding["state"], "missing") << finding;
  EXPECT_NE(output_of({"doctor"}).find("everything needed is there"), std::string::npos);
}

TEST(Doctor, SaysWhatMendsAMissingDataFolder) {
  const Ran ran = run({"env", "MARKETGEN_DATA=/no/such/rows", MARKETGEN_BINARY, "doctor"});
  EXPECT_EQ(ran.status, 1);
  EXPECT_NE(ran.out.find("MISSING"), std::string::npos);
  EXPECT_NE(ran.out.find("MARKETGEN_DATA"), std::string::npos);
}

// ---- grasps ----

// A can is held by the hand; the rates lie in the cache's database.
TEST(Grasps, ACanIsHeldAndItsRateKept) {
  const ScratchFolder scratch;
  const Ran ran = run({"env",
                       "MARKETGEN_CACHE=" + scratch.path().string(),
                       MARKETGEN_BINARY,
                       "grasps",
                       "beverages-cola-original-330ml",
                       "--tool",
                       "panda-hand",
                       "--tries",
                       "1",
                       "--json"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  const json report = json::parse(ran.out);
  EXPECT_EQ(report["products"], 1);
  EXPECT_EQ(report["rates"][0]["tries"][0]["end"], "held");
  EXPECT_EQ(report["shares"][0]["fit"]["number"], 1);
  EXPECT_TRUE(std::filesystem::exists(scratch.path() / "grasps" / "grasps.sqlite"));
}

TEST(Grasps, ErrorsNameTheNearest) {
  const auto error_of = [](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {MARKETGEN_BINARY, "grasps"});
    const Ran ran = run(arguments);
    EXPECT_EQ(ran.status, 2);
    return ran.err;
  };
  EXPECT_NE(error_of({"beverages-cola-original-330m"}).find("beverages-cola-original-330ml"),
            std::string::npos);
  EXPECT_NE(error_of({"--tool", "panda-hnd", "beverages-cola-original-330ml"})
                .find("did you mean \"panda-hand\""),
            std::string::npos);
  EXPECT_NE(error_of({"--setting", "stokced", "beverages-cola-original-330ml"})
                .find("did you mean \"stocked\""),
            std::string::npos);
}

TEST(Bench, HelpNamesTheBenchmarks) {
  const std::string help = output_of({"bench", "--help"});
  for (const char* name : {"generate", "load", "render", "physics"})
    EXPECT_NE(help.find(name), std::string::npos) << name;
}

}  // namespace
}  // namespace marketgen
