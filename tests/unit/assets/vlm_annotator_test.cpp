// The annotator that asks a model: what it shows, what it takes for an answer, and what becomes of
// it in an import. A server on this machine stands for the provider.
#include "assets/import/vlm_annotator.h"

#include <gtest/gtest.h>

#include "assets/import/import_asset.h"
#include "io/png.h"
#include "support/committed_catalog.h"
#include "support/glb_bytes.h"
#include "support/mock_server.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

json verdict() {
  return json::parse(R"({"name": "Tomato soup", "category": "canned", "subcategory": "soup",
    "archetype": "food_tin", "material": "tin", "storage": "ambient", "rigidity": "rigid",
    "keywords": ["soup", "tomato"], "confidence": 0.9, "reason": "The print says soup."})");
}

// A step of the server: the model says `text`.
json says(const std::string& text) {
  return {{"body", {{"choices", json::array({{{"message", {{"content", text}}}}})}}}};
}

llm::LanguageModel model_at(const MockServer& server) {
  setenv("OPENAI_API_KEY", "test-key-123", 1);
  llm::ModelChoice choice;
  choice.model = "openai:seer";
  choice.url = server.url();
  choice.limits.first_wait_s = 0.01;
  return llm::open_language_model(choice).value();
}

Result<catalog::AssetAnnotation> annotated(const MockServer& server,
                                           const std::vector<Image>& pictures) {
  assets::AssetEvidence evidence;
  evidence.file_name = "scan_0042.glb";
  evidence.parts = {"can \"A\"", "lid", "\xff not text", std::string(1000, 'x')};
  evidence.size_mm = {75, 75, 110};
  evidence.look.colors = {{"#c81010", 0.75}};
  evidence.pictures = &pictures;
  return assets::vlm_annotator(committed_catalog(), model_at(server))(evidence);
}

TEST(VlmAnnotator, ShowsTheModelAndTakesTheAnswer) {
  const MockServer server(json::array({says(verdict().dump())}));
  const auto said = annotated(server, {Image(2000, 1000), Image(), Image(40, 40, 4)});
  ASSERT_TRUE(said.ok()) << to_string(said.error());
  EXPECT_EQ(said->annotator, "openai:seer");
  EXPECT_EQ(said->name, "Tomato soup");
  EXPECT_EQ(said->category, "canned");
  EXPECT_EQ(said->subcategory, "soup");
  EXPECT_EQ(said->archetype, "food_tin");
  EXPECT_EQ(said->material, "tin");
  EXPECT_EQ(said->keywords, (std::vector<std::string>{"soup", "tomato"}));
  EXPECT_EQ(said->confidence, 0.9);
  EXPECT_EQ(said->reasons, (std::vector<std::string>{"The print says soup."}));

  ASSERT_EQ(server.requests().size(), 1U);
  const json asked = json::parse(server.requests()[0]["body"].get<std::string>());
  const json& parts = asked["messages"][1]["content"];
  ASSERT_EQ(parts.size(), 3U);  // two pictures and the question
  const std::array<std::array<int, 2>, 2> sizes{{{768, 384}, {40, 40}}};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string url = parts[i]["image_url"]["url"];
    const auto png = net::bytes_of_base64(url.substr(url.find(',') + 1), "picture");
    const auto picture = io::decode_png(png.value(), "picture");
    ASSERT_TRUE(picture.ok()) << to_string(picture.error());
    EXPECT_EQ((std::array<int, 2>{picture->width, picture->height}), sizes[i]);
  }
  const std::string question = parts[2]["text"];
  for (const char* expected : {"scan_0042.glb",
                               R"("can \"A\"")",
                               "75",
                               "#c81010",
                               "canned meals",
                               "soft drinks",
                               "hdpe",
                               "food_tin"})
    EXPECT_NE(question.find(expected), std::string::npos) << expected;
  EXPECT_EQ(question.find("xxxx"), std::string::npos);
}

// The schema holds the model to the catalogue's names.
TEST(VlmAnnotator, TheSchemaListsTheCataloguesNames) {
  const MockServer server(json::array({says(verdict().dump())}));
  ASSERT_TRUE(annotated(server, {}).ok());
  const json asked = json::parse(server.requests().at(0)["body"].get<std::string>());
  EXPECT_EQ(asked["messages"][1]["content"].type(), json::value_t::string);  // no picture
  const json& properties = asked["response_format"]["json_schema"]["schema"]["properties"];
  const json categories = properties["category"]["enum"];
  EXPECT_EQ(categories.size(), committed_catalog().categories.size());
  EXPECT_NE(std::find(categories.begin(), categories.end(), "frozen"), categories.end());
  EXPECT_EQ(properties["storage"]["enum"], json({"ambient", "chilled", "frozen"}));
  EXPECT_EQ(properties["archetype"]["enum"].back(), "unknown");
}

TEST(VlmAnnotator, WrongNamesGoBackOnceWithHints) {
  json wrong = verdict();
  wrong["category"] = "caned";
  wrong["material"] = "unobtainium";
  json misplaced = verdict();
  misplaced["subcategory"] = "soft drinks";  // of beverages
  json hostile = verdict();
  hostile["name"] = "Soup\u001b[2J";
  struct Case {
    json answer;
    const char* told;
  };
  for (const Case& c : {Case{wrong, "did you mean \"canned\""},
                        Case{wrong, "material"},
                        Case{misplaced, "subcategory"},
                        Case{hostile, "control characters"}}) {
    const MockServer server(json::array({says(c.answer.dump()), says(verdict().dump())}));
    const auto said = annotated(server, {});
    ASSERT_TRUE(said.ok()) << to_string(said.error());
    EXPECT_EQ(said->category, "canned");
    ASSERT_EQ(server.requests().size(), 2U);
    const json asked = json::parse(server.requests()[1]["body"].get<std::string>());
    EXPECT_EQ(asked["messages"][2]["role"], "assistant");
    EXPECT_NE(asked["messages"][3]["content"].get<std::string>().find(c.told), std::string::npos)
        << asked["messages"][3]["content"];
  }
}

TEST(VlmAnnotator, TwiceWrongIsAnErrorThatSaysWhy) {
  json wrong = verdict();
  wrong["category"] = "stationery";
  const MockServer server(json::array({says("It is soup."), says(wrong.dump())}));
  const auto said = annotated(server, {});
  ASSERT_FALSE(said.ok());
  EXPECT_EQ(said.error().code, "llm.bad_answer");
  EXPECT_EQ(said.error().where, "openai:seer");
  EXPECT_NE(said.error().message.find("stationery"), std::string::npos) << said.error().message;
}

TEST(VlmAnnotator, WhatItCannotTellStaysEmpty) {
  json unsure = verdict();
  unsure["archetype"] = unsure["material"] = "unknown";
  const MockServer server(json::array({says(unsure.dump())}));
  const auto said = annotated(server, {});
  ASSERT_TRUE(said.ok());
  EXPECT_EQ(said->archetype + said->material, "");
}

// Names that say nothing: offline it would need --category.
TEST(VlmAnnotator, AnImportTakesItsWord) {
  const ScratchFolder scratch;
  const fs::path file = scratch.path() / "mesh_001.glb";
  std::ofstream(file, std::ios::binary) << box_glb(0.075F, 0.11F, 0.075F, R"({"mesh": 0})");
  const MockServer server(json::array({says(verdict().dump())}));
  assets::ImportOptions options;
  options.coacd = false;
  options.row.name = "My soup";
  const auto asset =
      assets::import_asset(file,
                           options,
                           committed_catalog(),
                           assets::vlm_annotator(committed_catalog(), model_at(server)));
  ASSERT_TRUE(asset.ok()) << to_string(asset.error());
  EXPECT_EQ(asset->file.annotation.annotator, "openai:seer");
  EXPECT_EQ(asset->file.product.category, "canned");
  EXPECT_EQ(asset->file.product.material, "tin");
  EXPECT_EQ(asset->file.product.name, "My soup");  // what a person says counts more
  EXPECT_EQ(asset->file.product.size_mm, (std::array<int, 3>{75, 75, 110}));
}

TEST(ScaledPicture, IsTheMeanOfWhatItStandsFor) {
  Image picture(4, 2, 1);
  picture.pixels = {0, 100, 10, 10, 200, 100, 30, 30};
  const Image half = assets::scaled_within(picture, 2);
  EXPECT_EQ(half.width, 2);
  EXPECT_EQ(half.height, 1);
  EXPECT_EQ(half.pixels, (std::vector<std::uint8_t>{100, 20}));
  EXPECT_EQ(assets::scaled_within(picture, 4).pixels, picture.pixels);
  const Image thin = assets::scaled_within(Image(3000, 1, 3), 100);
  EXPECT_EQ(thin.width, 100);
  EXPECT_EQ(thin.height, 1);
}

}  // namespace
}  // namespace marketgen
