#include "net/http.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <thread>

#include <fmt/format.h>

#include "base/interrupt.h"
#include "base/text.h"
#include "net/retry.h"
#include "net/tape.h"
#include "net/transfer.h"

namespace marketgen::net {
namespace {

constexpr int max_redirections = 3;
constexpr std::size_t shortest_key = 6;  // shorter ones may stand in an answer by chance

// Sleeps in short steps, so that an interrupt ends it.
Result<void> wait(double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto until = Clock::now() + std::chrono::duration<double>(seconds);
  while (Clock::now() < until) {
    MARKETGEN_CHECK(check_interrupt());
    const std::chrono::duration<double> left = until - Clock::now();
    std::this_thread::sleep_for(std::min(left, std::chrono::duration<double>(0.05)));
  }
  return {};
}

bool is_redirection(int status, const std::string& method) {
  return status == 307 || status == 308 ||
         (method == "GET" && (status == 301 || status == 302 || status == 303));
}

// Whether a request may go on from one URL to another.
Result<void> check_redirection(const HttpRequest& request,
                               const std::string& from,
                               const std::string& to) {
  MARKETGEN_TRY(const HttpOrigin here, origin_of(from));
  MARKETGEN_TRY(const HttpOrigin there, origin_of(to));
  if (here.scheme == "https" && there.scheme != "https")
    return Error{"net.redirected", from, "sends us on to unencrypted http, which is not followed"};
  if (!request.secret_headers.empty() && here != there) {
    return Error{"net.redirected",
                 from,
                 fmt::format("sends us on to {}: a key is not taken to another host", there.host)};
  }
  return {};
}

// One attempt, along the redirections.
Attempt attempt(const HttpRequest& request, const HttpLimits& limits) {
  std::string url = request.url;
  for (int hop = 0; hop <= max_redirections; ++hop) {
    Attempt made = transfer_once(request, url, limits);
    if (!made.transfer.ok()) return made;
    const Transfer& transfer = *made.transfer;
    if (transfer.redirect_url.empty() || !is_redirection(transfer.answer.status, request.method))
      return made;
    if (auto allowed = check_redirection(request, url, transfer.redirect_url); !allowed.ok())
      return {allowed.error(), false};
    url = transfer.redirect_url;
  }
  return {Error{"net.redirected", request.url, "sends us on more than three times"}, false};
}

Result<HttpAnswer> send_patiently(const HttpRequest& request, const HttpLimits& limits) {
  for (int made = 1;; ++made) {
    MARKETGEN_CHECK(check_interrupt());
    Attempt result = attempt(request, limits);
    const bool answered = result.transfer.ok();
    const bool again =
        answered ? is_worth_repeating(result.transfer->answer.status) : result.passing;
    double pause = retry_pause_s(made, request, limits);
    if (answered) pause = result.transfer->retry_after_s.value_or(pause);
    if (!again || made >= limits.attempts || pause > limits.longest_wait_s) {
      if (!answered) return result.transfer.error();
      return std::move(result.transfer->answer);
    }
    MARKETGEN_CHECK(wait(pause));
  }
}

// Keys, as a server might repeat them.
std::vector<std::string> keys_of(const HttpRequest& request) {
  std::vector<std::string> keys;
  for (const HttpHeader& header : request.secret_headers) {
    const std::size_t space = header.value.rfind(' ');
    std::string key = space == std::string::npos ? header.value : header.value.substr(space + 1);
    if (key.size() >= shortest_key) keys.push_back(std::move(key));
  }
  return keys;
}

// How many characters at `at` spell `c`, as it is or escaped: \u0073, \\u0073, \x73, %73, &#115;
// or &#x73;, \/. 0: none do.
std::size_t spelling_of(char c, std::string_view text, std::size_t at) {
  if (at >= text.size()) return 0;
  if (text[at] == c) return 1;
  if (text[at] != '\\' && text[at] != '%' && text[at] != '&') return 0;
  std::size_t i = at;
  while (i < text.size() && text[i] == '\\')
    ++i;
  const std::string_view rest = text.substr(i);
  if (i > at && !rest.empty() && rest[0] == c) return i + 1 - at;
  const auto code = static_cast<unsigned>(static_cast<unsigned char>(c));
  const std::string hex = fmt::format("{:02x}", code);
  std::vector<std::string> spellings;
  if (i > at) spellings = {"u00" + hex, "x" + hex};
  if (i == at)
    spellings = {"%" + hex, fmt::format("&#{};", code), "&#x" + hex + ";", "&#x00" + hex + ";"};
  for (const std::string& spelling : spellings) {
    if (lower_ascii(rest.substr(0, spelling.size())) == spelling) return i + spelling.size() - at;
  }
  return 0;
}

// The characters at `at` that spell the key; 0: they do not.
std::size_t spelling_of(std::string_view key, std::string_view text, std::size_t at) {
  std::size_t end = at;
  for (const char c : key) {
    const std::size_t length = spelling_of(c, text, end);
    if (length == 0) return 0;
    end += length;
  }
  return end - at;
}

// Wherever it is spelt, escaped or not: what is read from the text later undoes the escapes.
void blot_out(std::string& text, const std::string& key) {
  constexpr std::string_view blot = "***";
  std::string kept;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = spelling_of(key, text, at);
    kept += length > 0 ? blot : std::string_view(text).substr(at, 1);
    at += std::max<std::size_t>(length, 1);
  }
  text = std::move(kept);
}

HttpAnswer without_keys(HttpAnswer answer, const HttpRequest& request) {
  for (const std::string& key : keys_of(request)) {
    blot_out(answer.body, key);
    for (HttpHeader& header : answer.headers) {
      blot_out(header.name, key);
      blot_out(header.value, key);
    }
  }
  std::erase_if(answer.headers, [](const HttpHeader& header) {
    return !is_utf8(header.name) || !is_utf8(header.value);  // a record could not hold them
  });
  return answer;
}

}  // namespace

std::string_view HttpAnswer::header(std::string_view name) const {
  for (const HttpHeader& each : headers) {
    if (each.name == name) return each.value;
  }
  return {};
}

struct HttpClient::State {
  HttpLimits limits;
  std::unique_ptr<HttpTape> tape;
};

HttpClient::HttpClient(std::unique_ptr<State> state) : state_(std::move(state)) {}
HttpClient::HttpClient(HttpClient&&) noexcept = default;
HttpClient& HttpClient::operator=(HttpClient&&) noexcept = default;
HttpClient::~HttpClient() = default;

Result<HttpClient> HttpClient::open(const HttpOptions& options) {
  auto state = std::make_unique<State>();
  state->limits = options.limits;
  MARKETGEN_TRY(state->tape, HttpTape::open(options));
  return HttpClient(std::move(state));
}

Result<HttpAnswer> HttpClient::send(const HttpRequest& request) const {
  if (auto checked = origin_of(request.url); !checked.ok()) return checked.error();
  HttpTape& tape = *state_->tape;
  if (tape.mode() == HttpTape::Mode::replay)
    return read_exchange(tape.next_place(request), request);
  MARKETGEN_TRY(HttpAnswer raw, send_patiently(request, state_->limits));
  HttpAnswer answer = without_keys(std::move(raw), request);
  if (tape.mode() == HttpTape::Mode::record)
    MARKETGEN_CHECK(write_exchange(tape.next_place(request), request, answer));
  return answer;
}

}  // namespace marketgen::net
