// A store that is edited over the server: what a page asks, what comes of it, and what is refused.
#include "server/editor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <utility>

#include "io/gzip.h"
#include "server/cards.h"
#include "support/committed_catalog.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const char* const plan_text = R"({
  "schema": "market-plan/1", "name": "Edited",
  "shell": {"width_mm": 16000, "depth_mm": 12000,
    "openings": [{"id": "door", "kind": "entrance", "wall": "south", "center": 0.75, "width_mm": 2000},
                 {"id": "way_out", "kind": "exit", "wall": "south", "center": 0.28, "width_mm": 2000}]},
  "nodes": [{"id": "root", "split": "y", "ratio": 0.4, "gap_mm": 2000, "children": ["front", "back"]},
            {"id": "front", "zone": "tills"},
            {"id": "back", "split": "x", "ratio": 0.5, "gap_mm": 2000, "children": ["west", "east"]},
            {"id": "west", "zone": "snacks"}, {"id": "east", "zone": "drinks"}],
  "zones": [{"id": "tills", "type": "checkout", "fixture": {"kind": "checkout_lane", "count": 2}},
            {"id": "snacks", "type": "snacks", "fixture": {"kind": "gondola", "levels": 5}},
            {"id": "drinks", "type": "beverages", "fixture": {"kind": "gondola", "levels": 5}}]
})";

struct Picture {
  Json head;
  std::string data;
  template <class Number>
  std::vector<Number> numbers(const std::string& name) const {
    const Json& section = head["sections"][name];
    std::vector<Number> values(section["count"].get<std::size_t>() *
                               section["components"].get<std::size_t>());
    std::memcpy(values.data(),
                data.data() + section["offset"].get<std::size_t>(),
                values.size() * sizeof(Number));
    return values;
  }
};

class EditedOnline : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    scratch = new ScratchFolder;
    std::ofstream(scratch->path() / "plan.json") << plan_text;
    base = std::make_shared<const store::Store>(made(scratch->path() / "plan.json", "shop"));
  }
  static void TearDownTestSuite() {
    base.reset();
    delete scratch;
  }
  static store::Store made(const fs::path& plan, const std::string& name) {
    store::CreateOptions options;
    options.folder = scratch->path() / name;
    options.plan_file = plan;
    options.seed = 7;
    options.previews = false;
    const auto created = store::create_store(options, committed_catalog());
    if (!created.ok()) fatal(to_string(created.error()).c_str());
    auto store = store::open_store(options.folder, committed_catalog());
    if (!store.ok()) fatal(to_string(store.error()).c_str());
    return std::move(store).value();
  }
  void SetUp() override { token = picture("begin", Json::object()).head["token"]; }

  Result<web::HttpReply> post(const std::string& verb, const std::string& body) {
    web::HttpAsk ask;
    ask.method = "POST";
    ask.body = body;
    return editor.post(verb, ask);
  }
  Result<web::HttpReply> post(const std::string& verb, Json body) {
    if (!token.empty()) body["token"] = token;
    return post(verb, body.dump());
  }
  std::string code(const std::string& verb, const Json& body) {
    const auto reply = post(verb, body);
    return reply.ok() ? "" : reply.error().code;
  }
  static std::string bytes_of(const web::HttpReply& reply) {
    return reply.body->packed ? *io::gunzip(reply.body->bytes, "body") : reply.body->bytes;
  }
  Json json(const std::string& verb, const Json& body) {
    const auto reply = post(verb, body);
    EXPECT_TRUE(reply.ok()) << to_string(reply.error());
    return Json::parse(bytes_of(*reply));
  }
  Picture picture(const std::string& verb, const Json& body) {
    const auto reply = post(verb, body);
    if (!reply.ok()) fatal(to_string(reply.error()).c_str());
    const std::string bytes = bytes_of(*reply);
    std::uint32_t length = 0;
    std::memcpy(&length, bytes.data() + 4, sizeof length);
    return {Json::parse(bytes.substr(8, length)), bytes.substr(8 + length)};
  }
  static Json ratio(double value) {
    return {{"patches", {{{"set_ratio", {{"node", "back"}, {"ratio", value}}}}}}};
  }
  static Json levels(int count) {
    return {{"patches", {{{"set_fixture", {{"zone", "drinks"}, {"levels", count}}}}}}};
  }

  static inline ScratchFolder* scratch = nullptr;
  static inline std::shared_ptr<const store::Store> base;
  server::GraspFacts grasps = server::read_grasp_facts().value();
  server::Editor editor{base,
                        std::make_shared<const catalog::Catalog>(committed_catalog()),
                        grasps,
                        [](const fs::path&) -> Result<int> { return 1; }};
  std::string token;
};

// What a page pins of a run is where it is told that the run stands.
TEST_F(EditedOnline, ARunIsLookedAtAndMovedByItsPin) {
  const Picture opened = picture("begin", Json::object());
  const Json& runs = opened.head["runs"];
  Json run;  // of the drinks, off the walls of the 16 x 12 m shop
  for (const Json& other : runs)
    if (other["zone"] == "drinks" && other["rect_mm"][2] < 15000 && other["rect_mm"][3] < 11000)
      run = other;
  ASSERT_FALSE(run.is_null());
  EXPECT_FALSE(run["pinned"]);
  const int x = run["at_mm"][0].get<int>() + 40;
  const Json pin{
      {"patches",
       {{{"set_override",
          {{"fixture", run["fixture"]}, {"field", "x_mm"}, {"value", std::to_string(x)}}}}}}};
  const Json seen = json("preview", pin);
  EXPECT_EQ(seen["offences"], Json::array());
  const auto west = [&](const Json& rows, const char* name) {
    int least = 1'000'000;
    for (const Json& row : rows)
      if (row[name] == run["id"]) least = std::min(least, row["rect_mm"][0].get<int>());
    return least;
  };
  const int moved = west(runs, "id") + 40;
  EXPECT_EQ(west(seen["fixtures"], "run"), moved);
  const Picture edit = picture("patches", pin);
  EXPECT_EQ(west(edit.head["runs"], "id"), moved);
  EXPECT_EQ(edit.head["places"].size(), 1U);
  EXPECT_EQ(edit.head["places"][0]["fixture"], run["fixture"]);
}

TEST_F(EditedOnline, FacingsAndAislesOfAZoneAreSaidAndChanged) {
  const auto drinks = [](const Picture& picture) {
    const Json& zones = picture.head["zones"];
    return *std::ranges::find_if(zones, [](const Json& zone) { return zone["id"] == "drinks"; });
  };
  EXPECT_FALSE(drinks(picture("begin", Json::object())).contains("aisle_mm"));
  const Picture edit = picture("patches",
                               {{"patches",
                                 {{{"set_stock", {{"zone", "drinks"}, {"facings", {3, 6}}}}},
                                  {{"set_fixture", {{"zone", "drinks"}, {"aisle_mm", 1500}}}}}}});
  EXPECT_EQ(drinks(edit)["facings"], Json({3, 6}));
  EXPECT_EQ(drinks(edit)["aisle_mm"], 1500);
}

// The page's own work: rows of the opened store by runs, and those that are new.
TEST_F(EditedOnline, TablesMakeTheEditedStoreOfTheOpenedOne) {
  const Picture edit = picture("patches", levels(6));
  const scene::Scene& now = editor.now()->store.scene;
  const scene::Scene& old = base->scene;
  const auto runs = edit.numbers<std::uint32_t>("runs");
  const auto positions = edit.numbers<float>("goods_position");
  const auto facings = edit.numbers<std::uint32_t>("goods_facing");
  const auto facing_rows = edit.numbers<std::uint32_t>("facing_rows");
  const auto shelf_rows = edit.numbers<std::uint32_t>("shelf_rows");
  std::size_t row = 0, fresh = 0, kept = 0;
  for (std::size_t i = 0; i < runs.size(); i += 2) {
    for (std::uint32_t k = 0; k < runs[i + 1]; ++k, ++row) {
      ASSERT_LT(row, now.products.size());
      const scene::SceneProduct& item = now.products[row];
      if (runs[i] == 0xFFFFFFFF) {
        EXPECT_EQ(facings[fresh], item.facing);
        EXPECT_EQ(0, std::memcmp(&positions[3 * fresh++], item.position_m.data(), 12));
        continue;
      }
      const scene::SceneProduct& before = old.products[runs[i] + k];
      EXPECT_EQ(before.position_m, item.position_m);
      EXPECT_EQ(facing_rows[before.facing], item.facing);
      EXPECT_EQ(shelf_rows[old.facings[before.facing].shelf], now.facings[item.facing].shelf);
      ++kept;
    }
  }
  EXPECT_EQ(row, now.products.size());
  EXPECT_EQ(fresh, positions.size() / 3);
  EXPECT_EQ(kept, edit.head["lines"][0]["changes"]["products"]["kept"]);
  EXPECT_GT(kept, 500U) << "snacks stay";
  EXPECT_GT(fresh, 100U) << "drinks do not";
}

TEST_F(EditedOnline, FixturesThatStandOtherwiseComeWithTheirShapes) {
  const Picture edit = picture("patches", levels(6));
  const auto rows = edit.numbers<std::uint16_t>("fixture_rows");
  const auto places = edit.numbers<std::uint32_t>("places");
  const scene::Scene& now = editor.now()->store.scene;
  EXPECT_EQ(rows.size(), base->scene.fixtures.size());
  const auto stay = static_cast<std::size_t>(
      std::ranges::count_if(rows, [](std::uint16_t row) { return row != 65535; }));
  EXPECT_EQ(stay + places.size() / 2, now.fixtures.size());
  for (std::size_t i = 1; i < places.size(); i += 2)
    EXPECT_EQ(now.layout.fixtures[places[i]].zone, "drinks");
  EXPECT_LT(edit.head["sections"]["shapes"]["count"], places.size() / 2) << "equal ones are one";
  EXPECT_GT(edit.head["sections"]["index"]["count"], 100U);
}

TEST_F(EditedOnline, UndoAndRedoGiveTheSameStores) {
  const std::string opened = base->manifest.scene_hash;
  const auto hash = [&] { return editor.now()->store.manifest.scene_hash; };
  picture("patches", ratio(0.55));
  const std::string first = hash();
  picture("patches", levels(6));
  const std::string second = hash();
  EXPECT_NE(first, opened);
  EXPECT_NE(second, first);
  EXPECT_EQ(picture("undo", Json::object()).head["done"], 1);
  EXPECT_EQ(hash(), first);
  const Picture back = picture("undo", Json::object());
  EXPECT_EQ(hash(), opened);
  EXPECT_EQ(
      back.numbers<std::uint32_t>("runs"),
      (std::vector<std::uint32_t>{0, static_cast<std::uint32_t>(base->scene.products.size())}));
  EXPECT_EQ(code("undo", Json::object()), "server.bad_request");
  picture("redo", Json::object());
  EXPECT_EQ(picture("redo", Json::object()).head["done"], 2);
  EXPECT_EQ(hash(), second);
  EXPECT_EQ(code("redo", Json::object()), "server.bad_request");
  picture("undo", Json::object());
  EXPECT_EQ(picture("patches", ratio(0.52)).head["lines"].size(), 2U) << "what was undone is gone";
}

// What a page names of two blocks is what it is told of their line.
TEST_F(EditedOnline, BlocksOfALineChangePlaces) {
  const scene::Scene& scene = base->scene;
  const std::string run =
      scene.layout.fixtures[scene.shelves[scene.facings.front().shelf].fixture].run;
  const auto blocks = server::blocks_of_run(scene, run).blocks;
  ASSERT_GT(blocks.size(), 4U);
  const auto place = [](const server::RunBlock& block, Json more = Json::object()) {
    more.update({{"fixture", block.fixture},
                 {"side", name_of(block.side)},
                 {"shelf", block.shelf},
                 {"position", block.position},
                 {"sku", block.sku}});
    return more;
  };
  const Json swap{
      {"patches", {{{"swap_blocks", {{"a", place(blocks[0])}, {"b", place(blocks[1])}}}}}}};
  EXPECT_TRUE(json("preview", swap)["offences"].empty());
  const Picture edit = picture("patches", swap);
  const auto now = server::blocks_of_run(editor.now()->store.scene, run).blocks;
  ASSERT_EQ(now.size(), blocks.size());
  EXPECT_EQ(now[0].sku, blocks[1].sku);
  EXPECT_EQ(now[1].sku, blocks[0].sku);
  EXPECT_EQ(now[0].facings, blocks[1].facings);
  EXPECT_TRUE(edit.head["lines"][0]["patches"][0].contains("swap_blocks"));
  EXPECT_EQ(code("preview", swap), "plan.unknown_reference") << "another product stands there now";
  picture("undo", Json::object());
  EXPECT_EQ(editor.now()->store.manifest.scene_hash, base->manifest.scene_hash);
  const Json wide{
      {"patches",
       {{{"swap_blocks", {{"a", place(blocks[0], {{"facings", 90}})}, {"b", place(blocks[1])}}}}}}};
  for (const char* verb : {"preview", "patches"}) {
    const auto refused = post(verb, wide);
    ASSERT_FALSE(refused.ok()) << verb;
    EXPECT_EQ(refused.error().code, "planogram.does_not_fit");
    EXPECT_EQ(refused.error().where, "patches:/patches/0/swap_blocks/a/facings");
    EXPECT_TRUE(server::is_refused_edit(refused.error()));
  }
}

TEST_F(EditedOnline, WordsBecomePatches) {
  const Picture edit = picture("say", {{"words", "swap snacks and drinks, blue bananas"}});
  EXPECT_EQ(edit.head["lines"][0]["words"], "swap snacks and drinks, blue bananas");
  EXPECT_TRUE(edit.head["lines"][0]["patches"][0].contains("swap_leaves"));
  EXPECT_FALSE(edit.head["unparsed"].empty());
  EXPECT_EQ(code("say", {{"words", "quizzical zeppelins yodel"}}), "brief.not_understood");
}

TEST_F(EditedOnline, PreviewsSayWhatWouldBeBrokenAndChangeNothing) {
  const std::string before = editor.now()->store.manifest.scene_hash;
  const Json fits = json("preview", ratio(0.55));
  EXPECT_TRUE(fits["offences"].empty());
  EXPECT_EQ(fits["zones"].size(), 3U);
  const Json broken =
      json("preview", {{"patches", {{{"set_fixture", {{"zone", "tills"}, {"count", 9}}}}}}});
  ASSERT_FALSE(broken["offences"].empty());
  EXPECT_EQ(broken["offences"][0]["severity"], "hard");
  EXPECT_EQ(editor.now()->store.manifest.scene_hash, before);
  const auto refused =
      post("patches", {{"patches", {{{"set_fixture", {{"zone", "tills"}, {"count", 9}}}}}}});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, "layout.violation");
  EXPECT_TRUE(server::is_refused_edit(refused.error()));
  EXPECT_EQ(editor.now()->store.manifest.scene_hash, before);
}

// Saving writes what `marketgen edit` would have come to, and `generate --plan` makes it again
// where it is said so.
TEST_F(EditedOnline, IsSavedAsAStoreOfItsOwn) {
  picture("patches", ratio(0.55));
  picture("patches", levels(6));
  const Json saved = json("save", {{"name", "saved"}});
  EXPECT_EQ(saved["folder"], "saved");
  EXPECT_EQ(saved["store"], 1);
  const auto opened = store::open_store(scratch->path() / "saved", committed_catalog());
  ASSERT_TRUE(opened.ok()) << to_string(opened.error());
  EXPECT_EQ(opened->manifest.scene_hash, saved["scene_hash"]);
  EXPECT_EQ(opened->manifest.edits->size(), 2U);
  EXPECT_TRUE(store::verify_store(scratch->path() / "saved", committed_catalog()).ok());
  const store::Store again = made(scratch->path() / "saved/plan.json", "again");
  EXPECT_EQ(saved["follows_from_plan"], again.manifest.scene_hash == saved["scene_hash"]);
  EXPECT_TRUE(saved["follows_from_plan"]);
  EXPECT_TRUE(store::verify_store(base->folder, committed_catalog()).ok()) << "it is not written";
  EXPECT_FALSE(post("save", {{"name", "saved"}}).ok()) << "nor is any other";
}

TEST_F(EditedOnline, IsSavedBesideTheStoreAndNowhereElse) {
  for (const char* name : {"", ".", "..", "../out", "a/b", "a\\b", ".hidden", "a\nb", "/tmp/x"})
    EXPECT_EQ(code("save", {{"name", name}}), "server.bad_request") << name;
  EXPECT_FALSE(code("save", {{"name", std::string(101, 'a')}}).empty());
  EXPECT_FALSE(fs::exists(scratch->path().parent_path() / "out"));
}

TEST_F(EditedOnline, OthersAreToldAndChangeNothing) {
  const std::string mine = std::exchange(token, "");
  EXPECT_EQ(code("begin", Json::object()), "server.edit_taken");
  for (const char* verb : {"undo", "redo", "beat", "end"})
    EXPECT_EQ(code(verb, {{"token", "guessed"}}), "server.edit_taken") << verb;
  for (const char* verb : {"patches", "preview"}) {
    Json body = ratio(0.55);
    body["token"] = "guessed";
    EXPECT_EQ(code(verb, body), "server.edit_taken") << verb;
  }
  EXPECT_EQ(code("say", {{"token", "guessed"}, {"words", "no snacks"}}), "server.edit_taken");
  EXPECT_EQ(code("save", {{"token", "guessed"}, {"name", "theirs"}}), "server.edit_taken");
  EXPECT_TRUE(Json::parse(bytes_of(*editor.status()))["taken"]);
  EXPECT_TRUE(post("end", Json{{"token", mine}}.dump()).ok());
  EXPECT_FALSE(Json::parse(bytes_of(*editor.status()))["taken"]);
  EXPECT_EQ(code("begin", Json::object()), "");
}

TEST_F(EditedOnline, WhatIsNoRequestIsRefused) {
  const std::string before = editor.now()->store.manifest.scene_hash;
  const std::string own = "{\"token\": \"" + token + "\", ";
  for (const std::string& body :
       {std::string(),
        std::string("{"),
        std::string("[]"),
        std::string("null"),
        own,
        own + "\"patches\": 1}",
        own + "\"patches\": []}",
        own + "\"patches\": [{}]}",
        own + R"("patches": [{"set_ratio": {"node": "back", "ratio": 1e999}}]})",
        own + R"("patches": [{"set_ratio": {"node": "nowhere", "ratio": 0.5}}]})",
        own + R"("patches": [{"no_such": {}}]})",
        own + R"("patches": [], "more": 1})",
        std::string(100'000, '['),
        std::string("\0\xff", 2)}) {
    const auto reply = post("patches", body);
    EXPECT_FALSE(reply.ok()) << body.substr(0, 100);
  }
  EXPECT_EQ(code("nothing", Json::object()), "server.not_found");
  EXPECT_EQ(editor.now()->store.manifest.scene_hash, before);
}

// Requests with bytes changed, left out and put in: answered or refused, and the editor goes on.
TEST_F(EditedOnline, OutlivesDamagedRequests) {
  std::mt19937 random(7);
  const std::string good = Json{{"token", token}, {"patches", ratio(0.55)["patches"]}}.dump();
  for (int i = 0; i < 400; ++i) {
    std::string body = good;
    for (int k = 0; k < 1 + i % 4; ++k) {
      const std::size_t at = random() % body.size();
      if (i % 3 == 0)
        body[at] = static_cast<char>(random());
      else if (i % 3 == 1)
        body.erase(at, 1 + random() % 4);
      else
        body.insert(at, 1, static_cast<char>(random()));
    }
    static_cast<void>(post("preview", body));
  }
  EXPECT_TRUE(json("preview", ratio(0.55))["offences"].empty());
}

}  // namespace
}  // namespace marketgen
