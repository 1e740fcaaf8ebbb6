// OpenAI's chat completions, which many servers speak:
// https://platform.openai.com/docs/api-reference/chat
#include "llm/provider.h"
#include "llm/wire_json.h"

namespace marketgen::llm {
namespace {

WireJson openai_content(const ChatTurn& turn) {
  if (turn.pictures.empty()) return turn.text;
  WireJson parts = WireJson::array();
  for (const std::string& png : turn.pictures) {
    const std::string url = "data:image/png;base64," + net::base64_of(png);
    parts.push_back({{"type", "image_url"}, {"image_url", {{"url", url}}}});
  }
  parts.push_back({{"type", "text"}, {"text", turn.text}});
  return parts;
}

WireJson openai_messages(const ChatRequest& request) {
  WireJson messages = WireJson::array();
  if (!request.system.empty())
    messages.push_back({{"role", "system"}, {"content", request.system}});
  for (const ChatTurn& turn : request.turns) {
    const char* role = turn.role == ChatRole::user ? "user" : "assistant";
    messages.push_back({{"role", role}, {"content", openai_content(turn)}});
  }
  return messages;
}

}  // namespace

net::HttpRequest openai_request(const ProviderCall& call) {
  WireJson body{{"model", call.model}, {"messages", openai_messages(call.request)}};
  // OpenAI's reasoning models know only the newer name, older servers of others only the older.
  body[call.own_server ? "max_completion_tokens" : "max_tokens"] = call.request.max_tokens;
  if (call.temperature) body["temperature"] = 0;
  if (call.wants_schema()) {
    body["response_format"] = {{"type", "json_schema"},
                               {"json_schema",
                                {{"name", "answer"},
                                 {"strict", true},
                                 {"schema", WireJson::parse(call.request.answer_schema)}}}};
  }
  net::HttpRequest request = post_of(call.base_url + "/chat/completions", body);
  if (!call.key.empty()) request.secret_headers = {{"Authorization", "Bearer " + call.key}};
  return request;
}

Result<ChatAnswer> openai_answer(std::string_view body, const std::string& where) {
  MARKETGEN_TRY(const WireJson json, parse_wire(body, where));
  if (const std::string why = wire_text(json, "/choices/0/message/refusal"); !why.empty())
    return declined(where, why);
  const std::string finish = wire_text(json, "/choices/0/finish_reason");
  if (finish == "content_filter") return declined(where, finish);
  ChatAnswer answer;
  answer.text = wire_text(json, "/choices/0/message/content");
  answer.model = wire_text(json, "/model");
  answer.tokens_in = wire_number(json, "/usage/prompt_tokens");
  answer.tokens_out = wire_number(json, "/usage/completion_tokens");
  answer.cut = finish == "length";
  if (answer.text.empty() && !answer.cut) return no_answer(where);
  return answer;
}

}  // namespace marketgen::llm
