#include "server/http_server.h"

#include <array>
#include <latch>
#include <optional>
#include <utility>
#include <vector>

#include <civetweb.h>
#include <fmt/format.h>

#include "base/text.h"
#include "io/gzip.h"

namespace marketgen::server {
namespace {

// Nothing from elsewhere, no script but the page's files, in no other site's frame.
constexpr std::string_view security_headers =
    "Content-Security-Policy: default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src "
    "'self' 'unsafe-inline'; img-src 'self' blob: data:; connect-src 'self'; worker-src 'self' "
    "blob:; font-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'self'\r\n"
    "X-Content-Type-Options: nosniff\r\n"
    "Referrer-Policy: no-referrer\r\n"
    "Cross-Origin-Resource-Policy: same-origin\r\n"
    "Cross-Origin-Opener-Policy: same-origin\r\n";

std::string_view phrase_of(int status) {
  switch (status) {
    case 200:
      return "OK";
    case 304:
      return "Not Modified";
    case 400:
      return "Bad Request";
    case 403:
      return "Forbidden";
    case 404:
      return "Not Found";
    case 405:
      return "Method Not Allowed";
    case 413:
      return "Content Too Large";
    case 429:
      return "Too Many Requests";
    default:
      return status < 500 ? "Bad Request" : "Internal Server Error";
  }
}

bool takes_gzip(const HttpAsk& ask) {
  return ask.header("accept-encoding").find("gzip") != std::string_view::npos;
}

// What goes over the wire, and whether it is still packed.
struct Sent {
  std::string unpacked;  // only where the client cannot unpack
  std::string_view bytes;
  bool packed = false;
};

Result<Sent> sent_form(const HttpBody& body, const HttpAsk& ask) {
  Sent sent;
  sent.packed = body.packed && takes_gzip(ask);
  if (!body.packed || sent.packed) {
    sent.bytes = body.bytes;
    return sent;
  }
  MARKETGEN_TRY(sent.unpacked, io::gunzip(body.bytes, "answer", std::uint64_t{1} << 30));
  return sent;
}

std::string head_of(const HttpReply& reply, const Sent& sent, int status, bool close) {
  std::string head =
      fmt::format("HTTP/1.1 {} {}\r\n{}", status, phrase_of(status), security_headers);
  head += fmt::format("Content-Type: {}\r\nETag: {}\r\nVary: Accept-Encoding\r\n",
                      reply.body->type,
                      reply.body->etag);
  head += reply.lasting ? "Cache-Control: public, max-age=31536000, immutable\r\n"
                        : "Cache-Control: no-cache\r\n";
  if (sent.packed) head += "Content-Encoding: gzip\r\n";
  if (reply.retry_after_s > 0) head += fmt::format("Retry-After: {}\r\n", reply.retry_after_s);
  if (status == 405) head += "Allow: GET, HEAD\r\n";
  if (status != 304) head += fmt::format("Content-Length: {}\r\n", sent.bytes.size());
  return head + (close ? "Connection: close\r\n\r\n" : "Connection: keep-alive\r\n\r\n");
}

// Nothing else can be done for a client that has gone.
void write_all(mg_connection* connection, std::string_view bytes) {
  constexpr std::size_t piece = 1U << 20;
  while (!bytes.empty()) {
    const std::string_view now = bytes.substr(0, piece);
    if (mg_write(connection, now.data(), now.size()) <= 0) return;
    bytes.remove_prefix(now.size());
  }
}

void send(mg_connection* connection, const HttpAsk& ask, const HttpReply& reply, bool close) {
  Result<Sent> sent = sent_form(*reply.body, ask);
  if (!sent.ok()) {
    const HttpReply failed = error_reply(500, sent.error());
    if (!failed.body->packed) send(connection, ask, failed, close);
    return;
  }
  Sent form = std::move(sent).value();
  if (!form.unpacked.empty()) form.bytes = form.unpacked;
  const bool unchanged =
      reply.status == 200 && ask.header("if-none-match") == std::string_view(reply.body->etag);
  write_all(connection, head_of(reply, form, unchanged ? 304 : reply.status, close));
  if (!unchanged && ask.method != "HEAD") write_all(connection, form.bytes);
}

Result<HttpAsk> ask_of(const mg_request_info& info) {
  HttpAsk ask;
  ask.method = info.request_method == nullptr ? "" : info.request_method;
  for (int i = 0; i < info.num_headers; ++i)
    ask.headers[lower_ascii(info.http_headers[i].name)] = info.http_headers[i].value;
  MARKETGEN_TRY(ask.path, path_of(info.request_uri == nullptr ? "" : info.request_uri));
  MARKETGEN_TRY(ask.query, query_of(info.query_string == nullptr ? "" : info.query_string));
  return ask;
}

// Stands for a request that could not be read.
HttpAsk unread() {
  HttpAsk ask;
  ask.method = "GET";
  return ask;
}

// An address of IPv6 as it stands before a port.
std::string in_brackets(const std::string& host) {
  return host.find(':') == std::string::npos ? host : "[" + host + "]";
}

// The address in a form that the library takes: "127.0.0.1:0", "[::1]:0".
std::string listening(const HttpServerOptions& options) {
  return fmt::format("{}:{}", in_brackets(options.host), options.port);
}

}  // namespace

// Nothing on the disk is served by the library itself: it has no document root.
struct HttpServer::State {
  HttpHandler handler;
  HttpServerOptions options;
  std::unique_ptr<RequestGuard> guard;
  mg_context* context = nullptr;
  int port = 0;
  std::latch started{1};  // from here on `guard` is there

  ~State() {
    if (guard == nullptr) started.count_down();
    if (context != nullptr) mg_stop(context);
  }

  HttpReply answer(const HttpAsk& ask) const {
    if (guard == nullptr) return error_reply(500, {"server.cannot_listen", "", "is not started"});
    if (std::optional<HttpReply> refused = guard->refusal(ask)) return *std::move(refused);
    return handler(ask);
  }

  static int on_request(mg_connection* connection) {
    const mg_request_info& info = *mg_get_request_info(connection);
    const auto& state = *static_cast<const State*>(info.user_data);
    state.started.wait();
    const Result<HttpAsk> ask = ask_of(info);
    // A body that nobody reads would be taken for the next request.
    const bool close = !ask.ok() || info.content_length > 0 || ask->method != "GET" ||
                       ask->header("connection") == "close";
    const HttpAsk asked = ask.ok() ? *ask : unread();
    const HttpReply reply = ask.ok() ? state.answer(asked) : error_reply(400, ask.error());
    send(connection, asked, reply, close);
    if (close) mg_disable_connection_keep_alive(connection);
    return reply.status;
  }

  // What the library refuses by itself: requests that are none.
  static int on_error(mg_connection* connection, int status, const char* message) {
    const HttpReply reply = error_reply(
        status, {"server.bad_request", "request", message == nullptr ? "is not HTTP" : message});
    send(connection, unread(), reply, true);
    return 0;
  }

  // Nothing on standard error: what a client does wrong is its own business.
  static int on_log(const mg_connection*, const char*) { return 1; }
};

HttpServer::HttpServer(std::unique_ptr<State> state) : state_(std::move(state)) {}
HttpServer::~HttpServer() = default;

int HttpServer::port() const {
  return state_->port;
}

std::string HttpServer::address() const {
  return fmt::format("http://{}:{}/", in_brackets(state_->options.host), state_->port);
}

Result<std::unique_ptr<HttpServer>> HttpServer::start(const HttpServerOptions& options,
                                                      HttpHandler handler) {
  static const unsigned features = mg_init_library(0);  // for as long as the process lives
  static_cast<void>(features);
  auto state = std::make_unique<State>();
  state->handler = std::move(handler);
  state->options = options;
  const std::array<std::pair<const char*, std::string>, 9> settings{
      {{"listening_ports", listening(options)},
       {"num_threads", std::to_string(options.threads)},
       {"connection_queue", std::to_string(2 * options.threads)},
       {"request_timeout_ms", std::to_string(options.timeout_ms)},
       {"enable_keep_alive", "yes"},
       {"keep_alive_timeout_ms", "2000"},
       {"max_request_size", std::to_string(options.max_request_bytes)},
       {"decode_url", "no"},  // path_of() does
       {"enable_auth_domain_check", "no"}}};
  std::vector<const char*> words;
  for (const auto& [name, value] : settings) {
    words.push_back(name);
    words.push_back(value.c_str());
  }
  words.push_back(nullptr);
  mg_callbacks callbacks{};
  callbacks.begin_request = State::on_request;
  callbacks.http_error = State::on_error;
  callbacks.log_message = State::on_log;
  callbacks.log_access = State::on_log;
  std::array<char, 256> text{};
  mg_error_data error{};
  error.text = text.data();
  error.text_buffer_size = text.size();
  mg_init_data init{};
  init.callbacks = &callbacks;
  init.user_data = state.get();
  init.configuration_options = words.data();
  state->context = mg_start2(&init, &error);
  std::array<mg_server_port, 2> ports{};
  if (state->context == nullptr ||
      mg_get_server_ports(state->context, static_cast<int>(ports.size()), ports.data()) < 1)
    return Error{"server.cannot_listen",
                 options.port == 0 ? options.host : listening(options),
                 fmt::format("no server can be started there{}; take another --port, or leave it "
                             "out for a free one",
                             text[0] == '\0' ? "" : fmt::format(" ({})", text.data()))};
  state->port = ports[0].port;
  GuardRules rules = options.limits;
  rules.host = in_brackets(options.host);
  rules.port = state->port;
  rules.token = options.token;
  state->guard = std::make_unique<RequestGuard>(std::move(rules));
  state->started.count_down();
  return std::unique_ptr<HttpServer>(new HttpServer(std::move(state)));
}

}  // namespace marketgen::server
