// What each provider is sent and what is read from its answer. The expected requests and the
// answers are written by hand after the providers' public documentation; the server compares them.
#include <gtest/gtest.h>

#include <set>

#include "llm/language_model.h"
#include "llm/provider.h"
#include "net/http.h"
#include "support/mock_server.h"

namespace marketgen {
namespace {

using nlohmann::json;

// The environment as a test needs it: nothing of the machine's own.
class Providers : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"OPENAI", "ANTHROPIC", "GEMINI"}) {
      setenv((std::string(name) + "_API_KEY").c_str(), "test-key-123", 1);
      unsetenv((std::string(name) + "_BASE_URL").c_str());
    }
  }

  static Result<llm::ChatAnswer> ask_at(const MockServer& server,
                                        const std::string& name,
                                        const std::string& path,
                                        const llm::ChatRequest& request) {
    llm::ModelChoice choice;
    choice.model = name;
    choice.url = server.url(path);
    choice.limits.first_wait_s = 0.01;
    MARKETGEN_TRY(const llm::LanguageModel model, llm::open_language_model(choice));
    EXPECT_EQ(model.name, name);
    return model.chat(request);
  }
};

// A question with a picture, what was said to it, and a question to that.
llm::ChatRequest conversation() {
  llm::ChatRequest request;
  request.system = "You see packs.";
  request.turns = {{llm::ChatRole::user, "What is it?", {"PNG"}},  // "UE5H" in base64
                   {llm::ChatRole::model, "Soup.", {}},
                   {llm::ChatRole::user, "Sure?", {}}};
  request.answer_schema =
      R"({"type":"object","additionalProperties":false,"properties":{"sure":{"type":"boolean"}},"required":["sure"]})";
  request.max_tokens = 77;
  return request;
}

TEST_F(Providers, OpenAi) {
  const MockServer server(json::parse(R"([{
    "expect": {
      "method": "POST", "path": "/v1/chat/completions",
      "headers": {"Authorization": "Bearer test-key-123", "Content-Type": "application/json"},
      "json": {
        "model": "gpt-4o-mini",
        "messages": [
          {"role": "system", "content": "You see packs."},
          {"role": "user", "content": [
            {"type": "image_url", "image_url": {"url": "data:image/png;base64,UE5H"}},
            {"type": "text", "text": "What is it?"}]},
          {"role": "assistant", "content": "Soup."},
          {"role": "user", "content": "Sure?"}],
        "max_tokens": 77,
        "temperature": 0,
        "response_format": {"type": "json_schema", "json_schema": {
          "name": "answer", "strict": true,
          "schema": {"type": "object", "additionalProperties": false,
                     "properties": {"sure": {"type": "boolean"}}, "required": ["sure"]}}}}},
    "body": {
      "id": "chatcmpl-123", "object": "chat.completion", "created": 1677652288,
      "model": "gpt-4o-mini-2024-07-18",
      "choices": [{"index": 0, "message": {"role": "assistant", "content": "{\"sure\": true}",
                   "refusal": null, "annotations": []}, "logprobs": null, "finish_reason": "stop"}],
      "usage": {"prompt_tokens": 82, "completion_tokens": 17, "total_tokens": 99}}
  }])"));
  const auto answer = ask_at(server, "openai:gpt-4o-mini", "/v1/", conversation());
  ASSERT_TRUE(answer.ok()) << to_string(answer.error());
  EXPECT_EQ(answer->text, "{\"sure\": true}");
  EXPECT_EQ(answer->model, "gpt-4o-mini-2024-07-18");
  EXPECT_EQ(answer->tokens_in, 82);
  EXPECT_EQ(answer->tokens_out, 17);
  EXPECT_FALSE(answer->cut);
}

TEST_F(Providers, Anthropic) {
  const MockServer server(json::parse(R"([{
    "expect": {
      "method": "POST", "path": "/v1/messages",
      "headers": {"x-api-key": "test-key-123", "anthropic-version": "2023-06-01",
                  "Content-Type": "application/json", "Authorization": null},
      "json": {
        "model": "claude-sonnet-4-5", "max_tokens": 77, "temperature": 0,
        "system": "You see packs.",
        "messages": [
          {"role": "user", "content": [
            {"type": "image", "source": {"type": "base64", "media_type": "image/png", "data": "UE5H"}},
            {"type": "text", "text": "What is it?"}]},
          {"role": "assistant", "content": [{"type": "text", "text": "Soup."}]},
          {"role": "user", "content": [{"type": "text", "text": "Sure?"}]}],
        "output_config": {"format": {"type": "json_schema",
          "schema": {"type": "object", "additionalProperties": false,
                     "properties": {"sure": {"type": "boolean"}}, "required": ["sure"]}}}}},
    "body": {
      "id": "msg_013Zva2CMHLNnXjNJJKqJ2EF", "type": "message", "role": "assistant",
      "model": "claude-sonnet-4-5-20250929",
      "content": [{"type": "thinking", "thinking": "hm", "signature": "x"},
                  {"type": "text", "text": "{\"sure\": false}"}],
      "stop_reason": "end_turn", "stop_sequence": null,
      "usage": {"input_tokens": 2095, "output_tokens": 503, "cache_read_input_tokens": 0}}
  }])"));
  const auto answer = ask_at(server, "anthropic:claude-sonnet-4-5", "", conversation());
  ASSERT_TRUE(answer.ok()) << to_string(answer.error());
  EXPECT_EQ(answer->text, "{\"sure\": false}");
  EXPECT_EQ(answer->model, "claude-sonnet-4-5-20250929");
  EXPECT_EQ(answer->tokens_in, 2095);
  EXPECT_EQ(answer->tokens_out, 503);
}

TEST_F(Providers, Gemini) {
  const MockServer server(json::parse(R"([{
    "expect": {
      "method": "POST", "path": "/v1beta/models/gemini-2.5-flash:generateContent",
      "headers": {"x-goog-api-key": "test-key-123", "Content-Type": "application/json"},
      "json": {
        "systemInstruction": {"parts": [{"text": "You see packs."}]},
        "contents": [
          {"role": "user", "parts": [
            {"inlineData": {"mimeType": "image/png", "data": "UE5H"}}, {"text": "What is it?"}]},
          {"role": "model", "parts": [{"text": "Soup."}]},
          {"role": "user", "parts": [{"text": "Sure?"}]}],
        "generationConfig": {
          "maxOutputTokens": 77, "temperature": 0, "responseMimeType": "application/json",
          "responseJsonSchema": {"type": "object", "additionalProperties": false,
            "properties": {"sure": {"type": "boolean"}}, "required": ["sure"]}}}},
    "body": {
      "candidates": [{"content": {"role": "model", "parts": [
          {"text": "let me see", "thought": true}, {"text": "{\"sure\":"}, {"text": " true}"}]},
        "finishReason": "STOP", "index": 0}],
      "usageMetadata": {"promptTokenCount": 264, "candidatesTokenCount": 80,
                        "thoughtsTokenCount": 20, "totalTokenCount": 364},
      "modelVersion": "gemini-2.5-flash-001"}
  }])"));
  const auto answer = ask_at(server, "gemini:gemini-2.5-flash", "/v1beta", conversation());
  ASSERT_TRUE(answer.ok()) << to_string(answer.error());
  EXPECT_EQ(answer->text, "{\"sure\": true}");
  EXPECT_EQ(answer->model, "gemini-2.5-flash-001");
  EXPECT_EQ(answer->tokens_in, 264);
  EXPECT_EQ(answer->tokens_out, 100);
}

TEST_F(Providers, WithoutSystemTextPictureOrSchemaTheRequestIsPlain) {
  const MockServer server(json::parse(R"([{
    "expect": {"path": "/chat/completions", "json": {
      "model": "llama3.2-vision:11b", "messages": [{"role": "user", "content": "Hello"}],
      "max_tokens": 2048, "temperature": 0}},
    "body": {"choices": [{"message": {"content": "Hi"}}]}}])"));
  llm::ChatRequest request;
  request.turns = {{llm::ChatRole::user, "Hello", {}}};
  const auto answer = ask_at(server, "openai:llama3.2-vision:11b", "", request);
  ASSERT_TRUE(answer.ok()) << to_string(answer.error());
  EXPECT_EQ(answer->text, "Hi");
}

TEST_F(Providers, AnswersThatWereCut) {
  const std::vector<std::pair<std::string, const char*>> cut = {
      {"openai:m", R"({"choices": [{"message": {"content": "{"}, "finish_reason": "length"}]})"},
      {"anthropic:m",
       R"({"content": [{"type": "text", "text": "{"}], "stop_reason": "max_tokens"})"},
      {"gemini:m",
       R"({"candidates": [{"content": {"parts": [{"text": "{"}]}, "finishReason": "MAX_TOKENS"}]})"}};
  for (const auto& [name, body] : cut) {
    const MockServer server(json::array({{{"body", body}}}));
    const auto answer = ask_at(server, name, "", conversation());
    ASSERT_TRUE(answer.ok()) << name << to_string(answer.error());
    EXPECT_TRUE(answer->cut) << name;
    EXPECT_EQ(answer->text, "{");
  }
}

TEST_F(Providers, ModelsThatDeclineAndAnswersThatAreNone) {
  const std::vector<std::pair<std::string, const char*>> cases = {
      {"openai:m", R"({"choices": [{"message": {"content": null, "refusal": "I cannot"}}]})"},
      {"openai:m",
       R"({"choices": [{"message": {"content": ""}, "finish_reason": "content_filter"}]})"},
      {"openai:m", R"({"choices": []})"},
      {"openai:m", R"({"choices": {"0": 7}})"},
      {"anthropic:m", R"({"content": [], "stop_reason": "refusal"})"},
      {"anthropic:m", R"({"content": "text"})"},
      {"gemini:m", R"({"promptFeedback": {"blockReason": "SAFETY"}})"},
      {"gemini:m", R"({"candidates": [{"finishReason": "SAFETY"}]})"},
      {"gemini:m", R"({})"},
      {"openai:m", "<html>login</html>"},
      {"anthropic:m", "[]"},
      {"gemini:m", "{\"candidates\": ["}};
  for (const auto& [name, body] : cases) {
    const MockServer server(json::array({{{"body", body}}}));
    const auto answer = ask_at(server, name, "", conversation());
    ASSERT_FALSE(answer.ok()) << name << body;
    EXPECT_EQ(answer.error().code, "llm.refused") << body;
    EXPECT_EQ(answer.error().where, name);
  }
}

// Some models take neither temperature 0 nor a schema; they are asked again without.
TEST_F(Providers, WhatAModelDoesNotTakeIsLeftOut) {
  const MockServer server(json::parse(R"([
    {"status": 400, "body": {"error": {"message": "Unsupported value: 'temperature' does not support 0",
                                       "type": "invalid_request_error"}}},
    {"status": 400, "body": {"error": {"message": "response_format json_schema is not supported"}}},
    {"expect": {"json": {"model": "o9", "max_tokens": 5, "messages": [{"role": "user", "content": "x"}]}},
     "body": {"choices": [{"message": {"content": "done"}}]}}])"));
  llm::ChatRequest request;
  request.turns = {{llm::ChatRole::user, "x", {}}};
  request.answer_schema = R"({"type": "object"})";
  request.max_tokens = 5;
  const auto answer = ask_at(server, "openai:o9", "", request);
  ASSERT_TRUE(answer.ok()) << to_string(answer.error());
  EXPECT_EQ(answer->text, "done");
  EXPECT_EQ(server.requests().size(), 3U);
}

TEST_F(Providers, WhatTheProviderSaysIsPassedOnButNoKey) {
  struct Case {
    int status;
    const char* body;
    const char* says;
  };
  const Case cases[] = {
      {400, R"({"error": {"message": "image too large"}})", "HTTP 400: \"image too large\""},
      {401,
       R"({"error": {"message": "Incorrect API key: test-key-123"}})",
       "look at OPENAI_API_KEY"},
      {404, R"({"error": "model 'x' not found"})", "the model's name"},
      {400, "plain text", "HTTP 400"}};
  for (const Case& c : cases) {
    const MockServer server(json::array({{{"status", c.status}, {"body", c.body}}}));
    const auto answer = ask_at(server, "openai:x", "", conversation());
    ASSERT_FALSE(answer.ok());
    EXPECT_EQ(answer.error().code, "llm.refused");
    const std::string said = to_string(answer.error());
    EXPECT_NE(said.find(c.says), std::string::npos) << said;
    EXPECT_EQ(said.find("test-key-123"), std::string::npos) << said;
  }
}

TEST_F(Providers, TooManyRequestsForGoodAndTrouble) {
  for (const int status : {429, 500}) {
    const MockServer server(json::array({{{"status", status}}}));
    const auto answer = ask_at(server, "openai:x", "", conversation());
    ASSERT_FALSE(answer.ok());
    EXPECT_EQ(answer.error().code, "llm.refused");
    EXPECT_NE(answer.error().message.find("try again later"), std::string::npos);
    EXPECT_EQ(server.requests().size(), 4U);
  }
}

Error refused(const std::string& model, const std::string& url = "") {
  llm::ModelChoice choice;
  choice.model = model;
  choice.url = url;
  const auto opened = llm::open_language_model(choice);
  return opened.ok() ? Error{} : opened.error();
}

TEST_F(Providers, NamesThatAreNone) {
  EXPECT_EQ(refused("opnai:gpt-4o").code, "llm.unknown_provider");
  EXPECT_NE(refused("opnai:gpt-4o").message.find("did you mean \"openai\""), std::string::npos);
  EXPECT_NE(refused("zzz:x").message.find("openai, anthropic, gemini"), std::string::npos);
  for (const char* name :
       {"openai", "openai:", "", ":", "openai:a b", "openai:a?key=1", "gemini:../x"})
    EXPECT_EQ(refused(name).code, "llm.unknown_provider") << name;
}

TEST_F(Providers, MissingKeysAreNamed) {
  for (const auto& [model, variable] : {std::pair{"openai:x", "OPENAI_API_KEY"},
                                        std::pair{"anthropic:x", "ANTHROPIC_API_KEY"},
                                        std::pair{"gemini:x", "GEMINI_API_KEY"}}) {
    unsetenv(variable);
    EXPECT_EQ(refused(model).code, "llm.no_key");
    EXPECT_EQ(refused(model).where, variable);
    setenv(variable, "two words", 1);
    EXPECT_EQ(refused(model).code, "llm.no_key");
  }
  unsetenv("OPENAI_API_KEY");
  EXPECT_EQ(refused("openai:x", "http://localhost:11434/v1").code, "");  // Ollama needs none
  unsetenv("ANTHROPIC_API_KEY");
  EXPECT_EQ(refused("anthropic:x", "http://localhost:1/").code, "llm.no_key");
}

TEST_F(Providers, AServerWithoutKeysGetsNoHeader) {
  unsetenv("OPENAI_API_KEY");
  const MockServer server(json::parse(R"([{"expect": {"headers": {"Authorization": null}},
    "body": {"choices": [{"message": {"content": "Hi"}}]}}])"));
  const auto answer = ask_at(server, "openai:x", "", conversation());
  EXPECT_TRUE(answer.ok()) << to_string(answer.error());
}

TEST_F(Providers, UrlsThatWouldGiveTheKeyAway) {
  EXPECT_EQ(refused("openai:x", "http://example.org/v1").code, "net.bad_url");
  EXPECT_NE(refused("openai:x", "http://example.org/v1").message.find("OPENAI_API_KEY"),
            std::string::npos);
  EXPECT_EQ(refused("gemini:x", "https://example.org/v1?key=abc").code, "net.bad_url");
  EXPECT_EQ(to_string(refused("gemini:x", "https://example.org/v1?key=abc")).find("abc"),
            std::string::npos);
  EXPECT_EQ(refused("openai:x", "localhost").code, "net.bad_url");
}

TEST_F(Providers, TheEnvironmentNamesAnotherServer) {
  const MockServer server(
      json::array({{{"body", {{"choices", json::array({{{"message", {{"content", "Hi"}}}}})}}}}}));
  setenv("OPENAI_BASE_URL", server.url("/here").c_str(), 1);
  llm::ModelChoice choice;
  choice.model = "openai:x";
  llm::ChatRequest request;
  request.turns = {{llm::ChatRole::user, "x", {}}};
  const auto answer = llm::open_language_model(choice).value().chat(request);
  unsetenv("OPENAI_BASE_URL");
  ASSERT_TRUE(answer.ok()) << to_string(answer.error());
  EXPECT_EQ(server.requests().at(0)["path"], "/here/chat/completions");
}

// The key in the environment, in a 401 that repeats it, and in what was recorded.
TEST_F(Providers, RecordsReplayWithoutKeyAndServer) {
  const ScratchFolder scratch;
  MockServer server(
      json::array({{{"body",
                     {{"model", "m test-key-123"},
                      {"choices", json::array({{{"message", {{"content", "grün"}}}}})}}}}}));
  llm::ModelChoice choice;
  choice.model = "openai:x";
  choice.url = server.url();
  choice.record = scratch.path() / "tape";
  const auto live = llm::open_language_model(choice).value().chat(conversation());
  ASSERT_TRUE(live.ok()) << to_string(live.error());
  EXPECT_EQ(live->model, "m ***");
  server.stop();
  EXPECT_EQ(all_text_in(scratch.path()).find("test-key-123"), std::string::npos);
  choice.replay = std::exchange(choice.record, {});
  unsetenv("OPENAI_API_KEY");
  const auto again = llm::open_language_model(choice).value().chat(conversation());
  ASSERT_TRUE(again.ok()) << to_string(again.error());
  EXPECT_EQ(again->text, "grün");
  EXPECT_EQ(again->model, live->model);
  llm::ChatRequest other = conversation();
  other.turns[0].text = "What else?";
  EXPECT_EQ(llm::open_language_model(choice).value().chat(other).error().code, "net.not_recorded");
}

// Every entry of providers.inc.
TEST(ProviderList, KeysTravelInSecretHeadersAndGarbageIsRefused) {
  std::set<std::string_view> names, variables;
  const llm::ChatRequest request = conversation();
  for (const llm::ProviderRow& row : llm::providers()) {
    SCOPED_TRACE(row.name);
    EXPECT_TRUE(names.insert(row.name).second);
    EXPECT_TRUE(variables.insert(row.key_variable).second);
    EXPECT_TRUE(variables.insert(row.url_variable).second);
    EXPECT_EQ(net::origin_of(std::string(row.base_url))->scheme, "https");
    llm::ProviderCall call{request, "some-model", std::string(row.base_url), true, "the-key-789"};
    const net::HttpRequest made = row.request(call);
    EXPECT_EQ(made.method, "POST");
    EXPECT_TRUE(made.url.starts_with(row.base_url)) << made.url;
    EXPECT_TRUE(json::accept(made.body));
    ASSERT_EQ(made.secret_headers.size(), 1U);
    EXPECT_NE(made.secret_headers[0].value.find("the-key-789"), std::string::npos);
    std::string open = made.url + made.body;
    for (const net::HttpHeader& header : made.headers)
      open += header.name + header.value;
    EXPECT_EQ(open.find("the-key-789"), std::string::npos);
    EXPECT_NE(made.body.find("\"sure\""), std::string::npos);  // the schema
    call.keep_schema = false;
    EXPECT_EQ(row.request(call).body.find("\"sure\""), std::string::npos);
    for (const char* garbage :
         {"", "null", "{}", "[]", "\xff", "{\"choices\": 1}", "{\"candidates\": []}"})
      EXPECT_EQ(row.answer(garbage, "here").error().code, "llm.refused") << garbage;
  }
}

// OpenAI's reasoning models refuse the older name of the token limit, older servers the newer.
TEST(ProviderList, OpenAisOwnServerIsToldTheNewerName) {
  llm::ChatRequest request;
  request.turns = {{llm::ChatRole::user, "x", {}}};
  const std::string own =
      llm::openai_request({request, "m", "https://api.openai.com/v1", true, "k"}).body;
  EXPECT_EQ(json::parse(own)["max_completion_tokens"], 2048);
  EXPECT_FALSE(json::parse(own).contains("max_tokens"));
}

}  // namespace
}  // namespace marketgen
