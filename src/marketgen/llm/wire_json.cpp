#include "llm/wire_json.h"

#include <fmt/format.h>

namespace marketgen::llm {

Result<WireJson> parse_wire(std::string_view body, const std::string& where) {
  WireJson json = WireJson::parse(body, nullptr, false);
  if (json.is_discarded() || !json.is_object())
    return Error{"llm.refused", where, "what came back is no JSON object: is this the right URL?"};
  return json;
}

const WireJson* wire_at(const WireJson& json, const std::string& pointer) {
  const WireJson::json_pointer at(pointer);
  return json.contains(at) ? &json.at(at) : nullptr;
}

std::string wire_text(const WireJson& json, const std::string& pointer) {
  const WireJson* found = wire_at(json, pointer);
  return found != nullptr && found->is_string() ? found->get<std::string>() : std::string();
}

std::int64_t wire_number(const WireJson& json, const std::string& pointer) {
  const WireJson* found = wire_at(json, pointer);
  return found != nullptr && found->is_number_integer() ? found->get<std::int64_t>() : 0;
}

std::string wire_dump(const WireJson& json) {
  return json.dump(-1, ' ', false, WireJson::error_handler_t::replace);
}

net::HttpRequest post_of(std::string url, const WireJson& body) {
  return {"POST", std::move(url), {{"Content-Type", "application/json"}}, {}, wire_dump(body)};
}

Error declined(const std::string& where, const std::string& why) {
  return {"llm.refused", where, fmt::format("the model declined to answer: {}", why)};
}

Error no_answer(const std::string& where) {
  return {"llm.refused", where, "the provider's answer holds no text"};
}

}  // namespace marketgen::llm
