// An HTTP client within limits: the program's only way out.
//
// A request is sent, repeated when the server is busy or cannot be reached, and answered with
// whatever status the server gave. Every exchange can be written to a folder and played back from
// it, byte for byte; playing back opens no socket. Keys travel in `secret_headers` only: what
// stands there appears in no record, no answer and no error.
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "base/result.h"

namespace marketgen::net {

struct HttpHeader {
  std::string name, value;
  static constexpr auto fields = field_list(field("name", &HttpHeader::name, "header"),
                                            field("value", &HttpHeader::value, "its value"));
};

struct HttpRequest {
  std::string method = "GET";
  std::string url;  // http or https, without user name and password
  std::vector<HttpHeader> headers;
  // Sent like the others, and kept from everything else. What follows the last space of a value
  // ("Bearer KEY") is the key: it is blotted out wherever the server repeats it.
  std::vector<HttpHeader> secret_headers;
  std::string body;
};

struct HttpAnswer {
  int status = 0;
  std::vector<HttpHeader> headers;  // names in lower case, in the server's order; no cookies
  std::string body;

  // The value of the first header called `name` (lower case), or an empty text.
  std::string_view header(std::string_view name) const;
};

struct HttpLimits {
  double connect_s = 10;                 // to be connected
  double total_s = 120;                  // of one attempt, answer included
  std::size_t answer_bytes = 32U << 20;  // of the body; headers may have 256 kB
  int attempts = 4;                      // the first one included
  double first_wait_s = 0.5;             // doubled after every attempt, times 0.5 to 1
  double longest_wait_s = 30;            // between two attempts
};

struct HttpOptions {
  HttpLimits limits;
  std::filesystem::path record;  // folder for the exchanges; made when it is missing
  std::filesystem::path replay;  // folder to answer from instead; at most one of both
};

class HttpClient {
 public:
  // Errors: input.not_found when the folder to replay from is missing; io.cannot_write.
  static Result<HttpClient> open(const HttpOptions& options = {});
  HttpClient(HttpClient&&) noexcept;
  HttpClient& operator=(HttpClient&&) noexcept;
  ~HttpClient();

  // The server's answer, also when its status says no. Repeated are 429, every 5xx but 501, and
  // connections that fail or break; not what runs out of time. The wait is Retry-After where the
  // server says so (the last answer is returned at once when that is longer than longest_wait_s),
  // else it doubles, times a factor that only the request and the attempt decide. Redirections (307
  // and 308; of a GET all) are followed three times, never from https to http, and not to another
  // host when there are secret headers.
  //
  // Errors: net.bad_url, net.unreachable, net.timeout, net.too_large, net.redirected,
  // net.not_recorded, io.*, internal.interrupted. Safe to call from several threads; with a folder,
  // equal requests are numbered in the order in which they come.
  Result<HttpAnswer> send(const HttpRequest& request) const;

 private:
  struct State;
  explicit HttpClient(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

// Scheme and host of a URL. Error net.bad_url when it is none, is neither http nor https, or has a
// user name or password.
struct HttpOrigin {
  std::string scheme, host;
  int port = 0;
  bool loopback = false;  // localhost, 127.0.0.0/8 or ::1
  friend bool operator==(const HttpOrigin&, const HttpOrigin&) = default;
};
Result<HttpOrigin> origin_of(const std::string& url);

// RFC 4648, with padding.
std::string base64_of(std::string_view bytes);
// Error net.bad_record: `where` names the text.
Result<std::string> bytes_of_base64(std::string_view text, const std::string& where);

}  // namespace marketgen::net
