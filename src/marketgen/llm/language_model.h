// Language models that see pictures, whoever offers them, behind one function.
//
//   MARKETGEN_TRY(const LanguageModel model, open_language_model({.model = "openai:gpt-4o-mini"}));
//   MARKETGEN_TRY(const ChatAnswer answer, model.chat({.turns = {{.text = "Hello"}}}));
//
// A model is named PROVIDER:MODEL; providers.inc lists the providers. Keys are read from the
// environment and from nowhere else. llm/structured_answer.h asks for JSON of a described struct.
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "net/http.h"

namespace marketgen::llm {

enum class ChatRole { user, model };

struct ChatTurn {
  ChatRole role = ChatRole::user;
  std::string text;                   // UTF-8
  std::vector<std::string> pictures;  // bytes of PNG files, before the text; of the user only
};

struct ChatRequest {
  std::string system;           // what the model is and must keep to; may be empty
  std::vector<ChatTurn> turns;  // the user's first and last, in turn
  std::string answer_schema;    // JSON Schema that the answer must follow; empty: free text
  int max_tokens = 2048;        // of the answer
};

struct ChatAnswer {
  std::string text;
  std::string model;  // as the provider names what answered
  std::int64_t tokens_in = 0, tokens_out = 0;
  bool cut = false;  // ended by max_tokens
};

struct LanguageModel {
  std::string name;  // "openai:gpt-4o-mini"
  // At temperature 0. With a schema the provider is told to keep to it where it can be told; where
  // it refuses to (400), the request is sent again without. Errors: llm.refused; those of
  // HttpClient::send.
  std::function<Result<ChatAnswer>(const ChatRequest&)> chat;
};

struct ModelChoice {
  std::string model;                       // PROVIDER:MODEL
  std::string url;                         // base URL; empty: the provider's variable, else its own
  std::filesystem::path record;            // as HttpOptions
  std::filesystem::path replay;            // as HttpOptions; no key is needed then
  net::HttpLimits limits{.total_s = 300};  // a thinking model, or one on a small machine
};

// Errors: llm.unknown_provider with the nearest name; llm.no_key with the variable to set;
// net.bad_url, also when a key would be sent unencrypted to another machine; those of
// HttpClient::open.
Result<LanguageModel> open_language_model(const ModelChoice& choice);

// "openai, anthropic, gemini".
std::string provider_names();

}  // namespace marketgen::llm
