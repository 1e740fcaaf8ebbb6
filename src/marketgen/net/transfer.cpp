#include "net/transfer.h"

#include <curl/curl.h>

#include <memory>
#include <mutex>

#include <fmt/format.h>

#include "base/interrupt.h"
#include "base/text.h"

namespace marketgen::net {
namespace {

constexpr std::size_t max_header_bytes = 256U << 10;

constexpr int look_pause_ms = 100;  // for an interrupt

using Curl = std::unique_ptr<CURL, decltype(&curl_easy_cleanup)>;
using CurlMulti = std::unique_ptr<CURLM, decltype(&curl_multi_cleanup)>;
using CurlText = std::unique_ptr<char, decltype(&curl_free)>;

// Headers in libcurl's form.
class HeaderList {
 public:
  HeaderList() = default;
  ~HeaderList() { curl_slist_free_all(list_); }
  HeaderList(const HeaderList&) = delete;
  HeaderList& operator=(const HeaderList&) = delete;
  void add(const HttpHeader& header) { add(header.name + ": " + header.value); }
  void add(const std::string& line) { list_ = curl_slist_append(list_, line.c_str()); }
  curl_slist* get() const { return list_; }

 private:
  curl_slist* list_ = nullptr;
};

// What libcurl hands over while it works.
struct Inbox {
  const HttpLimits& limits;
  HttpAnswer answer;
  std::size_t header_bytes = 0;
  bool too_large = false;
};

std::size_t take_body(char* bytes, std::size_t size, std::size_t count, void* to) {
  Inbox& inbox = *static_cast<Inbox*>(to);
  const std::size_t length = size * count;
  inbox.too_large = inbox.answer.body.size() + length > inbox.limits.answer_bytes;
  if (inbox.too_large) return 0;  // libcurl gives up
  inbox.answer.body.append(bytes, length);
  return length;
}

std::size_t take_header(char* bytes, std::size_t size, std::size_t count, void* to) {
  Inbox& inbox = *static_cast<Inbox*>(to);
  const std::size_t length = size * count;
  inbox.header_bytes += length;
  inbox.too_large = inbox.header_bytes > max_header_bytes;
  if (inbox.too_large) return 0;
  const std::string_view line(bytes, length);
  if (line.starts_with("HTTP/")) inbox.answer.headers.clear();  // after "100 Continue"
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos) return length;
  const std::string name = lower_ascii(trimmed(line.substr(0, colon)));
  if (name == "set-cookie" || name == "set-cookie2") return length;
  inbox.answer.headers.push_back({name, std::string(trimmed(line.substr(colon + 1)))});
  return length;
}

void start_libcurl() {
  static std::once_flag once;
  std::call_once(once, [] { curl_global_init(CURL_GLOBAL_DEFAULT); });
}

void limit(CURL* curl, const HttpLimits& limits) {
  const auto ms = [](double seconds) { return static_cast<long>(1000 * seconds); };
  curl_easy_setopt(curl, CURLOPT_CONNECTTIMEOUT_MS, ms(limits.connect_s));
  curl_easy_setopt(curl, CURLOPT_TIMEOUT_MS, ms(limits.total_s));
  curl_easy_setopt(curl, CURLOPT_MAXFILESIZE_LARGE, static_cast<curl_off_t>(limits.answer_bytes));
  curl_easy_setopt(curl, CURLOPT_PROTOCOLS_STR, "http,https");
  curl_easy_setopt(curl, CURLOPT_FOLLOWLOCATION, 0L);
  curl_easy_setopt(curl, CURLOPT_NOSIGNAL, 1L);
  curl_easy_setopt(curl, CURLOPT_NETRC, static_cast<long>(CURL_NETRC_IGNORED));
}

void address(CURL* curl, const HttpRequest& request, const std::string& url, HeaderList& headers) {
  curl_easy_setopt(curl, CURLOPT_URL, url.c_str());
  curl_easy_setopt(curl, CURLOPT_CUSTOMREQUEST, request.method.c_str());
  curl_easy_setopt(curl, CURLOPT_USERAGENT, "marketgen");
  curl_easy_setopt(curl, CURLOPT_ACCEPT_ENCODING, "");  // every one that libcurl can undo
  const auto origin = origin_of(url);
  if (origin.ok() && origin->loopback) curl_easy_setopt(curl, CURLOPT_PROXY, "");
  for (const auto* list : {&request.headers, &request.secret_headers}) {
    for (const HttpHeader& header : *list)
      headers.add(header);
  }
  headers.add("Expect:");  // no round trip before a large body
  curl_easy_setopt(curl, CURLOPT_HTTPHEADER, headers.get());
  if (request.method == "GET") return;
  curl_easy_setopt(curl, CURLOPT_POSTFIELDSIZE_LARGE, static_cast<curl_off_t>(request.body.size()));
  curl_easy_setopt(curl, CURLOPT_POSTFIELDS, request.body.data());
}

bool is_passing(CURLcode code) {
  switch (code) {
    case CURLE_COULDNT_RESOLVE_HOST:
    case CURLE_COULDNT_RESOLVE_PROXY:
    case CURLE_COULDNT_CONNECT:
    case CURLE_SEND_ERROR:
    case CURLE_RECV_ERROR:
    case CURLE_GOT_NOTHING:
    case CURLE_PARTIAL_FILE:
    case CURLE_HTTP2:
    case CURLE_HTTP2_STREAM:
      return true;
    default:
      return false;
  }
}

// libcurl's own text names the host, never a header.
Error error_of(CURLcode code, const std::string& url, const HttpLimits& limits, bool too_large) {
  if (auto interrupted = check_interrupt(); !interrupted.ok()) return interrupted.error();
  if (too_large || code == CURLE_FILESIZE_EXCEEDED) {
    return {"net.too_large",
            url,
            fmt::format("the answer has more than {} bytes",
                        with_thousands(static_cast<std::int64_t>(limits.answer_bytes)))};
  }
  if (code == CURLE_OPERATION_TIMEDOUT) {
    return {
        "net.timeout",
        url,
        fmt::format(
            "no whole answer within {:g} s ({:g} s to connect)", limits.total_s, limits.connect_s)};
  }
  if (code == CURLE_URL_MALFORMAT || code == CURLE_UNSUPPORTED_PROTOCOL)
    return {"net.bad_url", url, "is no http or https URL"};
  return {"net.unreachable", url, curl_easy_strerror(code)};
}

// curl_easy_perform() asks only once a second whether to go on; this does all the time.
CURLcode perform(CURL* curl) {
  const CurlMulti multi(curl_multi_init(), curl_multi_cleanup);
  if (multi == nullptr || curl_multi_add_handle(multi.get(), curl) != CURLM_OK)
    return CURLE_OUT_OF_MEMORY;
  CURLcode code = CURLE_ABORTED_BY_CALLBACK;
  int running = 1;
  while (running > 0 && check_interrupt().ok()) {
    if (curl_multi_perform(multi.get(), &running) != CURLM_OK) break;
    if (running > 0) curl_multi_poll(multi.get(), nullptr, 0, look_pause_ms, nullptr);
  }
  int left = 0;
  if (const CURLMsg* message = curl_multi_info_read(multi.get(), &left))
    code = message->data.result;
  else
    curl_easy_setopt(curl, CURLOPT_QUICK_EXIT, 1L);  // do not wait for a name server
  curl_multi_remove_handle(multi.get(), curl);
  return code;
}

Transfer transfer_of(CURL* curl, Inbox& inbox) {
  Transfer transfer;
  long status = 0;
  curl_easy_getinfo(curl, CURLINFO_RESPONSE_CODE, &status);
  inbox.answer.status = static_cast<int>(status);
  const char* redirect = nullptr;
  curl_easy_getinfo(curl, CURLINFO_REDIRECT_URL, &redirect);
  if (redirect != nullptr) transfer.redirect_url = redirect;
  curl_off_t retry_after = 0;  // libcurl reads both forms: seconds and a date
  curl_easy_getinfo(curl, CURLINFO_RETRY_AFTER, &retry_after);
  if (!inbox.answer.header("retry-after").empty())
    transfer.retry_after_s = static_cast<double>(retry_after);
  transfer.answer = std::move(inbox.answer);
  return transfer;
}

// A URL as it may be shown: keys stand in its query or before its host, where they should not.
std::string shown(const std::string& url) {
  std::string text = url.substr(0, url.find_first_of("?#"));
  if (const std::size_t at = text.rfind('@'); at != std::string::npos) text.replace(0, at, "***");
  return text;
}

}  // namespace

Attempt transfer_once(const HttpRequest& request,
                      const std::string& url,
                      const HttpLimits& limits) {
  start_libcurl();
  const Curl curl(curl_easy_init(), curl_easy_cleanup);
  if (curl == nullptr) return {Error{"io.out_of_memory", url, "libcurl cannot start"}, false};
  Inbox inbox{limits, {}, 0, false};
  HeaderList headers;
  limit(curl.get(), limits);
  address(curl.get(), request, url, headers);
  curl_easy_setopt(curl.get(), CURLOPT_WRITEFUNCTION, take_body);
  curl_easy_setopt(curl.get(), CURLOPT_WRITEDATA, &inbox);
  curl_easy_setopt(curl.get(), CURLOPT_HEADERFUNCTION, take_header);
  curl_easy_setopt(curl.get(), CURLOPT_HEADERDATA, &inbox);
  const CURLcode code = perform(curl.get());
  if (code != CURLE_OK) return {error_of(code, url, limits, inbox.too_large), is_passing(code)};
  return {transfer_of(curl.get(), inbox), false};
}

Result<HttpOrigin> origin_of(const std::string& url) {
  const auto bad = [&](const char* why) { return Error{"net.bad_url", shown(url), why}; };
  const std::unique_ptr<CURLU, decltype(&curl_url_cleanup)> parsed(curl_url(), curl_url_cleanup);
  if (parsed == nullptr || curl_url_set(parsed.get(), CURLUPART_URL, url.c_str(), 0) != CURLUE_OK)
    return bad("is no URL; write http://HOST:PORT/PATH or https://HOST/PATH");
  const auto part = [&](CURLUPart which, unsigned flags) {
    char* text = nullptr;
    const CURLUcode found = curl_url_get(parsed.get(), which, &text, flags);
    const CurlText owned(text, curl_free);
    return found == CURLUE_OK ? std::string(owned.get()) : std::string();
  };
  if (!part(CURLUPART_USER, 0).empty() || !part(CURLUPART_PASSWORD, 0).empty())
    return bad("has a user name or password: keys belong into the environment");
  HttpOrigin origin;
  origin.scheme = part(CURLUPART_SCHEME, 0);
  origin.host = lower_ascii(part(CURLUPART_HOST, 0));
  if (origin.scheme != "http" && origin.scheme != "https")
    return bad("only http and https are spoken");
  origin.port = std::stoi(part(CURLUPART_PORT, CURLU_DEFAULT_PORT));
  origin.loopback = origin.host == "localhost" || origin.host == "[::1]" ||
                    (origin.host.starts_with("127.") &&
                     origin.host.find_first_not_of("0123456789.") == std::string::npos);
  return origin;
}

}  // namespace marketgen::net
