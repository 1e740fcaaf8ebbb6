#include "llm/language_model.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.h"
#include "llm/provider.h"
#include "llm/wire_json.h"

namespace marketgen::llm {

const std::vector<ProviderRow>& providers() {
  static const std::vector<ProviderRow> rows = {
#define PROVIDER(name, description, base_url, url_variable, key_variable) \
  {#name, description, base_url, url_variable, key_variable, name##_request, name##_answer},
#include "llm/providers.inc"
#undef PROVIDER
  };
  return rows;
}

namespace {

std::vector<std::string_view> names_of_providers() {
  std::vector<std::string_view> names;
  for (const ProviderRow& row : providers())
    names.push_back(row.name);
  return names;
}

// The variable's value without the blanks that copying brings; empty when it is not set.
std::string from_environment(std::string_view variable) {
  const char* value = std::getenv(std::string(variable).c_str());
  return value == nullptr ? std::string() : std::string(trimmed(value));
}

bool is_printable(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c > ' ' && c < '\x7f'; });
}

// One provider, one model, one key.
struct Connection {
  const ProviderRow* provider = nullptr;
  std::string model, base_url, key;
  bool own_server = false;
  net::HttpClient http;

  std::string name() const { return fmt::format("{}:{}", provider->name, model); }
};

Result<const ProviderRow*> provider_called(std::string_view name) {
  for (const ProviderRow& row : providers()) {
    if (row.name == name) return &row;
  }
  const std::vector<std::string_view> known = names_of_providers();
  return Error{"llm.unknown_provider",
               std::string(name),
               fmt::format("no such provider{}; write PROVIDER:MODEL with one of: {}",
                           did_you_mean(name, known),
                           fmt::join(known, ", "))};
}

Result<std::string> checked_model(const std::string& choice, std::string_view model) {
  constexpr std::size_t longest = 200;
  if (model.empty()) {
    return Error{"llm.unknown_provider",
                 choice,
                 "names no model; write PROVIDER:MODEL, as openai:gpt-4o-mini"};
  }
  constexpr std::string_view wrong = "?#%&\"\\";  // it becomes part of a URL
  if (model.size() > longest || !is_printable(model) ||
      model.find_first_of(wrong) != std::string_view::npos ||
      model.find("..") != std::string_view::npos)
    return Error{"llm.unknown_provider", choice, "is no name of a model"};
  return std::string(model);
}

Result<std::string> checked_url(const ModelChoice& choice, const ProviderRow& provider) {
  std::string url = choice.url.empty() ? from_environment(provider.url_variable) : choice.url;
  if (url.empty()) url = provider.base_url;
  while (url.ends_with('/'))
    url.pop_back();
  if (auto origin = net::origin_of(url); !origin.ok()) return origin.error();
  if (url.find_first_of("?#") != std::string::npos) {
    return Error{"net.bad_url",
                 url.substr(0, url.find_first_of("?#")),
                 "a base URL has no query: keys belong into the environment"};
  }
  return url;
}

Result<std::string> checked_key(const ModelChoice& choice, const Connection& connection) {
  const ProviderRow& provider = *connection.provider;
  std::string key = from_environment(provider.key_variable);
  const std::string variable(provider.key_variable);
  if (!choice.replay.empty()) return key;  // nothing is sent
  const bool may_be_open = provider.name == "openai" && !connection.own_server;
  if (key.empty() && !may_be_open) {
    return Error{
        "llm.no_key",
        variable,
        fmt::format("is not set: {} needs a key in this environment variable", provider.name)};
  }
  if (!is_printable(key))
    return Error{"llm.no_key", variable, "has blanks or characters that no key has"};
  MARKETGEN_TRY(const net::HttpOrigin origin, net::origin_of(connection.base_url));
  if (!key.empty() && origin.scheme == "http" && !origin.loopback) {
    return Error{"net.bad_url",
                 connection.base_url,
                 fmt::format("the key of {} would go to another machine unencrypted; use https, "
                             "or unset the variable if the server needs no key",
                             variable)};
  }
  return key;
}

// What a provider says went wrong, in short.
std::string complaint_of(const net::HttpAnswer& answer) {
  constexpr std::size_t longest = 300;
  const WireJson json = WireJson::parse(answer.body, nullptr, false);
  std::string said;
  if (json.is_object()) {
    for (const char* place : {"/error/message", "/error", "/message", "/detail"}) {
      if (said.empty()) said = wire_text(json, place);
    }
  }
  if (!is_utf8(said)) said.clear();
  for (char& c : said)
    c = static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  while (said.size() > longest || !is_utf8(said))
    said.resize(std::min(said.size() - 1, longest));
  return said;
}

Error error_of(const net::HttpAnswer& answer, const Connection& connection) {
  const std::string said = complaint_of(answer);
  const std::string quoted = said.empty() ? "" : fmt::format(": \"{}\"", said);
  std::string advice;
  switch (answer.status) {
    case 401:
    case 403:  // what is said may repeat parts of the key
      return {"llm.refused",
              connection.name(),
              fmt::format("HTTP {}: the key was not accepted; look at {}",
                          answer.status,
                          connection.provider->key_variable)};
    case 404:
      advice = "; is the model's name right, and the URL?";
      break;
    case 429:
      advice = "; too many requests, or no credit: try again later";
      break;
    default:
      advice = answer.status >= 500 ? "; the provider is in trouble: try again later" : "";
  }
  return {
      "llm.refused", connection.name(), fmt::format("HTTP {}{}{}", answer.status, quoted, advice)};
}

// Whether a refused request may pass without something that not every model takes; drops it.
bool drop_what_is_refused(const net::HttpAnswer& answer, ProviderCall& call) {
  if (answer.status != 400 && answer.status != 422) return false;
  const auto names = [&](std::string_view word) {
    return answer.body.find(word) != std::string::npos;
  };
  constexpr std::array schema_words = {"response_format",
                                       "json_schema",
                                       "output_config",
                                       "output_format",
                                       "responseJsonSchema",
                                       "response_json_schema",
                                       "schema"};
  const bool about_schema = std::any_of(schema_words.begin(), schema_words.end(), names);
  if (call.temperature && names("temperature")) {
    call.temperature = false;
    return true;
  }
  if (call.keep_schema && !call.request.answer_schema.empty() && about_schema) {
    call.keep_schema = false;
    return true;
  }
  return false;
}

Result<ChatAnswer> chat(const Connection& connection, const ChatRequest& request) {
  const ProviderRow& provider = *connection.provider;
  if (!request.answer_schema.empty() && !WireJson::accept(request.answer_schema))
    return Error{"internal.bug", connection.name(), "the answer's schema is no JSON"};
  ProviderCall call{
      request, connection.model, connection.base_url, connection.own_server, connection.key};
  for (;;) {
    MARKETGEN_TRY(const net::HttpAnswer answer, connection.http.send(provider.request(call)));
    if (answer.status == 200) return provider.answer(answer.body, connection.name());
    if (!drop_what_is_refused(answer, call)) return error_of(answer, connection);
  }
}

}  // namespace

std::string provider_names() {
  return fmt::format("{}", fmt::join(names_of_providers(), ", "));
}

Result<LanguageModel> open_language_model(const ModelChoice& choice) {
  const std::size_t colon = choice.model.find(':');
  MARKETGEN_TRY(const ProviderRow* provider, provider_called(choice.model.substr(0, colon)));
  MARKETGEN_TRY(const std::string model,
                checked_model(choice.model,
                              colon == std::string::npos ? "" : choice.model.substr(colon + 1)));
  MARKETGEN_TRY(const std::string url, checked_url(choice, *provider));
  MARKETGEN_TRY(net::HttpClient http,
                net::HttpClient::open({choice.limits, choice.record, choice.replay}));
  auto connection = std::make_shared<Connection>(
      Connection{provider, model, url, "", url == provider->base_url, std::move(http)});
  MARKETGEN_TRY(connection->key, checked_key(choice, *connection));
  return LanguageModel{connection->name(), [connection](const ChatRequest& request) {
                         return chat(*connection, request);
                       }};
}

}  // namespace marketgen::llm
