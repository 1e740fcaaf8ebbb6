#include "web/http_message.h"

#include <algorithm>
#include <array>
#include <utility>

#include <nlohmann/json.hpp>

#include "base/hash.h"
#include "base/text.h"
#include "io/gzip.h"

namespace marketgen::web {
namespace {

constexpr std::size_t max_path_bytes = 1000;
constexpr std::size_t worth_packing_bytes = 1200;  // less goes out in one packet anyway

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

bool is_packed_already(std::string_view type) {
  return type.starts_with("image/") && type != "image/svg+xml";
}

}  // namespace

std::string_view HttpAsk::header(const std::string& name) const {
  const auto found = headers.find(name);
  return found == headers.end() ? std::string_view{} : std::string_view(found->second);
}

std::shared_ptr<const HttpBody> made_body(std::string type, std::string bytes) {
  HttpBody body;
  body.etag = "\"" + Hasher().add(bytes).hex() + "\"";
  body.packed = io::is_gzip(bytes);
  body.bytes = std::move(bytes);
  body.type = std::move(type);
  return std::make_shared<const HttpBody>(std::move(body));
}

std::shared_ptr<const HttpBody> make_body(std::string type, std::string bytes) {
  if (!is_packed_already(type) && bytes.size() > worth_packing_bytes)
    bytes = io::gzip(bytes, io::GzipEffort::quick);
  return made_body(std::move(type), std::move(bytes));
}

HttpReply json_reply(const std::string& json) {
  return {.body = make_body("application/json", json)};
}

HttpReply error_reply(int status, const Error& error) {
  const nlohmann::ordered_json json{
      {"error", {{"code", error.code}, {"where", error.where}, {"message", error.message}}}};
  // A broken name in a message must not become an exception.
  constexpr auto replace = nlohmann::ordered_json::error_handler_t::replace;
  return {.status = status,
          .body = make_body("application/json", json.dump(-1, ' ', false, replace))};
}

int status_of(const Error& error) {
  if (error.code == "server.not_found") return 404;
  if (error.code == "server.edit_taken" || error.code == "server.drive_taken") return 409;
  constexpr std::array<std::string_view, 3> of_the_request{"server.", "input.", "json."};
  const bool bad = std::ranges::any_of(
      of_the_request, [&](std::string_view module) { return error.code.starts_with(module); });
  return bad ? 400 : 500;
}

std::optional<std::string> decoded(std::string_view text, bool plus_is_blank) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    char c = text[i];
    if (c == '%') {
      const int high = i + 2 < text.size() ? hex_digit(text[i + 1]) : -1;
      const int low = i + 2 < text.size() ? hex_digit(text[i + 2]) : -1;
      if (high < 0 || low < 0) return std::nullopt;
      c = static_cast<char>(high * 16 + low);
      i += 2;
    } else if (c == '+' && plus_is_blank) {
      c = ' ';
    }
    if (c == '\0') return std::nullopt;
    result += c;
  }
  return result;
}

Result<std::map<std::string, std::string>> query_of(std::string_view text) {
  std::map<std::string, std::string> query;
  while (!text.empty()) {
    const std::string_view pair = text.substr(0, text.find('&'));
    text.remove_prefix(std::min(text.size(), pair.size() + 1));
    if (pair.empty()) continue;
    const std::size_t equals = std::min(pair.find('='), pair.size());
    const std::optional<std::string> name = decoded(pair.substr(0, equals), true);
    const std::optional<std::string> value =
        decoded(pair.substr(std::min(equals + 1, pair.size())), true);
    if (!name || !value || !is_utf8(*name) || !is_utf8(*value))
      return Error{"server.bad_request",
                   "query",
                   "is not readable: write every % as %25, and texts in UTF-8"};
    query[*name] = *value;
  }
  return query;
}

Result<std::string> path_of(std::string_view uri) {
  const Error bad{"server.bad_request", "path", "is not an address of this server"};
  const std::optional<std::string> path = decoded(uri.substr(0, uri.find('?')), false);
  if (!path || path->empty() || path->front() != '/' || path->size() > max_path_bytes) return bad;
  const bool odd = std::ranges::any_of(*path, [](char c) {
    return static_cast<unsigned char>(c) < ' ' || c == '\\' || c == '\x7f';
  });
  if (odd || !is_utf8(*path) || path->find("//") != std::string::npos) return bad;
  for (const std::string& part : parts_of(*path)) {
    if (part == "." || part == "..") return bad;
  }
  return *path;
}

std::vector<std::string> parts_of(std::string_view path) {
  std::vector<std::string> parts;
  while (!path.empty()) {
    const std::string_view part = path.substr(0, path.find('/'));
    if (!part.empty()) parts.emplace_back(part);
    path.remove_prefix(std::min(path.size(), part.size() + 1));
  }
  return parts;
}

}  // namespace marketgen::web
