// An HTTP server on one address, for pages in a browser on this machine.
//
// Requests are answered on up to `threads` threads side by side; each has `timeout_ms` to be sent,
// and as long for every 256 kB of its answer to be taken. Headers that keep a page from loading
// anything from elsewhere, and others from showing it, stand on every answer.
#pragma once
#include <functional>
#include <memory>
#include <string>

#include "base/result.h"
#include "server/web_socket.h"
#include "web/request_guard.h"

namespace marketgen::server {

struct HttpServerOptions {
  std::string host = "127.0.0.1";  // a numeric address; "::1" too
  int port = 0;                    // 0: any free one
  std::string token;               // see web::GuardRules
  bool embed = false;              // pages that this machine serves may show ours in a frame
  int threads = 64;                // some wait for what is being built
  int max_connections = 256;
  int timeout_ms = 10'000;
  int max_request_bytes = 16'384;    // of its head
  int max_body_bytes = 65'536;       // of what is posted; bodies of other requests are refused
  int max_files_bytes = 25'165'824;  // of what is posted below /api/make/: it may bring pictures
  web::GuardRules limits;            // its host, port and token are set here
};

using HttpHandler = std::function<web::HttpReply(const web::HttpAsk&)>;

class HttpServer {
 public:
  // Answers until it is destroyed, which ends all connections. `handler` is called from many
  // threads. `opener` is asked when a client that the guard lets pass wants a websocket; without
  // one that is a request like others. Errors: server.cannot_listen.
  static Result<std::unique_ptr<HttpServer>> start(const HttpServerOptions& options,
                                                   HttpHandler handler,
                                                   SocketOpener opener = {});
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;
  ~HttpServer();

  int port() const;
  std::string address() const;  // "http://127.0.0.1:8123/"

 private:
  struct State;
  explicit HttpServer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace marketgen::server
