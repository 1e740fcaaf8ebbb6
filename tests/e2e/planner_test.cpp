// `generate --planner` with a language model on this machine: what it says becomes a store, or the
// offline planner's plan does, and the user is told which.
#include <gtest/gtest.h>

#include "support/mock_server.h"

namespace marketgen {
namespace {

using nlohmann::json;

constexpr const char* planner_key = "e2e-test-key-789";

json saying(const std::string& text) {
  return {{"body",
           {{"choices", {{{"message", {{"content", text}}}}}},
            {"usage", {{"prompt_tokens", 900}, {"completion_tokens", 100}}}}}};
}

class PlannerFlag : public testing::Test {
 protected:
  void SetUp() override { setenv("OPENAI_API_KEY", planner_key, 1); }
  void TearDown() override { unsetenv("OPENAI_API_KEY"); }

  Ran generate(const std::vector<std::string>& more) const {
    std::vector<std::string> all = {
        "generate", "a tiny shop with dairy", "--size=8x6m", "--no-previews"};
    all.insert(all.end(), more.begin(), more.end());
    return marketgen_run(all, scratch_.path());
  }
  json report_of(const std::string& store) const {
    return json::parse(contents_of(scratch_.path() / store / "report.json"));
  }
  ScratchFolder scratch_;
};

TEST_F(PlannerFlag, AModelThatTalksNonsenseLeavesTheOfflineStore) {
  const MockServer server(json::array({saying("Lovely shop!")}));
  const Ran offline = generate({"-o", "plain"});
  ASSERT_EQ(offline.status, 0) << offline.err;
  const Ran ran = generate({"-o",
                            "shop",
                            "--planner",
                            "openai:m",
                            "--planner-url",
                            server.url(),
                            "--record",
                            "talk",
                            "--usd-per-million",
                            "1",
                            "10"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("openai:m: plan of the offline planner"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("2 questions, 1800 tokens read, 200 written"), std::string::npos);
  EXPECT_NE(ran.out.find("0.0038 US dollars"), std::string::npos) << ran.out;
  const json planner = report_of("shop")["planner"];
  EXPECT_EQ(planner["kept"], "offline planner");
  EXPECT_EQ(contents_of(scratch_.path() / "shop/plan.json"),
            contents_of(scratch_.path() / "plain/plan.json"));
  EXPECT_NE(contents_of(scratch_.path() / "shop/agents/index.html").find("openai:m"),
            std::string::npos);
  EXPECT_EQ(marketgen_run({"check", "shop"}, scratch_.path()).status, 0);
  EXPECT_EQ(all_text_in(scratch_.path()).find(planner_key), std::string::npos);
}

TEST_F(PlannerFlag, AReplayNeedsNeitherServerNorKey) {
  MockServer server(json::array({saying("Lovely shop!")}));
  const Ran live = generate(
      {"-o", "one", "--planner", "openai:m", "--planner-url", server.url(), "--record", "talk"});
  ASSERT_EQ(live.status, 0) << live.err;
  server.stop();
  unsetenv("OPENAI_API_KEY");
  const Ran again = generate({"-o", "two", "--planner", "replay:talk"});
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(contents_of(scratch_.path() / "one/agents/trace.json"),
            contents_of(scratch_.path() / "two/agents/trace.json"));
}

// Of tests/shop_photos/0001-1.jpg the bank is sure of panels and not of the light.
const std::string lamps_photo = std::string(MARKETGEN_SOURCE_DIR) + "/tests/shop_photos/0001-1.jpg";

// A model that reads that photo and then talks nonsense: the offline planner plans with what it
// read.
json only_reading_photos() {
  const json answer = {
      {"photos",
       {{{"picture", 1},
         {"attributes",
          {{{"attribute", "light"}, {"value", "cool"}, {"confidence", 0.9}, {"material", ""}},
           {{"attribute", "lamps"}, {"value", "line"}, {"confidence", 0.9}, {"material", ""}}}}}}}};
  json reader = saying(answer.dump());
  reader["for"] = "You look at photos";
  return json::array({reader, saying("Lovely shop!")});
}

TEST_F(PlannerFlag, PhotosAreShownToTheModelAndRecordedWithoutTheirPixels) {
  MockServer server(only_reading_photos());
  const Ran live = generate({"-o",
                             "one",
                             "--image",
                             lamps_photo,
                             "--planner",
                             "openai:m",
                             "--planner-url",
                             server.url(),
                             "--record",
                             "talk"});
  ASSERT_EQ(live.status, 0) << live.err;
  EXPECT_NE(live.err.find("warning: photos: lamps: panel"), std::string::npos) << live.err;
  EXPECT_NE(server.requests().at(0)["body"].get<std::string>().find("data:image/png;base64,iVBOR"),
            std::string::npos);
  server.stop();
  const json plan = json::parse(contents_of(scratch_.path() / "one/plan.json"));
  EXPECT_EQ(plan["look"]["light_kelvin"], 5500);
  const json photos = json::parse(contents_of(scratch_.path() / "one/photos.json"));
  EXPECT_EQ(photos["seen"][0]["attributes"][0]["value"], "cool");
  EXPECT_EQ(report_of("one")["planner"]["warnings"].size(), 1U);
  EXPECT_TRUE(contents_of(scratch_.path() / "one/agents/shown-1.png").starts_with("\x89PNG"));
  EXPECT_EQ(marketgen_run({"check", "one"}, scratch_.path()).status, 0);
  EXPECT_LT(all_text_in(scratch_.path() / "talk").size(), 200'000U);

  const Ran again = generate({"-o", "two", "--image", lamps_photo, "--planner", "replay:talk"});
  ASSERT_EQ(again.status, 0) << again.err;
  for (const char* file : {"plan.json", "photos.json", "agents/trace.json"})
    EXPECT_EQ(contents_of(scratch_.path() / "one" / file),
              contents_of(scratch_.path() / "two" / file));
}

// The shop has no room for six tills, so it is planned again with less.
TEST_F(PlannerFlag, WhatWasSeenStaysWhenAWishIsGivenUp) {
  MockServer server(only_reading_photos());
  const Ran ran = marketgen_run({"generate",
                                 "a tiny shop with dairy and six checkouts",
                                 "--size=8x6m",
                                 "--no-previews",
                                 "-o",
                                 "shop",
                                 "--image",
                                 lamps_photo,
                                 "--planner",
                                 "openai:m",
                                 "--planner-url",
                                 server.url()},
                                scratch_.path());
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.err.find("concede"), std::string::npos) << ran.err;
  const json plan = json::parse(contents_of(scratch_.path() / "shop/plan.json"));
  EXPECT_EQ(plan["look"]["light_kelvin"], 5500);
}

TEST_F(PlannerFlag, ErrorsSayWhatToDoAndLeaveNothing) {
  struct Case {
    std::vector<std::string> flags;
    std::string told;
  };
  unsetenv("OPENAI_API_KEY");
  const std::vector<Case> cases = {
      {{"--planner", "openai:m"}, "OPENAI_API_KEY"},
      {{"--planner", "opnai:m"}, "did you mean"},
      {{"--planner", "http:m"}, "--planner-url"},
      {{"--record", "talk"}, "language model"},
      {{"--planner", "replay:nowhere"}, "nowhere"},
      {{"--planner", "openai:m", "--max-usd", "1"}, "--usd-per-million"}};
  for (const Case& one : cases) {
    std::vector<std::string> flags = one.flags;
    flags.insert(flags.end(), {"-o", "shop"});
    const Ran ran = generate(flags);
    EXPECT_EQ(ran.status, 2) << one.told;
    EXPECT_NE(ran.err.find(one.told), std::string::npos) << ran.err;
    EXPECT_FALSE(std::filesystem::exists(scratch_.path() / "shop"));
  }
}

}  // namespace
}  // namespace marketgen
