// Stores that a page makes over the server: what it asks, what comes of it, and what is refused.
#include "server/maker.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "assets/usable_catalog.h"
#include "io/gzip.h"
#include "io/png.h"
#include "net/http.h"
#include "scene/scene.h"
#include "store/made_store.h"
#include "store/open_stores.h"
#include "support/committed_catalog.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* small_shop = "a 9 x 7 m corner shop with drinks and snacks, one checkout";

class MadeOnline : public testing::Test {
 protected:
  static std::string text_of(const web::HttpReply& reply) {
    return reply.body->packed ? *io::gunzip(reply.body->bytes, "body") : reply.body->bytes;
  }
  Result<web::HttpReply> post(const std::string& verb, const std::string& body) {
    web::HttpAsk ask;
    ask.method = "POST";
    ask.path = "/api/make/" + verb;
    ask.body = body;
    return maker.post(verb, ask);
  }
  Result<web::HttpReply> get(const std::vector<std::string>& words) {
    web::HttpAsk ask;
    ask.method = "GET";
    ask.path = "/api/make";
    return maker.get(ask, words);
  }
  Json state() { return Json::parse(text_of(*get({"tries"}))); }
  std::string code(const Result<web::HttpReply>& reply) {
    return reply.ok() ? "" : reply.error().code;
  }
  // Once nothing is to come.
  Json finished() {
    for (int i = 0; i < 3000; ++i) {
      Json now = state();
      if (!now["working"].get<bool>()) return now;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    ADD_FAILURE() << "it goes on for ever";
    return state();
  }

  ScratchFolder scratch;
  std::vector<fs::path> shown;
  server::Maker maker{std::make_shared<const catalog::Catalog>(committed_catalog()),
                      scratch.path() / "made",
                      [this](const fs::path& folder) -> Result<int> {
                        shown.push_back(folder);
                        return static_cast<int>(shown.size()) + 6;
                      }};
};

TEST_F(MadeOnline, SeedsAreComparedAndOneIsKeptAsGenerateWouldMakeIt) {
  EXPECT_EQ(state()["batch"], 0);
  ASSERT_TRUE(post("try", Json{{"words", small_shop}, {"seed", 5}, {"count", 2}}.dump()).ok());
  const Json made = finished();
  EXPECT_EQ(made["batch"], 1);
  ASSERT_EQ(made["tries"].size(), 2U);
  for (const Json& one : made["tries"]) {
    ASSERT_EQ(one["state"], "ready") << one.dump();
    const Json& store = one["store"];
    EXPECT_GT(store["counts"]["products"], 500);
    EXPECT_FALSE(store["report"]["requirements"].empty());
    EXPECT_EQ(store["fixtures"].size(), store["counts"]["fixtures"]);
    EXPECT_FALSE(fs::exists(scratch.path() / "made")) << "nothing is written before one is kept";
  }
  EXPECT_NE(made["tries"][0]["store"]["scene_hash"], made["tries"][1]["store"]["scene_hash"]);
  EXPECT_EQ(made["tries"][1]["seed"], 6);

  const std::string name = made["tries"][1]["store"]["save_as"];
  const auto kept = post("keep", Json{{"batch", 1}, {"seed", 6}, {"name", name}}.dump());
  ASSERT_TRUE(kept.ok()) << to_string(kept.error());
  EXPECT_EQ(Json::parse(text_of(*kept))["store"], 7);
  ASSERT_EQ(shown, std::vector{scratch.path() / "made" / name});
  const auto opened = store::open_store(shown[0], committed_catalog());
  ASSERT_TRUE(opened.ok()) << to_string(opened.error());

  store::CreateOptions options;
  options.folder = scratch.path() / "generated";
  options.brief.prompt = small_shop;
  options.seed = 6;
  options.previews = false;
  const auto generated = store::create_store(options, committed_catalog());
  ASSERT_TRUE(generated.ok());
  EXPECT_EQ(opened->manifest.scene_hash, generated->manifest.scene_hash);
  EXPECT_EQ(opened->manifest.look_hash, generated->manifest.look_hash);
  EXPECT_EQ(opened->manifest.brief.prompt, small_shop);
  EXPECT_EQ(opened->manifest.requirements.size(), generated->manifest.requirements.size());
  EXPECT_TRUE(store::verify_store(shown[0], committed_catalog()).ok());

  EXPECT_EQ(code(post("keep", Json{{"batch", 1}, {"seed", 6}, {"name", name}}.dump())),
            "store.exists");
  EXPECT_TRUE(server::is_refused_keeping({"store.exists", "", ""}));
  const auto picture = get({"pictures", "1-6.png"});
  ASSERT_TRUE(picture.ok()) << to_string(picture.error());
  const auto image = io::decode_png(picture->body->bytes, "picture");
  ASSERT_TRUE(image.ok());
  EXPECT_EQ(image->width, 480);
  EXPECT_EQ(get({"pictures", "1-6.png"})->body, picture->body) << "drawn once";
}

TEST_F(MadeOnline, ANewBriefTakesThePlaceOfTheOneBefore) {
  ASSERT_TRUE(post("try", Json{{"words", "a 60 x 40 m hypermarket"}, {"count", 6}}.dump()).ok());
  ASSERT_TRUE(post("try", Json{{"words", small_shop}}.dump()).ok());
  const Json made = finished();
  EXPECT_EQ(made["batch"], 2);
  ASSERT_EQ(made["tries"].size(), 1U);
  EXPECT_EQ(made["tries"][0]["state"], "ready");
  EXPECT_EQ(code(post("keep", Json{{"batch", 1}, {"seed", 1}, {"name", "x"}}.dump())),
            "server.not_found");
  EXPECT_EQ(code(get({"pictures", "1-1.png"})), "server.not_found");
}

TEST_F(MadeOnline, DrawingsAreReadAndNamedAsTheyWereCalled) {
  constexpr std::string_view plan =
      R"(<svg xmlns="http://www.w3.org/2000/svg" width="160mm" height="100mm" viewBox="0 0 1600 1000">)"
      R"(<rect id="wall" x="0" y="0" width="1600" height="1000" fill="none" stroke="black"/></svg>)";
  const Json dropped{{"name", "my shop.svg"}, {"base64", net::base64_of(plan)}};
  Json ask{{"words", small_shop}, {"floor_plan", dropped}, {"floor_plan_scale", "1:100"}};
  ask["words"] = "a corner shop with drinks and snacks, one checkout";
  ASSERT_TRUE(post("try", ask.dump()).ok());
  const Json made = finished();
  ASSERT_EQ(made["tries"][0]["state"], "ready") << made.dump();
  ASSERT_TRUE(post("keep", Json{{"batch", 1}, {"seed", 1}, {"name", "drawn"}}.dump()).ok());
  const auto opened = store::open_store(shown.at(0), committed_catalog());
  ASSERT_TRUE(opened.ok());
  EXPECT_EQ(opened->manifest.brief.floor_plan, "my shop.svg");
  EXPECT_EQ(opened->scene.layout.shell.width_mm, 16000);

  ask["floor_plan"]["base64"] = net::base64_of("no drawing");
  ASSERT_TRUE(post("try", ask.dump()).ok());
  const Json failed = finished();
  EXPECT_NE(failed["error"]["where"].get<std::string>().find("my shop.svg"), std::string::npos);
  EXPECT_EQ(failed["error"].dump().find("marketgen-dropped"), std::string::npos)
      << "where it was for a moment is nobody's business";
  EXPECT_EQ(failed["tries"][0]["state"], "waiting");
}

// As `generate --time --vary --skin --country --catalog` would: the same store, and its brief says
// so.
TEST_F(MadeOnline, TimeAxesLookAndOwnProductsAreThoseOfGenerate) {
  constexpr std::string_view own =
      "sku,ean,name,category,subcategory,archetype,size_mm,mass_kg\n"
      "own-cola,2999999999991,Lemonade,beverages,soft drinks,can,66x66x115,0.35\n";
  const Json options = Json::parse(text_of(*get({})));
  EXPECT_EQ(options["planners"], Json{"offline"});
  EXPECT_EQ(options["vary"].size(), 5U);
  EXPECT_FALSE(options["countries"].empty());
  const std::string words = "a kiosk with cold drinks";
  const Json ask{{"words", words},
                 {"seed", 3},
                 {"size", "8x7m"},
                 {"time", "Sat 17:30"},
                 {"vary", {"fill=9", "prices=2"}},
                 {"skin", "industrial"},
                 {"country", "us"},
                 {"planner", "offline"},
                 {"catalogs", {{{"name", "mine.csv"}, {"base64", net::base64_of(own)}}}}};
  ASSERT_TRUE(post("try", ask.dump()).ok());
  const Json made = finished();
  ASSERT_EQ(made["tries"][0]["state"], "ready") << made.dump();
  ASSERT_TRUE(post("keep", Json{{"batch", 1}, {"seed", 3}, {"name", "own"}}.dump()).ok());
  const auto opened = store::open_store(shown.at(0), committed_catalog());
  ASSERT_TRUE(opened.ok()) << to_string(opened.error());
  EXPECT_EQ(opened->manifest.brief.time, "Sat 17:30");
  EXPECT_EQ(opened->manifest.brief.vary->fill, 9U);
  EXPECT_EQ(opened->manifest.brief.skin, "industrial");
  ASSERT_TRUE(opened->manifest.own.has_value());
  EXPECT_EQ(opened->manifest.own->at(0).sku, "own-cola");

  const fs::path file = scratch.path() / "mine.csv";
  std::ofstream(file) << own;
  const auto rows = assets::usable_catalog({file});
  ASSERT_TRUE(rows.ok()) << to_string(rows.error());
  store::CreateOptions plain;
  plain.brief.prompt = words;
  plain.brief.size_mm = {8000, 7000};
  plain.brief.time = "Sat 17:30";
  plain.brief.vary.emplace();
  plain.brief.vary->fill = 9;
  plain.brief.vary->prices = 2;
  plain.brief.skin = "industrial";
  plain.brief.country = "us";
  plain.seed = 3;
  const auto generated = store::made_store(plain, *rows);
  ASSERT_TRUE(generated.ok()) << to_string(generated.error());
  EXPECT_EQ(opened->manifest.scene_hash, generated->store.manifest.scene_hash);
  EXPECT_EQ(opened->manifest.look_hash, generated->store.manifest.look_hash);
}

TEST_F(MadeOnline, SaysInTheCoresWordsWhatOfItIsNone) {
  const auto error_of = [&](const char* what, const Json& value) {
    Json ask{{"words", small_shop}};
    ask[what] = value;
    const auto reply = post("try", ask.dump());
    return reply.ok() ? finished()["error"]["code"].get<std::string>() : reply.error().code;
  };
  EXPECT_EQ(error_of("time", "Blursday 9:00"), "brief.bad_time");
  EXPECT_EQ(error_of("vary", {"weather=3"}), "brief.bad_vary");
  EXPECT_EQ(error_of("vary", {"fill=3", "fill=4"}), "brief.bad_vary");
  EXPECT_EQ(error_of("planner", "openai:gpt"), "server.bad_request") << "costs whose key it is";
  EXPECT_EQ(error_of("planner", "replay:/etc"), "server.bad_request");
  const Json broken = {{{"name", "mine.csv"}, {"base64", net::base64_of("no,table\n1\n")}}};
  ASSERT_TRUE(post("try", Json{{"words", small_shop}, {"catalogs", broken}}.dump()).ok());
  const Json error = finished()["error"];
  EXPECT_NE(error["where"].get<std::string>().find("mine.csv"), std::string::npos) << error;
  EXPECT_EQ(error.dump().find("marketgen-dropped"), std::string::npos) << error;
}

// The one that the server was started with is offered, and no other.
TEST_F(MadeOnline, AModelPlansWhereTheServerWasStartedWithIt) {
  server::OfferedPlanner planner{"http:m", {}};
  planner.access.url = "http://127.0.0.1:9/v1";
  server::Maker with_model(
      std::make_shared<const catalog::Catalog>(committed_catalog()),
      scratch.path() / "made",
      [](const fs::path&) -> Result<int> { return 0; },
      planner);
  web::HttpAsk ask;
  ask.method = "POST";
  ask.body = Json{{"words", small_shop}, {"planner", "http:m"}}.dump();
  EXPECT_EQ(Json::parse(text_of(*with_model.get(ask, {})))["planners"],
            Json::parse(R"(["offline", "http:m"])"));
  ASSERT_TRUE(with_model.post("try", ask).ok());
  Json now;
  for (int i = 0; i < 3000 && (now.is_null() || now["working"] == true); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    now = Json::parse(text_of(*with_model.get(ask, {"tries"})));
  }
  ASSERT_EQ(now["tries"][0]["state"], "ready") << "nobody answers there: " << now.dump();
  EXPECT_EQ(now["tries"][0]["store"]["report"]["planner"]["kept"], "offline planner");
}

TEST_F(MadeOnline, WhatMakesNoSenseIsRefusedAndWhatWasMadeStays) {
  ASSERT_TRUE(post("try", Json{{"words", small_shop}}.dump()).ok());
  ASSERT_EQ(finished()["tries"][0]["state"], "ready");
  EXPECT_EQ(code(post("try", "{}")), "server.bad_request");
  EXPECT_EQ(code(post("try", "no JSON")), "json.syntax");
  EXPECT_EQ(code(post("try", R"({"words": "x", "count": 7})")), "json.out_of_range");
  EXPECT_EQ(code(post("try", R"({"words": "x", "what": 1})")), "json.unknown_field");
  EXPECT_EQ(code(post("make", "{}")), "server.not_found");
  EXPECT_EQ(code(post("keep", R"({"batch": 1, "seed": 1})")), "json.missing_field");
  for (const char* name : {"../out", "a/b", ".hidden", ""})
    EXPECT_NE(code(post("keep", Json{{"batch", 1}, {"seed", 1}, {"name", name}}.dump())), "")
        << name;
  for (const char* name : {"1-1", "1.png", "-1-1.png", "1-1.png.png", "x", "99999999999-1.png"})
    EXPECT_EQ(code(get({"pictures", name})), "server.not_found") << name;
  EXPECT_EQ(code(get({"nothing"})), "server.not_found");
  EXPECT_EQ(state()["batch"], 1);
  EXPECT_EQ(state()["tries"][0]["state"], "ready");

  ASSERT_TRUE(post("try", R"({"words": "a shop", "size": "as large as can be"})").ok());
  EXPECT_EQ(finished()["error"]["code"], "brief.bad_size");
  const std::string sound = Json{
      {"words", small_shop},
      {"images", {{{"name", "a.png"}, {"base64", "AAAA"}}}},
      {"size", "9x7m"}}.dump();
  std::mt19937 random(7);
  for (int i = 0; i < 200; ++i) {
    std::string broken = sound;
    broken[random() % broken.size()] = static_cast<char>(random());
    if (i % 2 == 0) broken.resize(random() % broken.size());
    const std::string refused = code(post("try", broken));
    EXPECT_TRUE(refused.empty() || refused.starts_with("json.") ||
                refused == "server.bad_request" || refused == "input.not_utf8")
        << refused;
  }
  finished();
}

}  // namespace
}  // namespace marketgen
