// Gemini's generateContent: https://ai.google.dev/api/generate-content
#include "llm/provider.h"
#include "llm/wire_json.h"

namespace marketgen::llm {
namespace {

WireJson gemini_parts(const ChatTurn& turn) {
  WireJson parts = WireJson::array();
  for (const std::string& png : turn.pictures)
    parts.push_back({{"inlineData", {{"mimeType", "image/png"}, {"data", net::base64_of(png)}}}});
  parts.push_back({{"text", turn.text}});
  return parts;
}

}  // namespace

net::HttpRequest gemini_request(const ProviderCall& call) {
  WireJson body = WireJson::object();
  if (!call.request.system.empty())
    body["systemInstruction"] = {{"parts", WireJson::array({{{"text", call.request.system}}})}};
  WireJson contents = WireJson::array();
  for (const ChatTurn& turn : call.request.turns) {
    const char* role = turn.role == ChatRole::user ? "user" : "model";
    contents.push_back({{"role", role}, {"parts", gemini_parts(turn)}});
  }
  body["contents"] = std::move(contents);
  WireJson config{{"maxOutputTokens", call.request.max_tokens}};
  if (call.temperature) config["temperature"] = 0;
  if (call.wants_schema()) {
    config["responseMimeType"] = "application/json";
    config["responseJsonSchema"] = WireJson::parse(call.request.answer_schema);
  }
  body["generationConfig"] = std::move(config);
  net::HttpRequest request =
      post_of(call.base_url + "/models/" + call.model + ":generateContent", body);
  request.secret_headers = {{"x-goog-api-key", call.key}};  // never `?key=`: a URL is recorded
  return request;
}

Result<ChatAnswer> gemini_answer(std::string_view body, const std::string& where) {
  MARKETGEN_TRY(const WireJson json, parse_wire(body, where));
  if (const std::string why = wire_text(json, "/promptFeedback/blockReason"); !why.empty())
    return declined(where, why);
  ChatAnswer answer;
  const WireJson* parts = wire_at(json, "/candidates/0/content/parts");
  if (parts != nullptr && parts->is_array()) {
    for (const WireJson& part : *parts) {
      const WireJson* thought = wire_at(part, "/thought");
      if (thought == nullptr || *thought != true) answer.text += wire_text(part, "/text");
    }
  }
  const std::string finish = wire_text(json, "/candidates/0/finishReason");
  answer.model = wire_text(json, "/modelVersion");
  answer.tokens_in = wire_number(json, "/usageMetadata/promptTokenCount");
  answer.tokens_out = wire_number(json, "/usageMetadata/candidatesTokenCount") +
                      wire_number(json, "/usageMetadata/thoughtsTokenCount");
  answer.cut = finish == "MAX_TOKENS";
  if (answer.text.empty() && !answer.cut)
    return finish.empty() || finish == "STOP" ? no_answer(where) : declined(where, finish);
  return answer;
}

}  // namespace marketgen::llm
