// Answers as structs: what is found in a model's text, what it is told when it is wrong, and that
// it is told once.
#include "llm/structured_answer.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace marketgen {
namespace {

using nlohmann::json;

enum class Size { small, large };
constexpr std::array<std::string_view, 2> names_of(Size) {
  return {"small", "large"};
}

struct Inner {
  double share = 0.5;
  static constexpr auto fields = field_list(field("share", &Inner::share, "of all", range(0, 1)));
};

struct Verdict {
  std::string what;
  Size size = Size::small;
  std::vector<std::string> words;
  Inner inner;
  static constexpr auto fields =
      field_list(field("what", &Verdict::what, "what it is", required(), at_most_bytes(20)),
                 field("size", &Verdict::size, "how large"),
                 field("words", &Verdict::words, "about it", at_most_items(3)),
                 field("inner", &Verdict::inner, "more"));
};

// Says one text after the other; keeps what it was asked.
struct Parrot {
  std::vector<llm::ChatAnswer> says;
  std::vector<llm::ChatRequest> asked;
  llm::LanguageModel model() {
    return {"test:parrot", [this](const llm::ChatRequest& request) -> Result<llm::ChatAnswer> {
              asked.push_back(request);
              if (asked.size() > says.size()) return Error{"llm.refused", "test:parrot", "silent"};
              return says[asked.size() - 1];
            }};
  }
};

llm::ChatAnswer text(std::string what) {
  return {std::move(what), "parrot-1", 10, 3, false};
}

llm::ChatRequest question() {
  llm::ChatRequest request;
  request.system = "Be exact.";
  request.turns = {{llm::ChatRole::user, "What is it?", {"png"}}};
  return request;
}

TEST(StructuredAnswer, TheFirstAnswerIsGood) {
  Parrot parrot{{text(R"({"what": "soup", "size": "large"})")}, {}};
  const auto answered = llm::ask<Verdict>(parrot.model(), question());
  ASSERT_TRUE(answered.ok()) << to_string(answered.error());
  EXPECT_EQ(answered->value.what, "soup");
  EXPECT_EQ(answered->value.size, Size::large);
  EXPECT_EQ(answered->cost.requests, 1);
  ASSERT_EQ(parrot.asked.size(), 1U);
  EXPECT_EQ(parrot.asked[0].answer_schema, llm::answer_schema_of(type_of<Verdict>()));
  EXPECT_TRUE(parrot.asked[0].system.starts_with("Be exact.\n"));
  EXPECT_NE(parrot.asked[0].system.find(parrot.asked[0].answer_schema), std::string::npos);
}

TEST(StructuredAnswer, AWrongAnswerIsToldWhyAndMended) {
  const char* wrong[] = {
      R"({"waht": "soup"})", "I think it is soup.", R"({"what": 7})", R"({"what": "soup"})", ""};
  const char* reasons[] = {"did you mean \"what\"",
                           "no JSON object",
                           "expected a text",
                           "soup is not sold here",
                           "no JSON object"};
  const auto check = [](const Verdict& v) -> Result<void> {
    if (v.what == "soup") return Error{"x", "answer:/what", "soup is not sold here"};
    return {};
  };
  for (std::size_t i = 0; i < std::size(wrong); ++i) {
    Parrot parrot{{text(wrong[i]), text(R"(Sorry: {"what": "stew"})")}, {}};
    const auto answered = llm::ask<Verdict>(parrot.model(), question(), {check});
    ASSERT_TRUE(answered.ok()) << wrong[i] << to_string(answered.error());
    EXPECT_EQ(answered->value.what, "stew");
    EXPECT_EQ(answered->cost.requests, 2);
    EXPECT_EQ(answered->cost.tokens_in, 20);
    EXPECT_EQ(answered->cost.tokens_out, 6);
    ASSERT_EQ(parrot.asked[1].turns.size(), 3U);
    EXPECT_EQ(parrot.asked[1].turns[0].pictures.size(), 1U);
    EXPECT_EQ(parrot.asked[1].turns[1].role, llm::ChatRole::model);
    EXPECT_NE(parrot.asked[1].turns[2].text.find(reasons[i]), std::string::npos)
        << parrot.asked[1].turns[2].text;
  }
}

TEST(StructuredAnswer, TwiceWrongIsAnError) {
  Parrot parrot{{text(R"({"what": "soup", "size": "tiny"})"), text(R"({"size": "small"})")}, {}};
  const auto answered = llm::ask<Verdict>(parrot.model(), question());
  ASSERT_FALSE(answered.ok());
  EXPECT_EQ(answered.error().code, "llm.bad_answer");
  EXPECT_EQ(answered.error().where, "test:parrot");
  EXPECT_NE(answered.error().message.find("\"what\" is missing"), std::string::npos)
      << answered.error().message;
  EXPECT_EQ(parrot.asked.size(), 2U);
}

TEST(StructuredAnswer, ACutAnswerIsToldSo) {
  llm::ChatAnswer cut = text("{\"what\": \"a very lo");
  cut.cut = true;
  Parrot parrot{{cut, text(R"({"what": "stew"})")}, {}};
  ASSERT_TRUE(llm::ask<Verdict>(parrot.model(), question()).ok());
  EXPECT_NE(parrot.asked[1].turns[2].text.find("cut off at 2048 tokens"), std::string::npos);
}

TEST(StructuredAnswer, TheProvidersErrorsPass) {
  Parrot parrot{{}, {}};
  EXPECT_EQ(llm::ask<Verdict>(parrot.model(), question()).error().message, "silent");
}

TEST(JsonInText, IsFoundAmongProse) {
  EXPECT_EQ(llm::json_object_in(R"({"a": 1})"), R"({"a": 1})");
  EXPECT_EQ(llm::json_object_in("Sure!\n```json\n{\"a\": {\"b\": \"}\\\"{\"}}\n```\nBye {x}"),
            R"({"a": {"b": "}\"{"}})");
  EXPECT_EQ(llm::json_object_in("the set {1, 2} is {\"a\": 2}"), R"({"a": 2})");
  EXPECT_EQ(llm::json_object_in("<think>maybe {\"a\": 1}</think>{\"a\": 3}"), R"({"a": 3})");
  for (const char* none : {"", "no", "{", "{\"a\": ", "[1]", "{a: 1}", "{\"a\": \"}"})
    EXPECT_EQ(llm::json_object_in(none), std::nullopt) << none;
  EXPECT_EQ(llm::json_object_in(std::string(1'000'000, '{')), std::nullopt);  // and soon
}

// What OpenAI's and Anthropic's strict modes ask of a schema.
TEST(AnswerSchema, HasOnlyWhatEveryProviderEnforces) {
  const json schema = json::parse(llm::answer_schema_of(type_of<Verdict>()));
  EXPECT_EQ(schema, json::parse(R"({
    "type": "object", "additionalProperties": false,
    "properties": {
      "what": {"type": "string", "description": "what it is"},
      "size": {"type": "string", "enum": ["small", "large"], "description": "how large"},
      "words": {"type": "array", "items": {"type": "string"}, "description": "about it"},
      "inner": {"$ref": "#/$defs/Inner"}},
    "required": ["what", "size", "words", "inner"],
    "$defs": {"Inner": {
      "type": "object", "additionalProperties": false,
      "properties": {"share": {"type": "number", "description": "of all"}},
      "required": ["share"]}}})"));
}

TEST(AnswerSchema, FieldsCanBeHeldToNames) {
  const std::string_view names[] = {"soup", "stew"};
  const std::string schema = llm::with_names(
      llm::with_names(llm::answer_schema_of(type_of<Verdict>()), "what", names), "words", names);
  const json made = json::parse(schema);
  EXPECT_EQ(made["properties"]["what"]["enum"], json::parse(R"(["soup", "stew"])"));
  EXPECT_EQ(made["properties"]["words"]["items"]["enum"], json::parse(R"(["soup", "stew"])"));
}

}  // namespace
}  // namespace marketgen
