// Websockets over real sockets: what a page sends comes through, and who does not keep to the
// protocol is cut off while the server goes on.
#include "server/web_socket.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <random>
#include <thread>

#include "server/http_server.h"
#include "support/raw_client.h"

namespace marketgen {
namespace {

std::atomic<int> peers = 0;

// Says what it hears.
class Echo : public server::SocketPeer {
 public:
  Echo() { ++peers; }
  ~Echo() override { --peers; }
  Echo(const Echo&) = delete;
  Echo& operator=(const Echo&) = delete;
  void opened(std::weak_ptr<server::SocketSender> page) override {
    page_ = std::move(page);
    page_.lock()->latest(std::make_shared<const std::string>("hello"));
  }
  void received(std::string_view text) override { page_.lock()->text(std::string(text)); }

 private:
  std::weak_ptr<server::SocketSender> page_;
};

constexpr unsigned char text_frame = 0x81, binary_frame = 0x82, close_frame = 0x88;

// A client's frames are masked (RFC 6455, 5.3).
std::string frame(unsigned char kind, std::string_view payload) {
  std::string bytes(1, static_cast<char>(kind));
  if (payload.size() < 126) {
    bytes += static_cast<char>(0x80 | payload.size());
  } else {
    bytes += static_cast<char>(0x80 | 126);
    bytes += static_cast<char>(payload.size() >> 8);
    bytes += static_cast<char>(payload.size() & 255);
  }
  const std::string mask = "mask";
  bytes += mask;
  for (std::size_t i = 0; i < payload.size(); ++i)
    bytes += static_cast<char>(payload[i] ^ mask[i % 4]);
  return bytes;
}

class WebSocket : public testing::Test {
 protected:
  void SetUp() override {
    auto started = server::HttpServer::start(
        {},
        [](const web::HttpAsk&) { return web::json_reply("{}"); },
        [](const web::HttpAsk& ask) -> Result<std::unique_ptr<server::SocketPeer>> {
          if (ask.path != "/socket") return Error{"server.not_found", ask.path, "no socket"};
          return std::unique_ptr<server::SocketPeer>(std::make_unique<Echo>());
        });
    ASSERT_TRUE(started.ok()) << to_string(started.error());
    server_ = std::move(started).value();
    port_ = server_->port();
  }
  std::string ask(const std::string& path, const std::string& more = "") const {
    return get_request(path,
                       port_,
                       "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
                       "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n" +
                           more);
  }
  // The kind of the next frame and what is in it.
  static std::pair<unsigned char, std::string> take(RawClient& client) {
    const auto some = [&](std::size_t bytes) {
      std::string all;
      while (all.size() < bytes) {
        const std::string piece = client.read(bytes - all.size());
        if (piece.empty()) break;
        all += piece;
      }
      return all;
    };
    const std::string head = some(2);
    if (head.size() < 2) return {0, ""};
    std::size_t length = static_cast<unsigned char>(head[1]);
    if (length == 126) {
      const std::string more = some(2);
      length = static_cast<unsigned char>(more[0]) * 256U + static_cast<unsigned char>(more[1]);
    }
    return {static_cast<unsigned char>(head[0]), some(length)};
  }
  void open(RawClient& client) const {
    client.send(ask("/socket"));
    const RawAnswer answer = client.head();
    EXPECT_EQ(answer.status, 101);
    EXPECT_EQ(answer.headers.at("sec-websocket-accept"), "s3pPLMBiTxaQ9kYGzzhZRbK+xOo=")
        << "RFC 6455, 1.3";
    EXPECT_EQ(take(client), (std::pair<unsigned char, std::string>{binary_frame, "hello"}));
  }
  // Within a minute: how fast the machine is is not what is tested.
  bool all_gone() const {
    for (int i = 0; i < 6000 && peers > 0; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return peers == 0;
  }

  std::unique_ptr<server::HttpServer> server_;
  int port_ = 0;
};

TEST_F(WebSocket, CarriesWhatIsSaid) {
  {
    RawClient client(port_);
    open(client);
    const std::string longer(4000, 'x');
    for (const std::string& text : {std::string("one"), longer, std::string("three")}) {
      client.send(frame(text_frame, text));
      EXPECT_EQ(take(client), (std::pair<unsigned char, std::string>{text_frame, text}));
    }
    EXPECT_EQ(get(port_, "/x").status, 200);
  }
  EXPECT_TRUE(all_gone()) << "who goes is noticed";
}

TEST_F(WebSocket, IsRefusedAsOtherRequestsAre) {
  RawClient foreign(port_);
  foreign.send(ask("/socket", "Origin: http://elsewhere.example\r\n"));
  EXPECT_EQ(foreign.answer().status, 403);
  RawClient lost(port_);
  lost.send(ask("/elsewhere"));
  EXPECT_EQ(lost.answer().status, 404);
  RawClient plain(port_);
  plain.send(get_request("/socket", port_));
  EXPECT_EQ(plain.answer().status, 200) << "no upgrade";
  EXPECT_TRUE(all_gone());
}

TEST_F(WebSocket, CutsOffWhoDoesNotKeepToIt) {
  const std::string unmasked{'\x81', '\x02', 'h', 'i'};
  for (const std::string& bytes : {frame(binary_frame, "numbers"),
                                   frame(text_frame, std::string(4097, 'x')),
                                   unmasked,
                                   std::string(20, '\xff'),
                                   frame(text_frame, "\xc3\x28")}) {
    RawClient client(port_);
    open(client);
    client.send(bytes);
    const auto [kind, why] = take(client);
    EXPECT_TRUE(kind == close_frame || kind == 0) << static_cast<int>(kind);
  }
  {
    RawClient loud(port_);
    open(loud);
    for (int i = 0; i < 400; ++i)
      loud.send(frame(text_frame, "a"));
    unsigned char kind = text_frame;
    for (int said = 0; kind == text_frame && said < 400; ++said)
      kind = take(loud).first;
    EXPECT_NE(kind, text_frame) << "not all that was sent was answered";
  }
  EXPECT_TRUE(all_gone());
}

TEST_F(WebSocket, LivesThroughRandomBytes) {
  std::mt19937 random(7);
  for (int i = 0; i < 60; ++i) {
    RawClient client(port_);
    open(client);
    std::string bytes;
    for (std::size_t k = 0; k < 2000; ++k)
      bytes += static_cast<char>(random() % 256);
    client.send(bytes);
  }
  EXPECT_TRUE(all_gone());
  RawClient client(port_);
  open(client);
}

// Frames that are in order, of whatever bytes, and some that are not.
TEST_F(WebSocket, LivesThroughAHundredThousandRandomFrames) {
  constexpr int connections = 500, each = 200;
  std::mt19937 random(8);
  for (int c = 0; c < connections; ++c) {
    RawClient client(port_);
    open(client);
    std::string bytes;
    for (int i = 0; i < each; ++i) {
      std::string text(random() % 40, ' ');
      for (char& letter : text)  // now and then a letter that is none
        letter = static_cast<char>(random() % 200 == 0 ? random() % 256 : 32 + random() % 95);
      std::string one = frame(text_frame, text);
      if (random() % 500 == 0) one[random() % one.size()] = static_cast<char>(random());
      bytes += one;
    }
    client.send(bytes);
  }
  EXPECT_TRUE(all_gone());
  RawClient client(port_);
  open(client);
}

}  // namespace
}  // namespace marketgen
