// JSON as providers send it: they add fields whenever they like, so nothing unknown is a fault.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "base/result.h"
#include "net/http.h"

namespace marketgen::llm {

using WireJson = nlohmann::ordered_json;  // in the order in which it was made: recorded alike

// Error llm.refused when `body` is no JSON object.
Result<WireJson> parse_wire(std::string_view body, const std::string& where);

// What stands at a JSON pointer; null when nothing does.
const WireJson* wire_at(const WireJson& json, const std::string& pointer);
// The text or number there; empty or 0 when there is none.
std::string wire_text(const WireJson& json, const std::string& pointer);
std::int64_t wire_number(const WireJson& json, const std::string& pointer);

// As text; bytes that are not UTF-8 are replaced.
std::string wire_dump(const WireJson& json);

// A POST of JSON, to which a provider adds its headers.
net::HttpRequest post_of(std::string url, const WireJson& body);

// The error for a model that declines to answer, and for an answer without one.
Error declined(const std::string& where, const std::string& why);
Error no_answer(const std::string& where);

}  // namespace marketgen::llm
