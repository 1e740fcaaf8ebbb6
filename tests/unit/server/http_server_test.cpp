// The server over real sockets: what browsers ask, and what others may send.
#include "server/http_server.h"

#include <gtest/gtest.h>

#include <atomic>
#include <random>
#include <thread>
#include <vector>

#include "io/gzip.h"
#include "support/raw_client.h"

namespace marketgen {
namespace {

constexpr std::size_t large_bytes = 8U << 20;

web::HttpReply echo(const web::HttpAsk& ask) {
  if (ask.path == "/large")
    return {.body = web::make_body("image/jpeg", std::string(large_bytes, 'x'))};
  if (ask.path == "/text") return {.body = web::make_body("text/plain", std::string(100'000, 'a'))};
  if (ask.method == "POST") return web::json_reply(ask.body);
  return web::json_reply("{\"path\": \"" + ask.path + "\"}");
}

class HttpServer : public testing::Test {
 protected:
  void start(const server::HttpServerOptions& options = {}) {
    auto started = server::HttpServer::start(options, echo);
    ASSERT_TRUE(started.ok()) << to_string(started.error());
    server_ = std::move(started).value();
    port_ = server_->port();
  }
  bool lives() const { return get(port_, "/still-here").status == 200; }

  std::unique_ptr<server::HttpServer> server_;
  int port_ = 0;
};

TEST_F(HttpServer, AnswersOnAFreePort) {
  start();
  EXPECT_GT(port_, 0);
  EXPECT_EQ(server_->address(), "http://127.0.0.1:" + std::to_string(port_) + "/");
  const RawAnswer answer = get(port_, "/api/x");
  EXPECT_EQ(answer.status, 200);
  EXPECT_EQ(answer.body, R"({"path": "/api/x"})");
  EXPECT_EQ(answer.headers.at("content-type"), "application/json");
  EXPECT_EQ(answer.headers.at("x-content-type-options"), "nosniff");
  EXPECT_NE(answer.headers.at("content-security-policy").find("default-src 'none'"),
            std::string::npos);
}

TEST_F(HttpServer, SaysThatAPortIsTaken) {
  start();
  server::HttpServerOptions same;
  same.port = port_;
  const auto second = server::HttpServer::start(same, echo);
  ASSERT_FALSE(second.ok());
  EXPECT_EQ(second.error().code, "server.cannot_listen");
  EXPECT_NE(second.error().where.find(std::to_string(port_)), std::string::npos);
}

std::string post_request(int port, const std::string& body, const std::string& more) {
  return "POST /api/stores/0/edit/say HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) +
         "\r\nContent-Type: application/json\r\n" + more + "\r\n" + body;
}
std::string of_length(std::size_t bytes) {
  return "Content-Length: " + std::to_string(bytes) + "\r\n";
}

TEST_F(HttpServer, TakesBodiesWhereOneMayWrite) {
  server::HttpServerOptions options;
  options.limits.may_write = true;
  start(options);
  RawClient client(port_);
  const std::string body = "{\"words\": \"" + std::string(60'000, 'a') + "\"}";
  for (int i = 0; i < 2; ++i) {  // the connection lives on
    client.send(post_request(port_, body, of_length(body.size())));
    EXPECT_EQ(client.answer().body, body);
  }
  RawClient parts(port_);
  parts.send(post_request(port_, body.substr(0, 100), of_length(body.size())));
  parts.send(body.substr(100));
  EXPECT_EQ(parts.answer().body, body);
  EXPECT_TRUE(lives());
}

TEST_F(HttpServer, RefusesBodiesThatAreTooLongOrOfNoLength) {
  server::HttpServerOptions options;
  options.limits.may_write = true;
  start(options);
  RawClient large(port_);
  large.send(post_request(port_, "", of_length(65'537)));
  EXPECT_EQ(large.answer().status, 413);
  RawClient chunked(port_);
  chunked.send(post_request(port_, "5\r\nhello\r\n0\r\n\r\n", "Transfer-Encoding: chunked\r\n"));
  EXPECT_EQ(chunked.answer().body, "") << "not read";
  RawClient cut(port_);  // says more than it sends, and goes
  cut.send(post_request(port_, "{", of_length(1000)));
  EXPECT_TRUE(lives());
}

TEST_F(HttpServer, RefusesBodiesWhereNobodyWrites) {
  start();
  RawClient client(port_);
  client.send(post_request(port_, "{}", of_length(2)));
  EXPECT_EQ(client.answer().status, 405);
}

TEST_F(HttpServer, KeepsConnections) {
  start();
  RawClient client(port_);
  for (int i = 0; i < 5; ++i) {
    client.send(get_request("/" + std::to_string(i), port_));
    EXPECT_EQ(client.answer().body, "{\"path\": \"/" + std::to_string(i) + "\"}");
  }
}

TEST_F(HttpServer, PacksForThoseWhoCanUnpack) {
  start();
  const RawAnswer packed = get(port_, "/text", "Accept-Encoding: br, gzip\r\n");
  EXPECT_EQ(packed.headers.at("content-encoding"), "gzip");
  EXPECT_EQ(*io::gunzip(packed.body, "answer"), std::string(100'000, 'a'));
  EXPECT_EQ(get(port_, "/text").body, std::string(100'000, 'a'));
}

TEST_F(HttpServer, SendsWhatIsKnownOnce) {
  start();
  const std::string etag = get(port_, "/text").headers.at("etag");
  const RawAnswer again = get(port_, "/text", "If-None-Match: " + etag + "\r\n");
  EXPECT_EQ(again.status, 304);
  EXPECT_TRUE(again.body.empty());
  EXPECT_EQ(get(port_, "/text", "If-None-Match: \"other\"\r\n").status, 200);
}

TEST_F(HttpServer, AnswersHeadWithoutABody) {
  start();
  RawClient client(port_);
  client.send("HEAD /text HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port_) + "\r\n\r\n");
  const RawAnswer head = client.answer(false);
  EXPECT_EQ(head.status, 200);
  EXPECT_EQ(head.headers.at("content-length"), "100000");
  EXPECT_EQ(client.sip(1), 0U);
}

TEST_F(HttpServer, RefusesForeignHostsAndOrigins) {
  start();
  RawClient rebound(port_);
  rebound.send("GET /api/stores HTTP/1.1\r\nHost: evil.example\r\n\r\n");
  EXPECT_EQ(rebound.answer().status, 403);
  RawClient nameless(port_);
  nameless.send("GET /api/stores HTTP/1.0\r\n\r\n");
  EXPECT_EQ(nameless.answer().status, 403);
  EXPECT_EQ(get(port_, "/", "Origin: http://evil.example\r\n").status, 403);
}

TEST_F(HttpServer, RefusesWhatIsNoRequest) {
  start();
  for (const std::string& bytes :
       {std::string("\r\n\r\n"),
        std::string("hello\r\n\r\n"),
        std::string("GET\r\n\r\n"),
        std::string("GET / HTTP/9.9\r\n\r\n"),
        std::string("GET /../../etc/passwd HTTP/1.1\r\n\r\n"),
        std::string("GET /%2e%2e/%2e%2e/etc/passwd HTTP/1.1\r\n\r\n"),
        std::string("GET /%00 HTTP/1.1\r\nHost: a\r\n\r\n"),
        std::string("GET / HTTP/1.1\r\n: x\r\n\r\n"),
        std::string("\0\0\0\0\r\n\r\n", 8),
        "GET /" + std::string(100'000, 'a') + " HTTP/1.1\r\n\r\n",
        "GET / HTTP/1.1\r\nX: " + std::string(100'000, 'a') + "\r\n\r\n"}) {
    RawClient client(port_);
    client.send(bytes);
    const RawAnswer answer = client.answer();
    EXPECT_TRUE(answer.status == 0 || (answer.status >= 400 && answer.status < 506))
        << bytes.substr(0, 40) << ": " << answer.status;
  }
  EXPECT_TRUE(lives());
}

TEST_F(HttpServer, RefusesToBeWrittenTo) {
  start();
  RawClient client(port_);
  client.send("POST / HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port_) +
              "\r\nContent-Length: 5\r\n\r\nhello");
  EXPECT_EQ(client.answer().status, 405);
  EXPECT_TRUE(lives());
}

TEST_F(HttpServer, OutlivesRandomBytes) {
  start();
  std::mt19937 random(7);  // NOLINT(cert-msc51-cpp): the same every time
  for (int i = 0; i < 300; ++i) {
    RawClient client(port_, 1);
    std::string bytes = i % 2 == 0 ? "GET /" : "";
    const auto count = random() % 400;
    for (unsigned k = 0; k < count; ++k)
      bytes += static_cast<char>(random());
    client.send(bytes + (i % 3 == 0 ? "" : "\r\n\r\n"));
  }
  EXPECT_TRUE(lives());
}

// Requests that were sound before some of their bytes were changed, cut off or doubled; a
// connection that is refused is begun anew.
TEST_F(HttpServer, OutlivesAHundredThousandDamagedRequests) {
  server::HttpServerOptions options;
  std::tie(options.limits.burst, options.limits.requests_per_s) = std::pair(1e9, 1e9);
  options.limits.may_write = true;
  start(options);
  constexpr int connections = 1000, each = 100;
  const std::string host = "Host: 127.0.0.1:" + std::to_string(port_) + "\r\n";
  const std::vector<std::string> sound{
      get_request("/api/stores/0/search?q=oat%20milk&max=5", port_, "Accept-Encoding: gzip\r\n"),
      "HEAD /text HTTP/1.1\r\n" + host + "\r\n",
      "POST /api/make/try HTTP/1.1\r\n" + host +
          "Content-Type: application/json\r\nContent-Length: 14\r\n\r\n{\"words\": \"x\"}"};
  std::mt19937 random(7);  // NOLINT(cert-msc51-cpp): the same every time
  for (int c = 0; c < connections; ++c) {
    std::string bytes;
    for (int i = 0; i < each; ++i) {
      std::string request = sound[random() % sound.size()];
      for (auto changes = random() % 3; changes > 0; --changes)
        request[random() % request.size()] = static_cast<char>(random());
      if (random() % 50 == 0) request.resize(random() % request.size());
      bytes += request;
    }
    RawClient client(port_, 1);
    client.send(bytes);
    if (c % 4 == 0) client.answer();  // most go without waiting
  }
  EXPECT_TRUE(lives());
}

TEST_F(HttpServer, ServesFiftyAtOnce) {
  start();
  constexpr int clients = 50, requests = 20;
  std::atomic<int> good = 0;
  std::vector<std::thread> threads;
  for (int c = 0; c < clients; ++c)
    threads.emplace_back([&] {
      RawClient client(port_);
      for (int r = 0; r < requests; ++r) {
        client.send(get_request("/text", port_, "Accept-Encoding: gzip\r\n"));
        if (client.answer().status == 200) ++good;
      }
    });
  for (std::thread& thread : threads)
    thread.join();
  EXPECT_EQ(good, clients * requests);
}

// Clients that take what they asked for byte by byte, or never finish asking, hold no one else up.
TEST_F(HttpServer, WaitsForNobodySlow) {
  server::HttpServerOptions options;
  options.timeout_ms = 2000;
  start(options);
  std::vector<std::unique_ptr<RawClient>> slow;
  for (int i = 0; i < 20; ++i) {
    slow.push_back(std::make_unique<RawClient>(port_));
    slow.back()->send(i % 2 == 0 ? get_request("/large", port_) : "GET /never-finish");
  }
  for (const auto& client : slow)
    client->sip(1);
  const auto begun = std::chrono::steady_clock::now();
  EXPECT_EQ(get(port_, "/text").status, 200);
  EXPECT_EQ(get(port_, "/large").body.size(), large_bytes);
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(5));
}

TEST_F(HttpServer, IsInFramesOfThisMachineOnlyWhenSaid) {
  const auto frames = [&] {
    const std::string policy = get(port_, "/").headers.at("content-security-policy");
    return policy.substr(policy.find("frame-ancestors"));
  };
  start();
  EXPECT_EQ(frames(), "frame-ancestors 'self'");
  server::HttpServerOptions options;
  options.embed = true;
  start(options);
  EXPECT_EQ(frames(), "frame-ancestors 'self' http://localhost:* http://127.0.0.1:*");
  EXPECT_EQ(get(port_, "/nothing").headers.at("content-security-policy").find("'none'"), 12U)
      << "and nothing else is laxer";
}

TEST_F(HttpServer, LimitsHowOftenOneMayAsk) {
  server::HttpServerOptions options;
  std::tie(options.limits.burst, options.limits.requests_per_s) = std::pair(3.0, 0.001);
  start(options);
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(get(port_, "/").status, 200);
  const RawAnswer refused = get(port_, "/");
  EXPECT_EQ(refused.status, 429);
  EXPECT_EQ(refused.headers.at("retry-after"), "1");
}

}  // namespace
}  // namespace marketgen
