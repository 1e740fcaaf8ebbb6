#include "server/answering.h"

#include <charconv>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace marketgen::server {
namespace {

// All of the text, without a sign.
std::optional<std::uint64_t> whole(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || end != text.data() + text.size() || text.empty()) return std::nullopt;
  return value;
}

}  // namespace

Result<web::HttpReply> reply_with(ViewFile file) {
  return web::HttpReply{.body = web::make_body(std::move(file.type), std::move(file.bytes))};
}

Error no_address(const web::HttpAsk& ask) {
  return {"server.not_found", ask.path, "there is nothing at this address; see docs/viewer.md"};
}

Result<std::uint32_t> row_of(const web::HttpAsk& ask, std::string_view text, std::size_t rows) {
  const std::optional<std::uint64_t> row = whole(text);
  if (row && *row < rows) return static_cast<std::uint32_t>(*row);
  return Error{"server.not_found",
               ask.path,
               rows == 0 ? std::string("there are no rows here")
                         : fmt::format("rows go from 0 to {} here", rows - 1)};
}

Result<std::uint64_t> number_in(const web::HttpAsk& ask,
                                const std::string& name,
                                std::uint64_t usual,
                                std::uint64_t low,
                                std::uint64_t high) {
  const auto given = ask.query.find(name);
  if (given == ask.query.end()) return usual;
  const std::optional<std::uint64_t> value = whole(given->second);
  if (value && *value >= low && *value <= high) return *value;
  return Error{
      "server.bad_request", name, fmt::format("is not a whole number from {} to {}", low, high)};
}

}  // namespace marketgen::server
