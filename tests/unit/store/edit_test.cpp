// Editing a store: a new folder, in which everything that the patches did not name is as it was, to
// the last bit.
#include "store/edit.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <map>
#include <set>

#include "io/file.h"
#include "io/json.h"
#include "plan/bsp.h"
#include "scene/placements.h"
#include "store/edit_words.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;

// Written here and not made from words, so that the tests do not depend on what words mean.
constexpr const char* shop_text = R"({
  "schema": "market-plan/1", "name": "Corner", "profile": "supermarket-eu",
  "shell": {"width_mm": 16000, "depth_mm": 13000,
    "openings": [{"id": "in", "kind": "entrance", "wall": "south", "center": 0.2, "width_mm": 2000},
                 {"id": "out", "kind": "exit", "wall": "south", "center": 0.7, "width_mm": 2000}]},
  "nodes": [{"id": "root", "split": "y", "ratio": 0.35, "gap_mm": 1800, "children": ["front", "back"]},
            {"id": "front", "zone": "tills"},
            {"id": "back", "split": "x", "ratio": 0.5, "gap_mm": 2000, "children": ["west", "east"]},
            {"id": "west", "split": "y", "ratio": 0.5, "gap_mm": 1800, "children": ["w1", "w2"]},
            {"id": "east", "split": "y", "ratio": 0.5, "gap_mm": 1800, "children": ["e1", "e2"]},
            {"id": "w1", "zone": "snacks"}, {"id": "w2", "zone": "dairy"},
            {"id": "e1", "zone": "canned"}, {"id": "e2", "zone": "drinks"}],
  "zones": [{"id": "tills", "type": "checkout", "fixture": {"kind": "checkout_lane", "count": 2}},
            {"id": "snacks", "type": "snacks", "fixture": {"kind": "gondola", "levels": 5}},
            {"id": "dairy", "type": "dairy", "fixture": {"kind": "multideck"}},
            {"id": "canned", "type": "canned", "fixture": {"kind": "gondola", "levels": 5}},
            {"id": "drinks", "type": "beverages", "fixture": {"kind": "gondola", "levels": 5}}]
})";

const fs::path& parent() {
  static const fs::path folder = [] {
    fs::path made = fs::path(testing::TempDir()) / ("marketgen_edit_" + std::to_string(getpid()));
    fs::create_directories(made);
    return made;
  }();
  return folder;
}

const store::Store& shop() {
  static const store::Store made = [] {
    const fs::path plan = parent() / "plan.json";
    EXPECT_TRUE(io::write_file(plan, shop_text).ok());
    store::CreateOptions options;
    options.folder = parent() / "shop";
    options.plan_file = plan;
    options.seed = 7;
    options.previews = false;
    const auto created = store::create_store(options, committed_catalog());
    if (!created.ok()) fatal(to_string(created.error()).c_str());
    auto store = store::open_store(options.folder, committed_catalog());
    if (!store.ok()) fatal(to_string(store.error()).c_str());
    return std::move(store).value();
  }();
  return made;
}

plan::PatchSet patches(const std::string& text) {
  auto set = plan::read_patches(R"({"schema": "market-patch/1", "patches": [)" + text + "]}", "p");
  if (!set.ok()) fatal(to_string(set.error()).c_str());
  return std::move(set).value();
}

fs::path& last_folder() {  // that was edited into
  static fs::path folder;
  return folder;
}

Result<store::Edited> edited(const store::Store& from, const std::string& text) {
  static int number = 0;
  store::EditOptions options;
  options.folder = parent() / ("edit-" + std::to_string(++number));
  options.step.patches = patches(text);
  options.step.source = "p.json";
  options.previews = false;
  last_folder() = options.folder;
  return store::edit_store(from, options, committed_catalog());
}

store::Store opened_last(const store::Edited& edit) {
  auto store = store::open_store(last_folder(), committed_catalog());
  if (!store.ok()) fatal(to_string(store.error()).c_str());
  EXPECT_EQ(store->manifest.scene_hash, edit.created.manifest.scene_hash);
  return std::move(store).value();
}

// Every fixture and every product of the zones that are not in `but`, bit for bit.
std::map<std::string, std::string> things(const scene::Scene& scene,
                                          const std::set<std::string>& but) {
  std::map<std::string, std::string> rows;
  for (const layout::Fixture& fixture : scene.layout.fixtures) {
    if (!but.contains(fixture.zone)) rows[fixture.id] = io::write_json_line(fixture);
  }
  for (std::uint32_t i = 0; i < scene.products.size(); ++i) {
    const scene::SceneProduct& item = scene.products[i];
    if (item.facing == scene::no_facing) continue;
    const auto& shelf = scene.shelves[scene.facings[item.facing].shelf];
    if (but.contains(scene.layout.fixtures[shelf.fixture].zone)) continue;
    std::string bits(reinterpret_cast<const char*>(item.position_m.data()), sizeof item.position_m);
    bits.append(reinterpret_cast<const char*>(item.rotation_wxyz.data()),
                sizeof item.rotation_wxyz);
    rows[scene::product_id(scene, i)] = scene.catalog[item.sku].sku + bits;
  }
  return rows;
}

// One patch of each operation, and the zones that it names or that have to give way.
struct Example {
  const char* operation;
  const char* patch;
  std::set<std::string> changes;
};
const std::vector<Example>& examples() {
  static const std::vector<Example> all = {
      {"set_ratio", R"({"set_ratio": {"node": "west", "ratio": 0.55}})", {"snacks", "dairy"}},
      {"set_axis",
       R"({"set_axis": {"node": "west", "split": "x"}}, {"set_gap": {"node": "west", "gap_mm": 1200}})",
       {"snacks", "dairy"}},
      {"set_gap", R"({"set_gap": {"node": "east", "gap_mm": 2000}})", {"canned", "drinks"}},
      {"swap_leaves", R"({"swap_leaves": {"a": "dairy", "b": "drinks"}})", {"dairy", "drinks"}},
      {"move_leaf",
       R"({"move_leaf": {"zone": "snacks", "beside": "dairy", "side": "north", "share": 0.5}})",
       {"snacks", "dairy"}},
      {"split_leaf",
       R"({"split_leaf": {"zone": "canned", "part": "sauces", "side": "east", "gap_mm": 1500}})",
       {"canned", "sauces"}},
      {"merge", R"({"merge": {"zone": "drinks", "into": "canned"}})", {"canned", "drinks"}},
      {"add_zone",
       R"({"add_zone": {"zone": {"id": "wine", "type": "alcohol"}, "beside": "drinks", "side": "west",
           "share": 0.5, "gap_mm": 1500}})",
       {"drinks", "wine"}},
      {"drop_zone", R"({"drop_zone": {"zone": "snacks"}})", {"snacks", "dairy"}},
      {"set_fixture", R"({"set_fixture": {"zone": "canned", "levels": 4}})", {"canned"}},
      {"set_stock", R"({"set_stock": {"zone": "dairy", "fill": 0.4}})", {"dairy"}},
      {"move_opening", R"({"move_opening": {"opening": "out", "center": 0.75}})", {"tills"}},
      {"add_opening",
       R"({"add_opening": {"opening": {"id": "way-out", "kind": "emergency", "wall": "north", "center": 0.2,
           "width_mm": 1200}}})",
       {"dairy"}},
      {"set_look", R"({"set_look": {"floor": "concrete-polished", "light_kelvin": 3000}})", {}},
      {"set_shell", R"({"set_shell": {"ceiling_mm": 4200}})", {}},
      {"set_time",
       R"({"set_time": {"time": "Sat 17:30"}})",
       {"snacks", "dairy", "canned", "drinks", "tills"}},
      {"set_relation", R"({"set_relation": {"kind": "near", "a": "dairy", "b": "north"}})", {}},
      {"set_override",
       R"({"set_override": {"fixture": "canned/run-1/module-1", "field": "levels", "value": "3"}})",
       {"canned"}},
      {"stock_shelves",
       R"({"stock_shelves": {"shelves": [{"fixture": "canned/run-1/module-1", "shelf": 3,
           "blocks": [{"sku": "canned-sweetcorn-crisp-340g", "facings": 4}]}]}})",
       {"canned"}},
      {"swap_blocks",
       R"({"swap_blocks": {"a": {"fixture": "canned/run-1/module-1", "shelf": 3, "position": 1},
                           "b": {"fixture": "canned/run-1/module-1", "shelf": 3, "position": 2}}})",
       {"canned"}},
  };
  return all;
}

TEST(Edits, EveryOperationHasAnExample) {
  std::vector<std::string> listed, shown;
#define PLAN_PATCH(name, Type, what) listed.emplace_back(#name);
#include "plan/patches.inc"
#undef PLAN_PATCH
  for (const Example& example : examples())
    shown.emplace_back(example.operation);
  EXPECT_EQ(shown, listed);
}

TEST(Edits, LeaveTheRestAsItWasToTheLastBit) {
  for (const Example& example : examples()) {
    const auto edit = edited(shop(), example.patch);
    ASSERT_TRUE(edit.ok()) << example.operation << ": " << to_string(edit.error());
    const store::Store now = opened_last(*edit);
    EXPECT_EQ(things(now.scene, example.changes), things(shop().scene, example.changes))
        << example.operation;
    EXPECT_GT(edit->changes.products.kept, 0U) << example.operation;
    EXPECT_EQ(now.manifest.edits->size(), 1U);
    EXPECT_EQ(now.manifest.edits->front().from, shop().manifest.scene_hash);
    EXPECT_TRUE(store::verify_store(now.folder, committed_catalog()).ok()) << example.operation;
  }
}

// A lane more, a shelf more and a pin change single fixtures; the rest of their zone stands where
// it stood.
TEST(Edits, KeepTheFixturesOfAZoneWhoseShelvesChange) {
  const auto edit = edited(shop(), R"({"set_fixture": {"zone": "canned", "levels": 4}})");
  ASSERT_TRUE(edit.ok()) << to_string(edit.error());
  const store::Store now = opened_last(*edit);
  std::size_t modules = 0;
  for (const layout::Fixture& old : shop().scene.layout.fixtures) {
    if (old.zone != "canned" || old.kind != "gondola") continue;
    const layout::Fixture* found = layout::find_fixture(now.scene.layout, old.id);
    ASSERT_NE(found, nullptr) << old.id;
    EXPECT_EQ(found->x_mm, old.x_mm);
    EXPECT_EQ(found->y_mm, old.y_mm);
    EXPECT_EQ(found->levels, 4);
    ++modules;
  }
  EXPECT_GT(modules, 0U);
}

// Pinned, pinned elsewhere with other edits between, set free: the plan alone says where it stands.
TEST(Edits, MoveARunAndLetItGoAgain) {
  const std::vector<layout::Fixture>& fixtures = shop().scene.layout.fixtures;
  const auto old = std::ranges::find_if(fixtures, [](const layout::Fixture& fixture) {
    return fixture.zone == "canned" && fixture.kind == "gondola" && fixture.sides == 2;
  });
  ASSERT_NE(old, fixtures.end());
  const auto pin = [&](int by) {
    return R"({"set_override": {"fixture": ")" + old->id + R"(", "field": "x_mm", "value": ")" +
           std::to_string(old->x_mm + by) + "\"}}";
  };
  const auto x_in = [&](const store::Store& store) {
    const layout::Fixture* now = layout::find_fixture(store.scene.layout, old->id);
    return now == nullptr ? -1 : now->x_mm - old->x_mm;
  };
  const auto first = edited(shop(), pin(30));
  ASSERT_TRUE(first.ok()) << to_string(first.error());
  const store::Store moved = opened_last(*first);
  EXPECT_EQ(x_in(moved), 30);
  EXPECT_EQ(things(moved.scene, {"canned"}), things(shop().scene, {"canned"}));
  EXPECT_TRUE(*store::follows_from_plan(moved, committed_catalog()));

  const auto second = edited(moved, R"({"set_stock": {"zone": "snacks", "fill": 0.5}})");
  ASSERT_TRUE(second.ok()) << to_string(second.error());
  EXPECT_EQ(x_in(opened_last(*second)), 30) << "it is not moved twice";
  const auto third = edited(moved, pin(-20));
  ASSERT_TRUE(third.ok()) << to_string(third.error());
  EXPECT_EQ(x_in(opened_last(*third)), -20);
  const auto back =
      edited(moved, R"({"set_override": {"fixture": ")" + old->id + R"(", "field": "x_mm"}})");
  ASSERT_TRUE(back.ok()) << to_string(back.error());
  EXPECT_EQ(back->created.manifest.scene_hash, shop().manifest.scene_hash);
}

// What a store made at that hour has, and without one what it had.
TEST(Edits, ShowAnotherHourAndTheFirstAgain) {
  const auto evening = edited(shop(), R"({"set_time": {"time": "Sat 18:00"}})");
  ASSERT_TRUE(evening.ok()) << to_string(evening.error());
  const store::Store late = opened_last(*evening);
  EXPECT_GT(evening->changes.products.gone, 100U);
  EXPECT_EQ(evening->changes.fixtures.moved, 0U);
  EXPECT_TRUE(*store::follows_from_plan(late, committed_catalog()));
  const auto restocked = edited(late, R"({"set_time": {}})");
  ASSERT_TRUE(restocked.ok()) << to_string(restocked.error());
  EXPECT_EQ(restocked->created.manifest.scene_hash, shop().manifest.scene_hash);
}

TEST(Edits, FollowOneAnother) {
  const auto first = edited(shop(), R"({"swap_leaves": {"a": "dairy", "b": "drinks"}})");
  ASSERT_TRUE(first.ok()) << to_string(first.error());
  const store::Store between = opened_last(*first);
  const auto second = edited(between, R"({"set_stock": {"zone": "snacks", "fill": 0.5}})");
  ASSERT_TRUE(second.ok()) << to_string(second.error());
  const store::Store now = opened_last(*second);
  EXPECT_EQ(now.manifest.edits->size(), 2U);
  EXPECT_EQ(now.manifest.brief.prompt, shop().manifest.brief.prompt);
  EXPECT_EQ(things(now.scene, {"snacks"}), things(between.scene, {"snacks"}));
  const std::set<std::string> both{"snacks", "dairy", "drinks"};
  EXPECT_EQ(things(now.scene, both), things(shop().scene, both));
}

// The plan alone makes the store again, and the same swap takes it back.
TEST(Edits, SwapTwoBlocksOfProducts) {
  const scene::Facing& first = shop().scene.facings.front();
  const scene::SceneShelf& shelf = shop().scene.shelves[first.shelf];
  const std::string on = R"({"fixture": ")" + shop().scene.layout.fixtures[shelf.fixture].id +
                         R"(", "shelf": )" + std::to_string(shelf.level + 1) + R"(, "position": )";
  const std::string swap = R"({"swap_blocks": {"a": )" + on + R"(1}, "b": )" + on + "2}}}";
  const auto edit = edited(shop(), swap);
  ASSERT_TRUE(edit.ok()) << to_string(edit.error());
  const store::Store now = opened_last(*edit);
  EXPECT_EQ(now.scene.catalog[now.scene.facings[0].sku].sku,
            shop().scene.catalog[shop().scene.facings[1].sku].sku);
  EXPECT_EQ(now.manifest.edits->front().patches.at(0).swap_blocks->b.position, 2);
  EXPECT_TRUE(*store::follows_from_plan(now, committed_catalog()));
  store::CreateOptions again;
  again.folder = parent() / "swapped-again";
  again.plan_file = now.folder / "plan.json";
  again.seed = 7;
  again.previews = false;
  const auto made = store::create_store(again, committed_catalog());
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  EXPECT_EQ(made->manifest.scene_hash, now.manifest.scene_hash);
  const auto back = edited(now, swap);
  ASSERT_TRUE(back.ok()) << to_string(back.error());
  EXPECT_EQ(back->created.manifest.scene_hash, shop().manifest.scene_hash);
}

TEST(Edits, ThatAreTakenBackGiveTheSameStore) {
  const auto there = edited(shop(), R"({"set_stock": {"zone": "dairy", "fill": 0.4}})");
  ASSERT_TRUE(there.ok()) << to_string(there.error());
  const auto back =
      edited(opened_last(*there), R"({"set_stock": {"zone": "dairy", "usual": ["fill"]}})");
  ASSERT_TRUE(back.ok()) << to_string(back.error());
  EXPECT_EQ(back->created.manifest.scene_hash, shop().manifest.scene_hash);
}

TEST(Edits, ThatBreakAHardRuleWriteNothing) {
  store::EditOptions options;
  options.folder = parent() / "refused";
  options.step.patches = patches(R"({"drop_zone": {"zone": "tills"}})");
  options.step.source = "p.json";
  const auto edit = store::edit_store(shop(), options, committed_catalog());
  ASSERT_FALSE(edit.ok());
  EXPECT_EQ(edit.error().code, "layout.violation");
  EXPECT_NE(edit.error().message.find("CHECKOUT_MISSING"), std::string::npos)
      << edit.error().message;
  EXPECT_FALSE(fs::exists(options.folder));
}

// An editor keeps a store in memory from edit to edit: saved at last, it is what a chain of folders
// would have come to.
TEST(Edits, InMemoryComeToTheSameFolder) {
  const char* first = R"({"set_ratio": {"node": "west", "ratio": 0.55}})";
  const char* second = R"({"set_fixture": {"zone": "canned", "levels": 6}})";
  const auto one = edited(shop(), first);
  ASSERT_TRUE(one.ok()) << to_string(one.error());
  const auto two = edited(opened_last(*one), second);
  ASSERT_TRUE(two.ok()) << to_string(two.error());

  const auto report = store::report_before(shop(), committed_catalog());
  ASSERT_TRUE(report.ok());
  const auto held =
      store::edited_store(shop(), *report, {patches(first), "p.json", ""}, committed_catalog());
  ASSERT_TRUE(held.ok()) << to_string(held.error());
  EXPECT_EQ(held->changes.products, one->changes.products);
  const auto again = store::edited_store(
      held->store, held->report, {patches(second), "p.json", ""}, committed_catalog());
  ASSERT_TRUE(again.ok()) << to_string(again.error());
  const auto saved = store::save_edited(*again, parent() / "held", false, committed_catalog());
  ASSERT_TRUE(saved.ok()) << to_string(saved.error());
  EXPECT_EQ(io::write_json(saved->manifest), io::write_json(two->created.manifest));
  EXPECT_FALSE(store::save_edited(*again, parent() / "held", false, committed_catalog()).ok())
      << "a folder that is there is not written over";
}

// That is what `generate --plan` makes, or it is said that it does not.
TEST(Edits, SayWhetherTheirPlanAloneMakesThem) {
  for (const Example& example : examples()) {
    const auto edit = edited(shop(), example.patch);
    ASSERT_TRUE(edit.ok()) << example.operation << to_string(edit.error());
    const store::Store now = opened_last(*edit);
    const auto follows = store::follows_from_plan(now, committed_catalog());
    ASSERT_TRUE(follows.ok()) << to_string(follows.error());
    store::CreateOptions options;
    options.folder = last_folder().string() + "-again";
    options.plan_file = now.folder / "plan.json";
    options.seed = now.manifest.seed;
    options.previews = false;
    const auto made = store::create_store(options, committed_catalog());
    ASSERT_TRUE(made.ok()) << to_string(made.error());
    EXPECT_EQ(*follows, made->manifest.scene_hash == now.manifest.scene_hash) << example.operation;
  }
}

TEST(Edits, GetTheNextFreeName) {
  EXPECT_EQ(store::next_edit_folder(parent() / "none"), parent() / "none-edit-1");
  EXPECT_EQ(store::next_edit_folder(parent() / "none/"), parent() / "none-edit-1");
  EXPECT_EQ(store::next_edit_folder(parent() / "none-edit-4"), parent() / "none-edit-5");
  fs::create_directories(parent() / "taken-edit-1");
  EXPECT_EQ(store::next_edit_folder(parent() / "taken"), parent() / "taken-edit-2");
}

// ---- Words --------------------------------------------------------------------------------------

std::string patches_of(const std::string& words) {
  const auto said = store::patches_of_words(shop(), words, committed_catalog());
  if (!said.ok()) return to_string(said.error());
  std::string out;
  for (const plan::Patch& patch : said->patches.patches)
    out += (out.empty() ? "" : " ") + io::write_json_line(patch);
  for (const intake::UnparsedWord& word : said->unparsed)
    out += " ?" + word.text;
  return out;
}

TEST(EditWords, BecomePatches) {
  const std::map<std::string, std::string> known = {
      {"swap dairy and snacks", R"({"swap_leaves": {"a": "dairy", "b": "snacks"}})"},
      {"fill the dairy to 60 %", R"({"set_stock": {"zone": "dairy", "fill": 0.6}})"},
      {"set the shelf levels in snacks to 6",
       R"({"set_fixture": {"zone": "snacks", "levels": 6}})"},
      {"a concrete floor", R"({"set_look": {"floor": "concrete-polished"}})"},
      {"a ceiling height of 4 m", R"({"set_shell": {"ceiling_mm": 4000}})"},
      {"make it Saturday evening", R"({"set_time": {"time": "Sat 18:00"}})"},
      {"at 9:15 on a Monday", R"({"set_time": {"time": "Mon 09:15"}})"},
      {"remove the canned food", R"({"drop_zone": {"zone": "canned"}})"},
      {"one less checkout", R"({"set_fixture": {"zone": "tills", "count": 1}})"},
      {"make the snacks untidy",
       R"({"set_stock": {"zone": "snacks", "jitter": 0.8, "misplaced": 0.03}})"},
  };
  for (const auto& [words, patch] : known)
    EXPECT_EQ(patches_of(words), patch) << words;
}

// A store's lanes are of one make: what is asked for of lanes is asked of them.
TEST(EditWords, CountWhatStandsOfAnyMake) {
  store::CreateOptions options;
  options.folder = parent() / "of-makes";
  options.brief.prompt = "a 24 x 15 m supermarket with three checkouts";
  options.previews = false;
  const auto made = store::create_store(options, committed_catalog());
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  const auto store = store::open_store(options.folder, committed_catalog());
  ASSERT_TRUE(store.ok());
  const std::vector<layout::Fixture>& stand = store->scene.layout.fixtures;
  ASSERT_EQ(std::ranges::find(stand, "checkout_lane", &layout::Fixture::kind), stand.end())
      << "the test needs a store with another make";
  const auto said = store::patches_of_words(*store, "one less checkout", committed_catalog());
  ASSERT_TRUE(said.ok()) << to_string(said.error());
  ASSERT_EQ(said->patches.patches.size(), 1U);
  const auto& change = said->patches.patches.front().set_fixture;
  ASSERT_TRUE(change);
  EXPECT_EQ(change->count, 2);
}

// What is moved or made larger depends on the floor: the outcome is looked at.
TEST(EditWords, MoveAndResize) {
  const auto plan_after = [&](const std::string& words) {
    const auto said = store::patches_of_words(shop(), words, committed_catalog());
    if (!said.ok()) fatal(to_string(said.error()).c_str());
    EXPECT_TRUE(said->unparsed.empty()) << words;
    auto now = store::replan(shop(), said->patches, "words", committed_catalog());
    if (!now.ok()) fatal(to_string(now.error()).c_str());
    EXPECT_TRUE(now->offences.empty()) << words;
    return now->plan;
  };
  const auto floor_of = [](const plan::Plan& plan, std::string_view id) {
    const auto* zone = plan::find_zone(plan, id);
    if (zone == nullptr) fatal("no such zone");
    return plan::zone_rectangles(plan)[static_cast<std::size_t>(zone - plan.zones.data())];
  };
  EXPECT_GE(floor_of(plan_after("move snacks to the back wall"), "snacks").y1, 12000);
  EXPECT_GE(floor_of(plan_after("move the canned food to the left wall"), "canned").y1, 1);
  const double before = floor_of(shop().plan, "dairy").area_m2();
  EXPECT_NEAR(floor_of(plan_after("make the dairy 20 % larger"), "dairy").area_m2(),
              1.2 * before,
              0.1 * before);
  const plan::Plan added = plan_after("add a bakery");
  EXPECT_EQ(added.zones.back().type, "bakery");
}

TEST(EditWords, SayWhatIsSoAlready) {
  const auto so_already = [](const std::string& words) {
    const auto said = store::patches_of_words(shop(), words, committed_catalog());
    return said.ok() ? said->so_already : std::vector{to_string(said.error())};
  };
  EXPECT_EQ(so_already("with snacks"), std::vector<std::string>{"snacks"});
  EXPECT_TRUE(so_already("6-tier shelves in the snacks").empty()) << "that says where";
}

TEST(EditWords, ThatSayNothingOrWhatIsNotThere) {
  EXPECT_TRUE(patches_of("quizzical zeppelins yodel").starts_with("error[brief.not_understood]"))
      << patches_of("quizzical zeppelins yodel");
  EXPECT_TRUE(patches_of("").starts_with("error[brief.empty]"));
  const std::string unknown = patches_of("move the wine to the back wall");
  EXPECT_TRUE(unknown.starts_with("error[plan.unknown_reference]")) << unknown;
  EXPECT_NE(unknown.find("tills, snacks, dairy"), std::string::npos) << unknown;
}

}  // namespace
}  // namespace marketgen
