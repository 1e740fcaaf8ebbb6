#include "server/web_socket_session.h"

#include <chrono>
#include <deque>
#include <utility>

#include <boost/asio/post.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <boost/beast/websocket/stream.hpp>

namespace marketgen::server {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using boost::system::error_code;
using SocketClock = std::chrono::steady_clock;

constexpr std::size_t max_message_bytes = 4096, max_waiting_texts = 64;
constexpr int max_messages_a_second = 200;
constexpr std::chrono::seconds handshake_time{10}, silent_time{20};

class WebSocketSession : public SocketSender,
                         public std::enable_shared_from_this<WebSocketSession> {
 public:
  WebSocketSession(asio::ip::tcp::socket socket,
                   std::unique_ptr<SocketPeer> peer,
                   std::atomic<int>& connections)
      : socket_(std::move(socket)), peer_(std::move(peer)), connections_(connections) {
    ++connections_;
    socket_.set_option(websocket::stream_base::timeout{handshake_time, silent_time, true});
    socket_.read_message_max(max_message_bytes);
  }
  ~WebSocketSession() override { --connections_; }
  WebSocketSession(const WebSocketSession&) = delete;
  WebSocketSession& operator=(const WebSocketSession&) = delete;

  template <class Request>
  void open(const Request& request) {
    socket_.async_accept(request, [self = shared_from_this()](error_code failed) {
      if (failed) return;
      self->peer_->opened(self);
      self->read();
    });
  }

  void text(std::string message) override {
    asio::post(socket_.get_executor(),
               [self = shared_from_this(), message = std::move(message)]() mutable {
                 if (self->texts_.size() >= max_waiting_texts) return self->drop();
                 self->texts_.push_back(std::move(message));
                 self->write();
               });
  }
  void latest(std::shared_ptr<const std::string> bytes) override {
    asio::post(socket_.get_executor(),
               [self = shared_from_this(), bytes = std::move(bytes)]() mutable {
                 self->latest_ = std::move(bytes);
                 self->write();
               });
  }

 private:
  void read() {
    socket_.async_read(buffer_, [self = shared_from_this()](error_code failed, std::size_t) {
      if (failed || self->closing_) return;
      if (!self->socket_.got_text()) return self->cut(websocket::close_code::unknown_data);
      if (!self->within_rate()) return self->cut(websocket::close_code::policy_error);
      const auto data = self->buffer_.data();
      self->peer_->received({static_cast<const char*>(data.data()), data.size()});
      self->buffer_.consume(self->buffer_.size());
      self->read();
    });
  }

  bool within_rate() {
    const SocketClock::time_point now = SocketClock::now();
    if (now - second_ >= std::chrono::seconds(1)) {
      second_ = now;
      messages_ = 0;
    }
    return ++messages_ <= max_messages_a_second;
  }

  void write() {
    if (writing_ || closing_ || (texts_.empty() && latest_ == nullptr)) return;
    writing_ = true;
    const bool is_text = !texts_.empty();
    if (is_text) {
      out_ = std::make_shared<const std::string>(std::move(texts_.front()));
      texts_.pop_front();
    } else {
      out_ = std::exchange(latest_, nullptr);
    }
    socket_.text(is_text);
    socket_.async_write(asio::buffer(*out_),
                        [self = shared_from_this()](error_code failed, std::size_t) {
                          self->writing_ = false;
                          if (!failed) self->write();
                        });
  }

  // Only where nothing is being read: Beast's close waits for a read that may be waiting for it.
  void cut(websocket::close_code why) {
    if (std::exchange(closing_, true)) return;
    socket_.async_close(why, [self = shared_from_this()](error_code) {});
  }

  // Without a word, which would wait behind all that was not taken. What is under way ends.
  void drop() {
    closing_ = true;
    socket_.next_layer().close();
  }

  websocket::stream<beast::tcp_stream> socket_;
  std::unique_ptr<SocketPeer> peer_;
  std::atomic<int>& connections_;
  beast::flat_buffer buffer_;
  std::deque<std::string> texts_;
  std::shared_ptr<const std::string> latest_, out_;
  bool writing_ = false, closing_ = false;
  SocketClock::time_point second_ = SocketClock::now();
  int messages_ = 0;  // in this second
};

}  // namespace

void carry_web_socket(asio::ip::tcp::socket socket,
                      const beast::http::request<beast::http::string_body>& request,
                      std::unique_ptr<SocketPeer> peer,
                      std::atomic<int>& connections) {
  std::make_shared<WebSocketSession>(std::move(socket), std::move(peer), connections)
      ->open(request);
}

}  // namespace marketgen::server
