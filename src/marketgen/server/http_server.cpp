#include "server/http_server.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <optional>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <boost/asio/dispatch.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/strand.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

#include "base/text.h"
#include "io/gzip.h"
#include "server/web_socket_session.h"

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
namespace websocket = boost::beast::websocket;
using boost::system::error_code;

namespace marketgen::server {
namespace {

// Nothing from elsewhere, no script but the page's files, in no frame but `frames`: of this site
// itself, and perhaps of what runs on this machine.
constexpr std::string_view security_headers =
    "Content-Security-Policy: default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src "
    "'self' 'unsafe-inline'; img-src 'self' blob: data:; connect-src 'self'; worker-src 'self' "
    "blob:; font-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors {}\r\n"
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
    case 409:
      return "Conflict";
    case 413:
      return "Content Too Large";
    case 429:
      return "Too Many Requests";
    default:
      return status < 500 ? "Bad Request" : "Internal Server Error";
  }
}

bool takes_gzip(const web::HttpAsk& ask) {
  return ask.header("accept-encoding").find("gzip") != std::string_view::npos;
}

// What goes over the wire, and whether it is still packed.
struct Sent {
  std::string unpacked;  // only where the client cannot unpack
  std::string_view bytes;
  bool packed = false;
};

Result<Sent> sent_form(const web::HttpBody& body, const web::HttpAsk& ask) {
  Sent sent;
  sent.packed = body.packed && takes_gzip(ask);
  if (!body.packed || sent.packed) {
    sent.bytes = body.bytes;
    return sent;
  }
  MARKETGEN_TRY(sent.unpacked, io::gunzip(body.bytes, "answer", std::uint64_t{1} << 30));
  return sent;
}

std::string security_for(bool embed) {
  constexpr std::string_view own = "'self'",
                             of_this_machine = "'self' http://localhost:* http://127.0.0.1:*";
  return fmt::format(fmt::runtime(security_headers), embed ? of_this_machine : own);
}

// Of every answer on a connection.
struct Terms {
  bool close = false;  // after it
  bool embed = false;  // see HttpServerOptions
};

std::string head_of(
    const web::HttpReply& reply, std::size_t bytes, bool packed, int status, const Terms& terms) {
  std::string head =
      fmt::format("HTTP/1.1 {} {}\r\n{}", status, phrase_of(status), security_for(terms.embed));
  head += fmt::format("Content-Type: {}\r\nETag: {}\r\nVary: Accept-Encoding\r\n",
                      reply.body->type,
                      reply.body->etag);
  head += reply.lasting ? "Cache-Control: public, max-age=31536000, immutable\r\n"
                        : "Cache-Control: no-cache\r\n";
  if (packed) head += "Content-Encoding: gzip\r\n";
  if (reply.retry_after_s > 0) head += fmt::format("Retry-After: {}\r\n", reply.retry_after_s);
  if (status == 405) head += "Allow: GET, HEAD\r\n";
  if (status != 304) head += fmt::format("Content-Length: {}\r\n", bytes);
  return head + (terms.close ? "Connection: close\r\n\r\n" : "Connection: keep-alive\r\n\r\n");
}

// Stands for a request that could not be read.
web::HttpAsk unread() {
  web::HttpAsk ask;
  ask.method = "GET";
  return ask;
}

web::HttpReply unreadable(error_code failed) {
  const bool too_long = failed == http::error::body_limit;
  return web::error_reply(
      too_long ? 413 : 400,
      {"server.bad_request", "request", "is not HTTP, or too long: " + failed.message()});
}

// An address of IPv6 as it stands before a port.
std::string in_brackets(const std::string& host) {
  return host.find(':') == std::string::npos ? host : "[" + host + "]";
}

using Request = http::request<http::string_body>;

Result<web::HttpAsk> ask_of(const Request& request) {
  web::HttpAsk ask;
  ask.method = std::string(request.method_string());
  for (const auto& field : request)
    ask.headers[lower_ascii(std::string(field.name_string()))] = std::string(field.value());
  const std::string target(request.target());
  MARKETGEN_TRY(ask.path, web::path_of(target));
  const std::size_t question = target.find('?');
  if (question != std::string::npos) {
    MARKETGEN_TRY(ask.query, web::query_of(std::string_view(target).substr(question + 1)));
  }
  ask.body = request.body();
  return ask;
}

// An answer on its way: the head, then the body's bytes.
struct Outgoing {
  std::string head;
  web::HttpReply reply;  // keeps the bytes
  Sent sent;
  bool with_body = true, close = false;
  std::string_view rest() const { return with_body ? bytes() : std::string_view(); }
  std::string_view bytes() const {
    return sent.unpacked.empty() ? sent.bytes : std::string_view(sent.unpacked);
  }
};

Outgoing outgoing(const web::HttpAsk& ask, web::HttpReply reply, const Terms& terms) {
  Result<Sent> sent = sent_form(*reply.body, ask);
  if (!sent.ok())
    return outgoing(unread(), web::error_reply(500, sent.error()), {true, terms.embed});
  Outgoing out;
  out.reply = std::move(reply);
  out.sent = std::move(sent).value();
  out.close = terms.close;
  const bool unchanged = out.reply.status == 200 &&
                         ask.header("if-none-match") == std::string_view(out.reply.body->etag);
  out.with_body = !unchanged && ask.method != "HEAD";
  out.head = head_of(
      out.reply, out.bytes().size(), out.sent.packed, unchanged ? 304 : out.reply.status, terms);
  return out;
}

}  // namespace

// Sockets are served on a few threads that never wait; answers are made on others, which may.
struct HttpServer::State {
  HttpHandler handler;
  SocketOpener opener;
  HttpServerOptions options;
  std::unique_ptr<web::RequestGuard> guard;
  int port = 0;
  std::atomic<int> connections = 0;
  asio::io_context io;
  asio::ip::tcp::acceptor acceptor{io};
  asio::thread_pool makers;  // goes first: what it still holds needs `io`
  std::vector<std::thread> carriers;

  explicit State(const HttpServerOptions& given)
      : options(given), makers(static_cast<std::size_t>(given.threads)) {}
  ~State() {
    io.stop();
    for (std::thread& carrier : carriers)
      carrier.join();
    makers.stop();
    makers.join();
  }

  Result<void> listen();
  void accept();
  bool takes_body(const Request& request) const;
  bool is_too_long(const Request& request, std::uint64_t body_bytes) const;
  Outgoing answer_to(const Request& request) const;
};

namespace {

// One connection: reads a request, has it answered, writes the answer, and so on.
template <class State>
class Session : public std::enable_shared_from_this<Session<State>> {
 public:
  Session(State& state, asio::ip::tcp::socket socket)
      : state_(state),
        stream_(std::move(socket)),
        buffer_(static_cast<std::size_t>(state.options.max_request_bytes)) {
    ++state_.connections;
  }
  ~Session() { --state_.connections; }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  void read() {
    parser_.emplace();
    parser_->header_limit(static_cast<std::uint32_t>(state_.options.max_request_bytes));
    parser_->body_limit(static_cast<std::uint64_t>(state_.options.max_files_bytes));
    expire();
    http::async_read_header(stream_,
                            buffer_,
                            *parser_,
                            [self = this->shared_from_this()](error_code failed, std::size_t) {
                              self->on_head(failed);
                            });
  }

 private:
  void expire() { stream_.expires_after(std::chrono::milliseconds(state_.options.timeout_ms)); }

  // A body is read where one is taken; what is refused by its head is answered without it.
  void on_head(error_code failed) {
    if (!failed && state_.opener && websocket::is_upgrade(parser_->get())) return upgrade();
    if (failed || !state_.takes_body(parser_->get())) return on_read(failed);
    if (state_.is_too_long(parser_->get(), parser_->content_length().value_or(0)))
      return on_read(http::make_error_code(http::error::body_limit));
    http::async_read(stream_,
                     buffer_,
                     *parser_,
                     [self = this->shared_from_this()](error_code broken, std::size_t) {
                       self->on_read(broken);
                     });
  }

  // Who answers at the page's socket, or how it is refused.
  std::variant<std::unique_ptr<SocketPeer>, web::HttpReply> peer_for(const Request& request) {
    const Result<web::HttpAsk> ask = ask_of(request);
    if (!ask.ok()) return web::error_reply(400, ask.error());
    if (auto refused = state_.guard->refusal(*ask)) return *std::move(refused);
    Result<std::unique_ptr<SocketPeer>> opened = state_.opener(*ask);
    if (!opened.ok()) return web::error_reply(web::status_of(opened.error()), opened.error());
    return std::move(opened).value();
  }

  // What is refused is answered as other requests are.
  void upgrade() {
    const Request& request = parser_->get();
    auto met = peer_for(request);
    if (auto* peer = std::get_if<std::unique_ptr<SocketPeer>>(&met)) {
      stream_.expires_never();
      return carry_web_socket(
          stream_.release_socket(), request, std::move(*peer), state_.connections);
    }
    out_ =
        outgoing(unread(), std::get<web::HttpReply>(std::move(met)), {true, state_.options.embed});
    write(out_.head, true);
  }

  void on_read(error_code failed) {
    // What is no HTTP is told so; who has gone or takes too long is left.
    const bool not_http =
        failed.category() == http::make_error_code(http::error::bad_method).category() &&
        failed != http::error::end_of_stream;
    if (failed && !not_http) return;
    stream_.expires_never();  // our own time does not count
    asio::post(state_.makers, [self = this->shared_from_this(), failed] {
      self->out_ = failed
                       ? outgoing(unread(), unreadable(failed), {true, self->state_.options.embed})
                       : self->state_.answer_to(self->parser_->get());
      asio::dispatch(self->stream_.get_executor(), [self] { self->write(self->out_.head, true); });
    });
  }

  // In pieces, each of which has its own time to go out.
  void write(std::string_view rest, bool is_head) {
    constexpr std::size_t piece_bytes = 256U << 10;
    const std::string_view piece = rest.substr(0, piece_bytes);
    expire();
    asio::async_write(
        stream_,
        asio::buffer(piece.data(), piece.size()),
        [self = this->shared_from_this(), rest, is_head](error_code failed, std::size_t sent) {
          if (failed) return;
          if (sent < rest.size()) return self->write(rest.substr(sent), is_head);
          if (is_head && !self->out_.rest().empty()) return self->write(self->out_.rest(), false);
          self->finish();
        });
  }

  void finish() {
    const bool close = out_.close;
    out_ = {};  // large bodies are not kept for quiet connections
    if (!close) return read();
    error_code ignored;
    stream_.socket().shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
  }

  State& state_;
  beast::tcp_stream stream_;
  beast::flat_buffer buffer_;
  std::optional<http::request_parser<http::string_body>> parser_;
  Outgoing out_;
};

}  // namespace

Outgoing HttpServer::State::answer_to(const Request& request) const {
  const Result<web::HttpAsk> ask = ask_of(request);
  if (!ask.ok())
    return outgoing(unread(), web::error_reply(400, ask.error()), {true, options.embed});
  // A body that nobody reads would be taken for the next request.
  const bool has_body = request.has_content_length() || request.chunked();
  const bool close = !request.keep_alive() || (has_body && !takes_body(request));
  std::optional<web::HttpReply> refused = guard->refusal(*ask);
  return outgoing(*ask, refused ? *std::move(refused) : handler(*ask), {close, options.embed});
}

// Of a known length, to a server that takes any, and from who may post.
bool HttpServer::State::takes_body(const Request& request) const {
  if (!options.limits.may_write || request.method() != http::verb::post ||
      !request.has_content_length())
    return false;
  const Result<web::HttpAsk> ask = ask_of(request);
  return ask.ok() && !guard->refusal_of_head(*ask);
}

bool HttpServer::State::is_too_long(const Request& request, std::uint64_t body_bytes) const {
  const bool may_bring_files = request.target().starts_with("/api/make/");
  const int max_bytes = may_bring_files ? options.max_files_bytes : options.max_body_bytes;
  return body_bytes > static_cast<std::uint64_t>(max_bytes);
}

void HttpServer::State::accept() {
  acceptor.async_accept(asio::make_strand(io),
                        [this](error_code failed, asio::ip::tcp::socket socket) {
                          // One too many is closed at once.
                          if (!failed && connections < options.max_connections)
                            std::make_shared<Session<State>>(*this, std::move(socket))->read();
                          accept();
                        });
}

Result<void> HttpServer::State::listen() {
  error_code failed;
  const auto address = asio::ip::make_address(options.host, failed);
  const asio::ip::tcp::endpoint endpoint(address, static_cast<std::uint16_t>(options.port));
  const auto step = [&](auto&& done) {
    if (!failed) done();
  };
  step([&] { acceptor.open(endpoint.protocol(), failed); });
  step([&] { acceptor.set_option(asio::ip::tcp::acceptor::reuse_address(true), failed); });
  step([&] { acceptor.bind(endpoint, failed); });
  step([&] { acceptor.listen(asio::socket_base::max_listen_connections, failed); });
  if (failed)
    return Error{"server.cannot_listen",
                 fmt::format("{}:{}", in_brackets(options.host), options.port),
                 fmt::format("no server can be started there ({}); take another --port, or leave "
                             "it out for a free one",
                             failed.message())};
  port = acceptor.local_endpoint(failed).port();
  return {};
}

HttpServer::HttpServer(std::unique_ptr<State> state) : state_(std::move(state)) {}
HttpServer::~HttpServer() = default;

int HttpServer::port() const {
  return state_->port;
}

std::string HttpServer::address() const {
  return fmt::format("http://{}:{}/", in_brackets(state_->options.host), state_->port);
}

Result<std::unique_ptr<HttpServer>> HttpServer::start(const HttpServerOptions& options,
                                                      HttpHandler handler,
                                                      SocketOpener opener) {
  constexpr int carriers = 2;
  auto state = std::make_unique<State>(options);
  state->handler = std::move(handler);
  state->opener = std::move(opener);
  MARKETGEN_CHECK(state->listen());
  web::GuardRules rules = options.limits;
  rules.host = in_brackets(options.host);
  rules.port = state->port;
  rules.token = options.token;
  state->guard = std::make_unique<web::RequestGuard>(std::move(rules));
  state->accept();
  for (int i = 0; i < carriers; ++i)
    state->carriers.emplace_back([&io = state->io] { io.run(); });
  return std::unique_ptr<HttpServer>(new HttpServer(std::move(state)));
}

}  // namespace marketgen::server
