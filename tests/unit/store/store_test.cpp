// The store folder: whole or not there at all, and every byte accounted for.
#include "store/store.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <set>

#include "catalog/user_products.h"
#include "io/file.h"
#include "io/json.h"
#include "scene/fitted_shelves.h"
#include "support/hand_laid_shop.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;

// A folder of its own for every test, removed afterwards.
class StoreFolder : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    parent_ = fs::path(testing::TempDir()) /
              (std::string("marketgen_store_") + test->name() + "_" + std::to_string(getpid()));
    fs::remove_all(parent_);
    fs::create_directories(parent_);
  }
  void TearDown() override { fs::remove_all(parent_); }

  store::CreateOptions tiny(const std::string& name = "shop") const {
    store::CreateOptions options;
    options.folder = parent_ / name;
    options.brief.prompt = "a tiny corner shop with drinks and snacks";
    options.brief.size_mm = {8000, 6000};
    options.seed = 3;
    options.previews = false;
    return options;
  }

  store::Created create(const store::CreateOptions& options) const {
    auto created = store::create_store(options, committed_catalog());
    if (!created.ok()) fatal(to_string(created.error()).c_str());
    return std::move(created).value();
  }

  std::string code_of_create(const store::CreateOptions& options) const {
    const auto created = store::create_store(options, committed_catalog());
    return created.ok() ? "ok" : created.error().code;
  }

  // Every path below the parent folder.
  std::set<std::string> listing() const {
    std::set<std::string> paths;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(parent_))
      paths.insert(fs::relative(entry.path(), parent_).string());
    return paths;
  }

  std::string text_of(const fs::path& path) const {
    auto text = io::read_file(path);
    return text.ok() ? *text : "";
  }

  fs::path parent_;
};

// The time is in the plan, which makes the same store again; a flag takes its place.
TEST_F(StoreFolder, AtATimeIsThatOfItsPlan) {
  store::CreateOptions evening = tiny("evening");
  evening.brief.time = "saturday 17:30";
  const store::Created made = create(evening);
  EXPECT_NE(made.manifest.scene_hash, create(tiny("plain")).manifest.scene_hash);
  store::CreateOptions again = tiny("again");
  again.brief = {};
  again.plan_file = evening.folder / "plan.json";
  EXPECT_EQ(create(again).manifest.scene_hash, made.manifest.scene_hash);
  store::CreateOptions noon = again;
  noon.folder = parent_ / "noon";
  noon.brief.time = "Sat 12:00";
  EXPECT_NE(create(noon).manifest.scene_hash, made.manifest.scene_hash);
  noon.folder = parent_ / "none";
  noon.brief.time = "Sat 25:00";
  EXPECT_EQ(code_of_create(noon), "brief.bad_time");
}

// Words for an hour are ticked off like others; a flag wins over them.
TEST_F(StoreFolder, AtATimeOfItsWordsIsTickedOff) {
  store::CreateOptions words = tiny("words"), flag = tiny("flag");
  words.brief.prompt += " on Saturday evening";
  const store::Created made = create(words);
  const auto of_time = [](const audit::RequirementResult& r) {
    return r.text == "on Saturday evening";
  };
  const auto wish = std::ranges::find_if(made.report.requirements, of_time);
  ASSERT_NE(wish, made.report.requirements.end());
  EXPECT_TRUE(wish->met) << wish->why;
  flag.brief.time = "Sat 18:00";
  EXPECT_EQ(create(flag).manifest.scene_hash, made.manifest.scene_hash);
  words.folder = parent_ / "monday";
  words.brief.time = "Mon 08:00";
  const store::Created monday = create(words);
  EXPECT_EQ(std::ranges::count_if(monday.report.requirements, of_time), 0);
  EXPECT_EQ(monday.report.conflicts.size(), 1U);
  EXPECT_NE(monday.manifest.scene_hash, made.manifest.scene_hash);
}

// One step: the shelf that the file names holds its one row, all others hold what they would.
TEST_F(StoreFolder, AStoreAndTheShelvesOfAPlanogram) {
  create(tiny("plain"));
  const auto plain = store::open_store(parent_ / "plain", committed_catalog());
  ASSERT_TRUE(plain.ok());
  const scene::Facing& first = plain->scene.facings.front();
  const scene::SceneShelf& shelf = plain->scene.shelves[first.shelf];
  const std::string sku = plain->scene.catalog[first.sku].sku;
  const auto shelves_csv = [&](const std::string& fixture) {
    const fs::path file = parent_ / "shelves.csv";
    EXPECT_TRUE(io::write_file(file,
                               "fixture,side,shelf,sku,facings_wide\n" + fixture + "," +
                                   (shelf.side == 0 ? "front" : "back") + "," +
                                   std::to_string(shelf.level + 1) + "," + sku + ",1\n")
                    .ok());
    return file;
  };
  store::CreateOptions planned = tiny("planned");
  planned.planogram_file = shelves_csv(plain->scene.layout.fixtures[shelf.fixture].id);
  create(planned);
  const auto made = store::open_store(planned.folder, committed_catalog());
  ASSERT_TRUE(made.ok());
  ASSERT_TRUE(made->plan.planogram);
  EXPECT_EQ(made->plan.planogram->size(), 1U);
  std::map<std::uint32_t, std::vector<std::pair<std::string, int>>> before, after;
  for (const scene::Facing& facing : plain->scene.facings)
    before[facing.shelf].emplace_back(plain->scene.catalog[facing.sku].sku, facing.facings);
  for (const scene::Facing& facing : made->scene.facings)
    after[facing.shelf].emplace_back(made->scene.catalog[facing.sku].sku, facing.facings);
  before[first.shelf] = {{sku, 1}};
  EXPECT_EQ(after, before);
  planned.folder = parent_ / "wrong";
  planned.planogram_file = shelves_csv("moon/run-1/module-1");
  EXPECT_EQ(code_of_create(planned), "plan.unknown_reference");
  EXPECT_FALSE(fs::exists(planned.folder));
}

// What is drawn for every axis, each by itself.
struct DrawnAxes {
  std::string layout, planogram, fill, disorder, prices;
  friend bool operator==(const DrawnAxes&, const DrawnAxes&) = default;
};

DrawnAxes axes_of(const scene::Scene& scene) {
  DrawnAxes drawn;
  layout::Layout layout = scene::with_even_boards(scene.layout);
  for (layout::Fixture& fixture : layout.fixtures)
    fixture.levels = 0;  // boards follow from the goods: they are the planogram's
  drawn.layout = io::write_json_line(layout);
  for (const scene::Facing& facing : scene.facings) {
    drawn.planogram += fmt::format("{} {} {:.4f} {}, ",
                                   facing.shelf,
                                   scene.catalog[facing.sku].sku,
                                   facing.x_m,
                                   facing.facings);
    for (std::uint32_t i = 0; i < facing.product_count; ++i) {
      const scene::SceneProduct& item = scene.products[facing.first_product + i];
      const bool strange = (item.flags & scene::product_misplaced) != 0;
      drawn.fill += fmt::format("{:.4f} {:.4f}, ", item.position_m[0], item.position_m[1]);
      drawn.disorder += strange ? fmt::format("{} {}, ", facing.first_product + i, item.sku) : "";
    }
  }
  for (const scene::PriceLabel& label : scene.price_labels)
    drawn.prices += fmt::format("{} {}, ", label.promotion, label.price_cents);
  return drawn;
}

// A shop where every axis draws something. Its fixtures are plain: with a full outfit another
// layout seed has other makes, and so other shelves to fill.
store::CreateOptions untidy(store::CreateOptions options, const plan::Plan& plan) {
  plan::Plan messy = plan;
  messy.outfit = plan::Outfit::plain;
  for (plan::Zone& zone : messy.zones) {
    zone.stock.misplaced = 0.1;
    zone.stock.out_of_stock = 0.1;
  }
  const fs::path file = options.folder.string() + "-plan.json";
  if (const auto written = io::write_file(file, io::write_json(messy)); !written.ok())
    fatal(to_string(written.error()).c_str());
  options.brief = {};
  options.plan_file = file;
  return options;
}

TEST_F(StoreFolder, AnAxisWithASeedDrawsWhatAStoreOfThatSeedDraws) {
  create(tiny("plain"));
  const plan::Plan plan = store::open_store(parent_ / "plain", committed_catalog())->plan;
  const auto drawn = [&](const char* name, std::uint64_t seed, const plan::Vary& vary) {
    store::CreateOptions options = untidy(tiny(name), plan);
    options.seed = seed;
    options.brief.vary = vary;
    create(options);
    return axes_of(store::open_store(parent_ / name, committed_catalog())->scene);
  };
  const DrawnAxes three = drawn("three", 3, {}), nine = drawn("nine", 9, {});
  plan::Vary all;
  all.layout = all.planogram = all.fill = all.disorder = all.prices = 9;
  EXPECT_EQ(drawn("all", 3, all), nine);
  ASSERT_NE(three.planogram, nine.planogram);
  plan::Vary fill;
  fill.fill = 9;
  const DrawnAxes filled = drawn("fill", 3, fill);
  EXPECT_EQ(filled.layout, three.layout);
  EXPECT_EQ(filled.planogram, three.planogram);
  EXPECT_EQ(filled.prices, three.prices);
  EXPECT_NE(filled.fill, three.fill);
  plan::Vary prices;
  prices.prices = 9;
  DrawnAxes priced = drawn("prices", 3, prices);
  EXPECT_NE(priced.prices, three.prices);
  priced.prices = three.prices;
  EXPECT_EQ(priced, three);
  plan::Vary disorder;
  disorder.disorder = 9;
  DrawnAxes messed = drawn("disorder", 3, disorder);
  EXPECT_NE(messed.disorder, three.disorder);
  messed.disorder = three.disorder;
  EXPECT_EQ(messed, three);
  plan::Vary planogram;
  planogram.planogram = 9;
  const DrawnAxes others = drawn("planogram", 3, planogram);
  EXPECT_EQ(others.planogram, nine.planogram);
  EXPECT_EQ(others.layout, three.layout);
}

// The plan keeps the axes: it makes the store again, and a flag takes the place of an axis.
TEST_F(StoreFolder, AxesAreInThePlan) {
  store::CreateOptions options = tiny("varied");
  options.brief.vary.emplace();
  options.brief.vary->layout = 5;
  options.brief.vary->fill = 6;
  const store::Created made = create(options);
  store::CreateOptions again = tiny("again");
  again.brief = {};
  again.plan_file = options.folder / "plan.json";
  EXPECT_EQ(create(again).manifest.scene_hash, made.manifest.scene_hash);
  const auto store = store::open_store(options.folder, committed_catalog());
  EXPECT_EQ(
      scene::scene_hash(
          store::scene_of_plan(store->plan, committed_catalog(), store->manifest.seed).value()),
      made.manifest.scene_hash);
  EXPECT_TRUE(store::follows_from_plan(*store, committed_catalog()).value());
  again.folder = parent_ / "other-fill";
  again.brief.vary.emplace();
  again.brief.vary->fill = 7;
  create(again);
  const auto other = store::open_store(again.folder, committed_catalog());
  EXPECT_EQ(other->plan.vary->layout, 5U);
  EXPECT_EQ(other->plan.vary->fill, 7U);
  EXPECT_NE(other->manifest.scene_hash, made.manifest.scene_hash);
}

TEST(Vary, SaysWhatIsWrong) {
  for (const auto& [text, says] : std::vector<std::pair<std::string, std::string>>{
           {"", "there is no axis \"\""},
           {"fil=3", "did you mean \"fill\"?"},
           {"fill", "gives fill no seed"},
           {"fill=", "gives fill no seed"},
           {"fill=-1", "gives fill no seed"},
           {"fill=3x", "gives fill no seed"},
           {"fill=18446744073709551616", "gives fill no seed"},
           {"layout=2", "layout is given twice"}}) {
    plan::Vary vary;
    vary.layout = 1;
    const auto added = plan::add_vary(vary, text, "brief.bad_vary", "--vary");
    ASSERT_FALSE(added.ok()) << text;
    EXPECT_EQ(added.error().code, "brief.bad_vary");
    EXPECT_NE(added.error().message.find(says), std::string::npos) << added.error().message;
  }
  plan::Vary vary;
  EXPECT_TRUE(plan::add_vary(vary, "fill=18446744073709551615", "x", "y").ok());
  EXPECT_EQ(vary.fill, 18446744073709551615U);
}

TEST_F(StoreFolder, CreateOpenVerify) {
  const store::Created created = create(tiny());
  EXPECT_EQ(listing(),
            (std::set<std::string>{"shop",
                                   "shop/layout.json",
                                   "shop/plan.json",
                                   "shop/planogram.csv",
                                   "shop/report.json",
                                   "shop/scene.bin",
                                   "shop/store.json"}));
  const auto verified = store::verify_store(parent_ / "shop", committed_catalog());
  EXPECT_TRUE(verified.ok()) << to_string(verified.error());
  const auto store = store::open_store(parent_ / "shop", committed_catalog());
  ASSERT_TRUE(store.ok()) << to_string(store.error());
  EXPECT_EQ(store->manifest.seed, 3U);
  EXPECT_EQ(store->manifest.scene_hash, scene::scene_hash(store->scene));
  EXPECT_EQ(store->manifest.look_hash, scene::look_hash(store->scene));
  EXPECT_EQ(store->manifest.counts.products, store->scene.products.size());
  EXPECT_EQ(store->manifest.counts.fixtures, store->scene.fixtures.size());
  EXPECT_GT(store->scene.products.size(), 200U);
  EXPECT_EQ(store->manifest.bounds.high_m,
            (std::array<double, 3>{8, 6, store->plan.shell.ceiling_mm * 1e-3}));
  EXPECT_EQ(store->manifest.brief.prompt, tiny().brief.prompt);
  EXPECT_EQ(created.manifest.scene_hash, store->manifest.scene_hash);
}

TEST_F(StoreFolder, ManifestNamesEveryOtherFileButTheReport) {
  const store::Created created = create(tiny());
  std::vector<std::string> paths;
  for (const store::FileDigest& file : created.manifest.files) {
    paths.push_back(file.path);
    EXPECT_EQ(file.bytes, fs::file_size(parent_ / "shop" / file.path));
    EXPECT_EQ(file.sha256, io::sha256_hex(text_of(parent_ / "shop" / file.path)));
  }
  EXPECT_EQ(paths,
            (std::vector<std::string>{"layout.json", "plan.json", "planogram.csv", "scene.bin"}));
}

TEST_F(StoreFolder, ReportHoldsMetricsAndTimes) {
  create(tiny());
  const auto report = store::read_report(parent_ / "shop");
  ASSERT_TRUE(report.ok()) << to_string(report.error());
  EXPECT_EQ(report->metrics.COL, 0);
  EXPECT_EQ(report->metrics.OOB, 0U);
  EXPECT_GT(report->metrics.DENS, 10);
  EXPECT_GT(report->metrics.fill, 0.5);
  EXPECT_FALSE(report->metrics.STB.has_value());
  std::vector<std::string> stages;
  for (const store::StageTiming& t : report->timing_s)
    stages.push_back(t.stage);
  EXPECT_EQ(stages,
            (std::vector<std::string>{"plan", "repair", "layout", "scene", "audit", "save"}));
  EXPECT_GT(report->peak_rss_mb, 1);
}

TEST_F(StoreFolder, AChangedByteIsSeenInEveryFile) {
  create(tiny());
  for (const char* name : {"layout.json", "plan.json", "planogram.csv", "scene.bin"}) {
    const fs::path path = parent_ / "shop" / name;
    const std::string good = text_of(path);
    std::string bad = good;
    bad[bad.size() / 2] ^= 1;
    std::ofstream(path, std::ios::binary) << bad;
    const auto verified = store::verify_store(parent_ / "shop", committed_catalog());
    ASSERT_FALSE(verified.ok()) << name;
    EXPECT_EQ(verified.error().code, "store.changed") << name;
    EXPECT_NE(verified.error().where.find(name), std::string::npos) << verified.error().where;
    std::ofstream(path, std::ios::binary) << good;
  }
  EXPECT_TRUE(store::verify_store(parent_ / "shop", committed_catalog()).ok());
}

// Opening looks at what it reads: a number that was changed into another is no fault of format.
TEST_F(StoreFolder, OpeningRefusesAChangedFile) {
  create(tiny());
  for (const char* name : {"plan.json", "scene.bin"}) {
    const fs::path path = parent_ / "shop" / name;
    const std::string good = text_of(path);
    std::string bad = good;
    bad[bad.size() / 2] ^= 1;
    std::ofstream(path, std::ios::binary) << bad;
    const auto store = store::open_store(parent_ / "shop", committed_catalog());
    ASSERT_FALSE(store.ok()) << name;
    EXPECT_EQ(store.error().code, "store.changed") << name;
    EXPECT_NE(store.error().where.find(name), std::string::npos) << store.error().where;
    EXPECT_NE(store.error().message.find("restore the file or generate the store again"),
              std::string::npos);
    EXPECT_EQ(store::open_store_scene(parent_ / "shop").ok(), name == std::string("plan.json"));
    std::ofstream(path, std::ios::binary) << good;
  }
  EXPECT_TRUE(store::open_store(parent_ / "shop", committed_catalog()).ok());
}

TEST_F(StoreFolder, OpeningNeedsWhatTheManifestLists) {
  create(tiny());
  const fs::path path = parent_ / "shop/store.json";
  std::string text = text_of(path);
  const std::size_t at = text.find("\"scene.bin\"");
  ASSERT_NE(at, std::string::npos);
  text.replace(at, 11, "\"other.bin\"");
  std::ofstream(path) << text;
  const auto scene = store::open_store_scene(parent_ / "shop");
  ASSERT_FALSE(scene.ok());
  EXPECT_EQ(scene.error().code, "store.changed");
  EXPECT_NE(scene.error().message.find("names no scene.bin"), std::string::npos);
}

TEST_F(StoreFolder, AMissingFileIsAChange) {
  create(tiny());
  fs::remove(parent_ / "shop/planogram.csv");
  const auto verified = store::verify_store(parent_ / "shop", committed_catalog());
  ASSERT_FALSE(verified.ok());
  EXPECT_EQ(verified.error().code, "store.changed");
  EXPECT_NE(verified.error().where.find("planogram.csv"), std::string::npos);
}

TEST_F(StoreFolder, AManifestThatWasEdited) {
  create(tiny());
  const fs::path path = parent_ / "shop/store.json";
  std::string text = text_of(path);
  const std::size_t hash = text.find("\"scene_hash\": \"") + 15;
  text[hash] = text[hash] == '0' ? '1' : '0';
  std::ofstream(path) << text;
  EXPECT_EQ(store::verify_store(parent_ / "shop", committed_catalog()).error().code,
            "store.changed");
  const std::size_t file = text.find("\"layout.json\"");
  text.replace(file, 13, "\"../shop.json\"");
  std::ofstream(path) << text;
  const auto verified = store::verify_store(parent_ / "shop", committed_catalog());
  ASSERT_FALSE(verified.ok());
  EXPECT_EQ(verified.error().code, "store.changed");
  EXPECT_NE(verified.error().message.find("outside the store"), std::string::npos);
}

TEST_F(StoreFolder, NotAStore) {
  EXPECT_EQ(store::open_store(parent_, committed_catalog()).error().code, "store.not_a_store");
  EXPECT_EQ(store::open_store(parent_ / "nothing", committed_catalog()).error().code,
            "input.not_found");
  std::ofstream(parent_ / "store.json") << "{\"schema\": \"market-plan/1\"}";
  EXPECT_EQ(store::open_store(parent_, committed_catalog()).error().code, "json.wrong_schema");
}

TEST_F(StoreFolder, AnExistingFolderIsNotTouched) {
  fs::create_directories(parent_ / "shop");
  std::ofstream(parent_ / "shop/mine.txt") << "precious";
  const auto before = listing();
  EXPECT_EQ(code_of_create(tiny()), "store.exists");
  EXPECT_EQ(listing(), before);
  EXPECT_EQ(text_of(parent_ / "shop/mine.txt"), "precious");
}

TEST_F(StoreFolder, AnEmptyFolderIsTaken) {
  fs::create_directories(parent_ / "shop");
  EXPECT_EQ(code_of_create(tiny()), "ok");
}

TEST_F(StoreFolder, NothingIsLeftBehindByFailure) {
  std::map<std::string, store::CreateOptions> failures;
  failures["brief.empty"] = tiny();
  failures["brief.empty"].brief.prompt = " \n";
  failures["input.not_found"] = tiny();
  failures["input.not_found"].plan_file = parent_ / "no-plan.json";
  failures["catalog.unknown_kind"] = tiny();
  failures["catalog.unknown_kind"].brief.style = "baroque";
  for (const auto& [code, options] : failures) {
    EXPECT_EQ(code_of_create(options), code);
    EXPECT_TRUE(listing().empty()) << code << " left " << *listing().begin();
  }
}

TEST_F(StoreFolder, NothingIsLeftBehindWhenTheFolderCannotBeMade) {
  std::ofstream(parent_ / "file") << "x";
  const auto before = listing();
  store::CreateOptions options = tiny();
  options.folder = parent_ / "file/shop";
  EXPECT_EQ(code_of_create(options), "io.cannot_write");
  EXPECT_EQ(listing(), before);
  options.folder = "/proc/marketgen/shop";
  EXPECT_EQ(code_of_create(options), "io.cannot_write");
}

// A plan in which an aisle item is pinned into the wall: a hard rule is broken whatever repair
// does.
TEST_F(StoreFolder, StrictRefusesHardViolationsAndLeavesNothing) {
  create(tiny());
  auto plan =
      plan::read_plan(text_of(parent_ / "shop/plan.json"), "plan.json", committed_catalog());
  ASSERT_TRUE(plan.ok());
  plan->placements = {{committed_catalog().products.front().sku, {0, 3, 0}, 0}};
  std::ofstream(parent_ / "plan.json") << io::write_json(*plan);
  const auto before = listing();
  store::CreateOptions options = tiny("strict");
  options.brief = {};
  options.plan_file = parent_ / "plan.json";
  options.strict = true;
  EXPECT_EQ(code_of_create(options), "layout.violation");
  EXPECT_EQ(listing(), before);
  options.strict = false;
  EXPECT_EQ(code_of_create(options), "ok");
}

TEST_F(StoreFolder, TheSameBriefAndSeedGiveTheSameBytes) {
  create(tiny("one"));
  create(tiny("two"));
  store::CreateOptions other = tiny("three");
  other.seed = 4;
  create(other);
  for (const char* name :
       {"layout.json", "plan.json", "planogram.csv", "scene.bin", "store.json"}) {
    const std::string one = text_of(parent_ / "one" / name);
    EXPECT_FALSE(one.empty()) << name;
    EXPECT_EQ(one, text_of(parent_ / "two" / name)) << name;
  }
  EXPECT_NE(text_of(parent_ / "one/scene.bin"), text_of(parent_ / "three/scene.bin"));
}

TEST_F(StoreFolder, TheSavedPlanMakesTheSameStoreAgain) {  // what repair mended stays mended
  const store::Created first = create(tiny());
  store::CreateOptions again = tiny("again");
  again.brief = {};
  again.plan_file = parent_ / "shop/plan.json";
  const store::Created second = create(again);
  EXPECT_EQ(second.manifest.scene_hash, first.manifest.scene_hash);
  EXPECT_EQ(text_of(parent_ / "again/plan.json"), text_of(parent_ / "shop/plan.json"));
  EXPECT_TRUE(second.report.repairs.empty());
}

// A store keeps the rows of the user's own that it was made with, so that it can be made again from
// its plan: by a file of episodes, on a machine that has the committed rows only.
TEST_F(StoreFolder, IsMadeAgainWithTheRowsOfOnesOwnThatItKeeps) {
  catalog::Product own;
  own.sku = "own-lemonade";
  own.ean = "2999999999991";
  own.name = "Lemonade";
  own.category = "beverages";
  own.subcategory = "soft drinks";
  own.archetype = "can";
  own.size_mm = {66, 66, 115};
  own.mass_kg = 0.35;
  const catalog::Catalog catalog = catalog::with_own_products(committed_catalog(), {own});
  EXPECT_NE(catalog.content_hash, committed_catalog().content_hash);
  const auto created = store::create_store(tiny(), catalog);
  ASSERT_TRUE(created.ok()) << to_string(created.error());
  const auto store = store::open_store(parent_ / "shop", committed_catalog());
  ASSERT_TRUE(store.ok()) << to_string(store.error());
  ASSERT_TRUE(store->manifest.own.has_value());
  ASSERT_EQ(store->manifest.own->size(), 1U);
  EXPECT_NE(std::ranges::find(store->scene.catalog, own.sku, &catalog::Product::sku),
            store->scene.catalog.end());
  const auto again = store::scene_of_plan(
      store->plan, catalog::with_own_products(committed_catalog(), *store->manifest.own), 3);
  ASSERT_TRUE(again.ok()) << to_string(again.error());
  EXPECT_EQ(scene::scene_hash(*again), store->manifest.scene_hash);
  const auto without = store::scene_of_plan(store->plan, committed_catalog(), 3);
  ASSERT_TRUE(without.ok());
  EXPECT_NE(scene::scene_hash(*without), store->manifest.scene_hash);
  EXPECT_FALSE(create(tiny("plain")).manifest.own.has_value());
}

// Small shops have no floor for a checkout lane: they take money over a counter.
TEST_F(StoreFolder, TheSmallestShopsHaveAPlaceToPay) {
  constexpr std::array<std::array<int, 2>, 5> sizes_mm{
      {{5000, 5000}, {6500, 4600}, {8000, 5000}, {8900, 5600}, {9800, 6100}}};
  for (const auto& size : sizes_mm) {
    store::CreateOptions options = tiny("shop-" + std::to_string(size[0]));
    options.brief.prompt = "a kiosk";
    options.brief.size_mm = size;
    const store::Created created = create(options);
    for (const layout::Violation& broken : created.report.rules)
      EXPECT_NE(broken.severity, layout::Severity::hard) << size[0] << ": " << broken.message;
    EXPECT_GT(created.manifest.counts.products, 300U) << size[0];
  }
}

}  // namespace
}  // namespace marketgen
