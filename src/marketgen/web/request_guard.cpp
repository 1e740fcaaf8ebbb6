#include "web/request_guard.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "base/text.h"
#include "web/edit_lease.h"

namespace marketgen::web {
namespace {

constexpr std::string_view bearer = "Bearer ";

HttpReply refused(int status, std::string where, std::string message) {
  return error_reply(status, {"server.refused", std::move(where), std::move(message)});
}

}  // namespace

RequestGuard::RequestGuard(GuardRules rules)
    : rules_(std::move(rules)),
      reads_{rules_.requests_per_s, rules_.burst, rules_.burst, Clock::now()},
      writes_{rules_.writes_per_s, rules_.write_burst, rules_.write_burst, Clock::now()} {}

// A form of another site can post as well, but no JSON without asking first (CORS).
bool RequestGuard::is_write(const HttpAsk& ask) const {
  if (ask.method != "POST" || !rules_.may_write) return false;
  const std::vector<std::string> parts = parts_of(ask.path);
  const bool edits = parts.size() == 5 && parts[1] == "stores" && parts[3] == "edit";
  const bool drives = parts.size() == 5 && parts[1] == "stores" && parts[3] == "drive";
  const bool makes = parts.size() == 3 && parts[1] == "make";
  return (edits || drives || makes) && parts[0] == "api";
}

// Who has the token may come by whatever name this machine has in his network: no other page has
// it.
bool RequestGuard::is_own_host(std::string_view host) const {
  if (!rules_.token.empty()) return !host.empty();
  const std::string lower = lower_ascii(std::string(host));
  const std::string port = fmt::format(":{}", rules_.port);
  const std::array<std::string, 4> names{
      "127.0.0.1", "localhost", "[::1]", lower_ascii(rules_.host)};
  return std::ranges::any_of(names, [&](const std::string& name) { return lower == name + port; });
}

bool RequestGuard::has_token(const HttpAsk& ask) const {
  const std::string_view header = ask.header("authorization");
  if (header.starts_with(bearer)) return same_secret(header.substr(bearer.size()), rules_.token);
  const auto query = ask.query.find("token");
  return query != ask.query.end() && same_secret(query->second, rules_.token);
}

bool RequestGuard::within_rate(Bucket& bucket, Clock::time_point now) {
  const std::scoped_lock lock(mutex_);
  const double passed_s = std::chrono::duration<double>(now - bucket.last).count();
  bucket.last = std::max(bucket.last, now);
  bucket.tokens = std::min(bucket.most, bucket.tokens + std::max(0.0, passed_s) * bucket.per_s);
  if (bucket.tokens < 1) return false;
  bucket.tokens -= 1;
  return true;
}

std::optional<HttpReply> RequestGuard::refusal(const HttpAsk& ask, Clock::time_point now) {
  const bool writes = is_write(ask);
  if (!within_rate(reads_, now) || (writes && !within_rate(writes_, now))) {
    HttpReply busy = refused(429, "requests", "too many requests: wait a second and go on slower");
    busy.retry_after_s = 1;
    return busy;
  }
  return refusal_of_head(ask);
}

std::optional<HttpReply> RequestGuard::refusal_of_head(const HttpAsk& ask) const {
  const bool writes = is_write(ask);
  if (ask.method != "GET" && ask.method != "HEAD" && !writes)
    return refused(405,
                   ask.method,
                   "only GET and HEAD are answered here, and POST below /api/stores/N/edit/, "
                   "/api/stores/N/drive/ and /api/make/ where the server may edit");
  if (writes && !ask.header("content-type").starts_with("application/json"))
    return refused(403, "Content-Type", "what is posted is application/json");
  if (!is_own_host(ask.header("host")))
    return refused(403,
                   "Host",
                   fmt::format("this server is called {}:{}; open the address that `marketgen "
                               "view` printed",
                               rules_.host,
                               rules_.port));
  constexpr std::string_view scheme = "http://";
  const std::string_view origin = ask.header("origin");
  const bool own_page =
      origin.starts_with(scheme) && is_own_host(origin.substr(scheme.size())) &&
      (rules_.token.empty() || origin.substr(scheme.size()) == ask.header("host"));
  if (!origin.empty() && !own_page)
    return refused(403, "Origin", "pages of other sites may not read stores");
  // The page itself holds nothing of a store; it is what asks for the rest with the token.
  if (!rules_.token.empty() && ask.path.starts_with("/api/") && !has_token(ask))
    return refused(403,
                   "token",
                   "the token is missing or wrong: open the address with ?token= that `marketgen "
                   "view` was given");
  return std::nullopt;
}

}  // namespace marketgen::web
