// A websocket between the server and one page, whatever library carries it.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "base/result.h"
#include "web/http_message.h"

namespace marketgen::server {

// What is sent to a page. Thread-safe, and never waits; sent to one that has gone it is dropped.
class SocketSender {
 public:
  virtual ~SocketSender() = default;
  // In their order, all of them: a page that takes none for long is cut off.
  virtual void text(std::string message) = 0;
  // Of these only the newest, when the page has taken what was before it.
  virtual void latest(std::shared_ptr<const std::string> bytes) = 0;
};

// The program's end of it. Called by one thread at a time; destroyed when the page has gone.
class SocketPeer {
 public:
  virtual ~SocketPeer() = default;
  virtual void opened(std::weak_ptr<SocketSender> page) = 0;  // once, first
  virtual void received(std::string_view text) = 0;
};

// Whether a page may have a socket at that address, and who answers there; must not wait.
// Thread-safe.
using SocketOpener = std::function<Result<std::unique_ptr<SocketPeer>>(const web::HttpAsk&)>;

}  // namespace marketgen::server
