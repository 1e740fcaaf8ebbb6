// The two halves of a provider, declared from providers.inc: a request for what is asked, and what
// its answer says.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "llm/language_model.h"

namespace marketgen::llm {

// What a provider is to be told.
struct ProviderCall {
  const ChatRequest& request;
  std::string model;
  std::string base_url;     // without a slash at its end
  bool own_server = false;  // base_url is the provider's own
  std::string key;          // may be empty
  bool keep_schema = true;  // tell it to keep to the answer's schema
  bool wants_schema() const { return keep_schema && !request.answer_schema.empty(); }
  bool temperature = true;  // tell it temperature 0; some models take no other than their own
};

struct ProviderRow {
  std::string_view name, description, base_url, url_variable, key_variable;
  net::HttpRequest (*request)(const ProviderCall& call);
  // Of an answer with status 200. Error: llm.refused, when it is none or the model declines.
  Result<ChatAnswer> (*answer)(std::string_view body, const std::string& where);
};
const std::vector<ProviderRow>& providers();

#define PROVIDER(name, description, base_url, url_variable, key_variable) \
  net::HttpRequest name##_request(const ProviderCall& call);              \
  Result<ChatAnswer> name##_answer(std::string_view body, const std::string& where);
#include "llm/providers.inc"
#undef PROVIDER

}  // namespace marketgen::llm
