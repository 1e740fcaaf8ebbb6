// Anthropic's messages: https://platform.claude.com/docs/en/api/messages
#include "llm/provider.h"
#include "llm/wire_json.h"

namespace marketgen::llm {
namespace {

constexpr const char* api_version = "2023-06-01";

WireJson anthropic_content(const ChatTurn& turn) {
  WireJson parts = WireJson::array();
  for (const std::string& png : turn.pictures) {
    parts.push_back(
        {{"type", "image"},
         {"source",
          {{"type", "base64"}, {"media_type", "image/png"}, {"data", net::base64_of(png)}}}});
  }
  parts.push_back({{"type", "text"}, {"text", turn.text}});
  return parts;
}

}  // namespace

net::HttpRequest anthropic_request(const ProviderCall& call) {
  WireJson body{{"model", call.model}, {"max_tokens", call.request.max_tokens}};
  if (!call.request.system.empty()) body["system"] = call.request.system;
  if (call.temperature) body["temperature"] = 0;
  WireJson messages = WireJson::array();
  for (const ChatTurn& turn : call.request.turns) {
    const char* role = turn.role == ChatRole::user ? "user" : "assistant";
    messages.push_back({{"role", role}, {"content", anthropic_content(turn)}});
  }
  body["messages"] = std::move(messages);
  if (call.wants_schema()) {
    body["output_config"] = {
        {"format",
         {{"type", "json_schema"}, {"schema", WireJson::parse(call.request.answer_schema)}}}};
  }
  net::HttpRequest request = post_of(call.base_url + "/v1/messages", body);
  request.headers.emplace_back("anthropic-version", api_version);
  request.secret_headers = {{"x-api-key", call.key}};
  return request;
}

Result<ChatAnswer> anthropic_answer(std::string_view body, const std::string& where) {
  MARKETGEN_TRY(const WireJson json, parse_wire(body, where));
  const std::string stop = wire_text(json, "/stop_reason");
  if (stop == "refusal") return declined(where, stop);
  ChatAnswer answer;
  const WireJson* parts = wire_at(json, "/content");
  if (parts != nullptr && parts->is_array()) {
    for (const WireJson& part : *parts) {
      if (wire_text(part, "/type") == "text") answer.text += wire_text(part, "/text");
    }
  }
  answer.model = wire_text(json, "/model");
  answer.tokens_in = wire_number(json, "/usage/input_tokens");
  answer.tokens_out = wire_number(json, "/usage/output_tokens");
  answer.cut = stop == "max_tokens";
  if (answer.text.empty() && !answer.cut) return no_answer(where);
  return answer;
}

}  // namespace marketgen::llm
