#include "net/tape.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/hash.h"
#include "base/text.h"
#include "io/file.h"
#include "io/json.h"

namespace marketgen::net {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t max_text = 256U << 20, max_headers = 4096;

// Bytes as text where they are text, otherwise in base64.
struct RecordedBody {
  std::string text, base64;
  static constexpr auto fields = field_list(
      field("text", &RecordedBody::text, "the bytes, when they are UTF-8", at_most_bytes(max_text)),
      field("base64", &RecordedBody::base64, "the bytes, when not", at_most_bytes(max_text)));
};

struct Exchange {
  std::string schema = "http-exchange/1";
  std::string method, url;
  std::vector<HttpHeader> request_headers;
  RecordedBody request;
  int status = 0;
  std::vector<HttpHeader> answer_headers;
  RecordedBody answer;
  static constexpr auto fields = field_list(
      field("schema", &Exchange::schema, "schema tag", constant("http-exchange/1")),
      field("method", &Exchange::method, "method", required()),
      field("url", &Exchange::url, "where it was sent", required()),
      field("request_headers",
            &Exchange::request_headers,
            "without keys",
            at_most_bytes(max_text),
            at_most_items(max_headers)),
      field("request", &Exchange::request, "what was sent"),
      field("status", &Exchange::status, "status of the answer", required(), range(100, 999)),
      field("answer_headers",
            &Exchange::answer_headers,
            "of the answer",
            at_most_bytes(max_text),
            at_most_items(max_headers)),
      field("answer", &Exchange::answer, "what came back"));
};

RecordedBody recorded(const std::string& bytes) {
  return is_utf8(bytes) ? RecordedBody{bytes, ""} : RecordedBody{"", base64_of(bytes)};
}

bool is_base64(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '+' ||
         c == '/' || c == '=';
}

// What a request said, without the pictures in it: only a picture is so long without a blank.
std::string without_pictures(std::string_view body) {
  constexpr std::ptrdiff_t shortest_picture = 1024;
  std::string kept;
  for (auto at = body.begin(); at != body.end();) {
    const auto end = std::find_if_not(at, body.end(), is_base64);
    const std::string_view run(at, end);
    if (end - at >= shortest_picture)
      kept += fmt::format("[{} characters of base64, {}]", run.size(), Hasher().add(run).hex());
    else
      kept += run;
    at = end;
    if (at != body.end()) kept += *at++;
  }
  return kept;
}

Result<std::string> bytes_of(const RecordedBody& body, const std::string& where) {
  if (body.base64.empty()) return body.text;
  return bytes_of_base64(body.base64, where);
}

// Header values may hold any byte, JSON only UTF-8.
std::vector<HttpHeader> as_utf8(std::vector<HttpHeader> headers) {
  std::erase_if(headers, [](const HttpHeader& h) { return !is_utf8(h.name) || !is_utf8(h.value); });
  return headers;
}

std::string hash_of(const HttpRequest& request) {
  Hasher hasher;
  hasher.add(request.method)
      .add(request.url)
      .add(static_cast<std::int64_t>(request.headers.size()));
  for (const HttpHeader& header : request.headers)
    hasher.add(header.name).add(header.value);
  return hasher.add(request.body).hex();
}

}  // namespace

Result<std::unique_ptr<HttpTape>> HttpTape::open(const HttpOptions& options) {
  std::error_code failed;
  if (!options.record.empty() && !options.replay.empty())
    return Error{"usage.bad_flag", options.replay.string(), "records or replays, not both"};
  if (!options.replay.empty()) {
    if (!fs::is_directory(options.replay, failed))
      return Error{
          "input.not_found", options.replay.string(), "is no folder of recorded exchanges"};
    return std::unique_ptr<HttpTape>(new HttpTape(Mode::replay, options.replay));
  }
  if (options.record.empty()) return std::unique_ptr<HttpTape>(new HttpTape(Mode::off, {}));
  fs::create_directories(options.record, failed);
  if (failed) return Error{"io.cannot_write", options.record.string(), failed.message()};
  return std::unique_ptr<HttpTape>(new HttpTape(Mode::record, options.record));
}

fs::path HttpTape::next_place(const HttpRequest& request) {
  const std::string hash = hash_of(request);
  const std::lock_guard lock(guard_);
  return folder_ / fmt::format("{}-{}.json", hash, ++asked_[hash]);
}

Result<void> write_exchange(const fs::path& place,
                            const HttpRequest& request,
                            const HttpAnswer& answer) {
  Exchange exchange;
  exchange.method = request.method;
  exchange.url = request.url;
  exchange.request_headers = as_utf8(request.headers);
  exchange.request = recorded(without_pictures(request.body));
  exchange.status = answer.status;
  exchange.answer_headers = answer.headers;
  exchange.answer = recorded(answer.body);
  return io::write_file(place, io::write_json(exchange));
}

Result<HttpAnswer> read_exchange(const fs::path& place, const HttpRequest& request) {
  std::error_code failed;
  if (!fs::exists(place, failed)) {
    return Error{"net.not_recorded",
                 place.string(),
                 fmt::format("this {} of {} was never recorded, or not with this very content; "
                             "record it again",
                             request.method,
                             request.url)};
  }
  MARKETGEN_TRY(const std::string text, io::read_file(place));
  MARKETGEN_TRY(const Exchange exchange, io::read_json<Exchange>(text, place.string()));
  HttpAnswer answer;
  answer.status = exchange.status;
  answer.headers = exchange.answer_headers;
  MARKETGEN_TRY(answer.body, bytes_of(exchange.answer, place.string() + ":/answer"));
  return answer;
}

}  // namespace marketgen::net
