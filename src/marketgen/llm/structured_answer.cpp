#include "llm/structured_answer.h"

#include <array>

#include <fmt/format.h>

#include "llm/wire_json.h"

namespace marketgen::llm {
namespace {

// Keywords that OpenAI's and Anthropic's strict modes refuse, or that say nothing to a model.
constexpr std::array dropped_keywords = {"$schema",
                                         "$id",
                                         "title",
                                         "default",
                                         "minimum",
                                         "maximum",
                                         "maxLength",
                                         "minItems",
                                         "maxItems",
                                         "pattern"};

void make_strict(WireJson& schema);

void make_members_strict(WireJson& members) {
  for (auto& [name, member] : members.items())
    make_strict(member);
}

// A schema is an object of keywords; "properties" and "$defs" hold schemas by name.
void make_strict(WireJson& schema) {
  if (!schema.is_object()) return;
  if (schema.contains("$ref")) {  // stands alone
    schema = WireJson{{"$ref", schema["$ref"]}};
    return;
  }
  if (schema.contains("enum")) schema["type"] = "string";  // a type is never left out
  for (const char* keyword : dropped_keywords)
    schema.erase(keyword);
  for (const char* holder : {"properties", "$defs"}) {
    if (schema.contains(holder)) make_members_strict(schema[holder]);
  }
  if (schema.contains("items")) make_strict(schema["items"]);
  if (schema.contains("anyOf")) {
    for (WireJson& choice : schema["anyOf"])
      make_strict(choice);
  }
  if (!schema.contains("properties")) return;
  WireJson required = WireJson::array();
  for (const auto& [name, property] : schema["properties"].items())
    required.push_back(name);
  schema["required"] = std::move(required);
}

// The end of the object that begins at `start`, or npos when it never closes.
std::size_t end_of_object(std::string_view text, std::size_t start) {
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = start; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted) {
      if (c == '\\') ++i;
      quoted = c != '"';
      continue;
    }
    if (c == '"') quoted = true;
    if (c == '{') ++depth;
    if (c == '}' && --depth == 0) return i + 1;
  }
  return std::string_view::npos;
}

std::string_view after_thoughts(std::string_view text) {
  constexpr std::string_view end = "</think>";  // as Qwen and DeepSeek write them
  const std::size_t at = text.rfind(end);
  return at == std::string_view::npos ? text : text.substr(at + end.size());
}

std::string with_schema_in_words(const std::string& system, const std::string& schema) {
  return fmt::format(
      "{}{}Answer with one JSON object that follows this JSON Schema, and with nothing else:\n{}",
      system,
      system.empty() ? "" : "\n\n",
      schema);
}

// What is wrong with an answer.
Result<void> fault_of(const ChatAnswer& answer, int max_tokens, const AnswerReader& read) {
  const std::optional<std::string> json = json_object_in(answer.text);
  if (json) return read(*json);
  const std::string why = answer.cut
                              ? fmt::format("it was cut off at {} tokens; be shorter", max_tokens)
                              : std::string("it holds no JSON object");
  return Error{"json.syntax", "answer", why};
}

void add_repair_turn(ChatRequest& request, const ChatAnswer& answer, const Error& fault) {
  const std::string said = answer.text.empty() ? "(nothing)" : answer.text;
  request.turns.push_back({ChatRole::model, said, {}});
  request.turns.push_back(
      {ChatRole::user,
       fmt::format("That answer cannot be used: {}: {}\nAnswer again with the whole JSON object, "
                   "this mended, and nothing else.",
                   fault.where,
                   fault.message),
       {}});
}

}  // namespace

std::string answer_schema_of(const TypeInfo& type) {
  WireJson schema = WireJson::parse(io::json_schema_of(type, "", ""));
  make_strict(schema);
  return wire_dump(schema);
}

std::string with_names(const std::string& schema,
                       std::string_view field,
                       std::span<const std::string_view> names) {
  WireJson json = WireJson::parse(schema);
  const std::string name(field);
  if (!json.contains("properties") || !json["properties"].contains(name))
    fatal("with_names() of a field that the schema does not have");
  WireJson& property = json["properties"][name];
  WireJson& holder = property.contains("items") ? property["items"] : property;
  holder["enum"] = names;
  return wire_dump(json);
}

std::optional<std::string> json_object_in(std::string_view text) {
  constexpr int max_tries = 64;  // each may read to the end of the text
  text = after_thoughts(text);
  std::size_t start = text.find('{');
  for (int tried = 0; tried < max_tries && start != std::string_view::npos; ++tried) {
    const std::size_t end = end_of_object(text, start);
    if (end != std::string_view::npos) {
      const std::string_view object = text.substr(start, end - start);
      if (WireJson::accept(object)) return std::string(object);
    }
    start = text.find('{', start + 1);
  }
  return std::nullopt;
}

Result<AnswerCost> ask_for_json(const LanguageModel& model,
                                ChatRequest request,
                                const AnswerReader& read) {
  constexpr int max_requests = 2;
  request.system = with_schema_in_words(request.system, request.answer_schema);
  AnswerCost cost;
  for (;;) {
    MARKETGEN_TRY(const ChatAnswer answer, model.chat(request));
    ++cost.requests;
    cost.tokens_in += answer.tokens_in;
    cost.tokens_out += answer.tokens_out;
    const Result<void> sound = fault_of(answer, request.max_tokens, read);
    if (sound.ok()) return cost;
    if (sound.error().code == "internal.interrupted") return sound.error();
    if (cost.requests == max_requests) {
      return Error{"llm.bad_answer",
                   model.name,
                   fmt::format("its answer cannot be used, nor could its second: {}: {}",
                               sound.error().where,
                               sound.error().message)};
    }
    add_repair_turn(request, answer, sound.error());
  }
}

}  // namespace marketgen::llm
