#include "server/request_guard.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "base/text.h"

namespace marketgen::server {
namespace {

constexpr std::string_view bearer = "Bearer ";

// Takes as long whatever the texts share, so that a token cannot be guessed byte by byte.
bool same_secret(std::string_view a, std::string_view b) {
  unsigned char differ = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < b.size(); ++i)
    differ |= static_cast<unsigned char>((i < a.size() ? a[i] : '\0') ^ b[i]);
  return differ == 0;
}

HttpReply refused(int status, std::string where, std::string message) {
  return error_reply(status, {"server.refused", std::move(where), std::move(message)});
}

}  // namespace

RequestGuard::RequestGuard(GuardRules rules)
    : rules_(std::move(rules)), tokens_(rules_.burst), last_(Clock::now()) {}

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

bool RequestGuard::within_rate(Clock::time_point now) {
  const std::scoped_lock lock(mutex_);
  const double passed_s = std::chrono::duration<double>(now - last_).count();
  last_ = std::max(last_, now);
  tokens_ = std::min(rules_.burst, tokens_ + std::max(0.0, passed_s) * rules_.requests_per_s);
  if (tokens_ < 1) return false;
  tokens_ -= 1;
  return true;
}

std::optional<HttpReply> RequestGuard::refusal(const HttpAsk& ask, Clock::time_point now) {
  if (!within_rate(now)) {
    HttpReply busy = refused(429, "requests", "too many requests: wait a second and go on slower");
    busy.retry_after_s = 1;
    return busy;
  }
  if (ask.method != "GET" && ask.method != "HEAD")
    return refused(405, ask.method, "only GET and HEAD are answered");
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

}  // namespace marketgen::server
