#include "web/request_guard.h"

#include <gtest/gtest.h>

namespace marketgen {
namespace {

using Clock = web::RequestGuard::Clock;

web::HttpAsk ask(const std::string& host, const std::string& origin = "") {
  web::HttpAsk asked;
  asked.method = "GET";
  asked.path = "/api/stores";
  asked.headers["host"] = host;
  if (!origin.empty()) asked.headers["origin"] = origin;
  return asked;
}

int status(web::RequestGuard& guard, const web::HttpAsk& asked) {
  const auto refused = guard.refusal(asked);
  return refused ? refused->status : 200;
}

web::GuardRules rules(const std::string& token = "") {
  return {.host = "127.0.0.1", .port = 8123, .token = token};
}

TEST(RequestGuard, LetsOwnNamesPass) {
  web::RequestGuard guard(rules());
  for (const char* host : {"127.0.0.1:8123", "localhost:8123", "LOCALHOST:8123", "[::1]:8123"})
    EXPECT_EQ(status(guard, ask(host)), 200) << host;
  EXPECT_EQ(status(guard, ask("127.0.0.1:8123", "http://localhost:8123")), 200);
}

// DNS rebinding: the name of another site that stands for this machine.
TEST(RequestGuard, RefusesForeignHosts) {
  web::RequestGuard guard(rules());
  for (const char* host : {"",
                           "evil.example:8123",
                           "127.0.0.1",
                           "127.0.0.1:80",
                           "127.0.0.1:8123.evil.example",
                           "localhost:81234"})
    EXPECT_EQ(status(guard, ask(host)), 403) << host;
}

TEST(RequestGuard, RefusesForeignOrigins) {
  web::RequestGuard guard(rules());
  for (const char* origin : {"http://evil.example",
                             "null",
                             "https://127.0.0.1:8123",
                             "http://127.0.0.1:9000",
                             "http://127.0.0.1:8123@evil.example"})
    EXPECT_EQ(status(guard, ask("127.0.0.1:8123", origin)), 403) << origin;
}

web::HttpAsk edit(const std::string& method = "POST",
                  const std::string& type = "application/json",
                  const std::string& origin = "") {
  web::HttpAsk asked = ask("127.0.0.1:8123", origin);
  asked.method = method;
  asked.path = "/api/stores/0/edit/patches";
  asked.headers["content-type"] = type;
  return asked;
}

TEST(RequestGuard, LetsEditsPassWhereOneMayEdit) {
  web::GuardRules may = rules();
  may.may_write = true;
  web::RequestGuard guard(may);
  EXPECT_EQ(status(guard, edit()), 200);
  EXPECT_EQ(status(guard, edit("POST", "application/json; charset=utf-8")), 200);
  EXPECT_EQ(status(guard, edit("POST", "application/json", "http://127.0.0.1:8123")), 200);
  EXPECT_EQ(status(guard, edit("POST", "application/json", "http://evil.example")), 403);
  for (const char* type : {"", "text/plain", "application/x-www-form-urlencoded"})
    EXPECT_EQ(status(guard, edit("POST", type)), 403) << "a form of another site: " << type;
  for (const char* method : {"PUT", "DELETE", "OPTIONS"})
    EXPECT_EQ(status(guard, edit(method)), 405) << method;
  for (const char* path : {"/", "/api/stores/0", "/api/stores/0/edit", "/api/stores/0/edit/a/b"}) {
    web::HttpAsk elsewhere = edit();
    elsewhere.path = path;
    EXPECT_EQ(status(guard, elsewhere), 405) << path;
  }
  web::RequestGuard reads(rules());
  EXPECT_EQ(status(reads, edit()), 405) << "--read-only";
}

TEST(RequestGuard, LimitsHowOftenOneWrites) {
  web::GuardRules may = rules();
  may.may_write = true;
  may.write_burst = 3;
  web::RequestGuard guard(may);
  const Clock::time_point now = Clock::now();
  for (int i = 0; i < 3; ++i)
    EXPECT_FALSE(guard.refusal(edit(), now));
  EXPECT_EQ(guard.refusal(edit(), now)->status, 429);
  EXPECT_FALSE(guard.refusal(ask("127.0.0.1:8123"), now)) << "reading goes on";
  EXPECT_FALSE(guard.refusal(edit(), now + std::chrono::seconds(1)));
}

TEST(RequestGuard, OnlyReads) {
  web::RequestGuard guard(rules());
  for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "TRACE", "get", ""}) {
    web::HttpAsk asked = ask("127.0.0.1:8123");
    asked.method = method;
    EXPECT_EQ(status(guard, asked), 405) << method;
  }
}

TEST(RequestGuard, AsksForTheToken) {
  web::RequestGuard guard(rules("sesame-sesame-sesame"));
  web::HttpAsk asked = ask("127.0.0.1:8123");
  EXPECT_EQ(status(guard, asked), 403);
  for (const char* wrong : {"", "sesame", "sesame-sesame-sesamE", "sesame-sesame-sesame-"}) {
    asked.query["token"] = wrong;
    EXPECT_EQ(status(guard, asked), 403) << wrong;
  }
  asked.query["token"] = "sesame-sesame-sesame";
  EXPECT_EQ(status(guard, asked), 200);
  asked.query.clear();
  asked.headers["authorization"] = "Bearer sesame-sesame-sesame";
  EXPECT_EQ(status(guard, asked), 200);
  web::HttpAsk page = ask("127.0.0.1:8123");
  page.path = "/";
  EXPECT_EQ(status(guard, page), 200);
}

// From another machine this one has another name; pages of other sites are refused all the same.
TEST(RequestGuard, WithATokenTakesAnyNameOfItsOwn) {
  web::RequestGuard guard(rules("sesame-sesame-sesame"));
  web::HttpAsk asked = ask("192.168.1.5:8123", "http://192.168.1.5:8123");
  asked.query["token"] = "sesame-sesame-sesame";
  EXPECT_EQ(status(guard, asked), 200);
  asked.headers["origin"] = "http://evil.example";
  EXPECT_EQ(status(guard, asked), 403);
}

TEST(RequestGuard, SlowsDownWhoAsksTooOften) {
  web::GuardRules slow = rules();
  std::tie(slow.burst, slow.requests_per_s) = std::pair(10.0, 5.0);
  web::RequestGuard guard(slow);
  const Clock::time_point now = Clock::now();
  const web::HttpAsk asked = ask("127.0.0.1:8123");
  for (int i = 0; i < 10; ++i)
    EXPECT_FALSE(guard.refusal(asked, now)) << i;
  const auto refused = guard.refusal(asked, now);
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->status, 429);
  EXPECT_GT(refused->retry_after_s, 0);
  for (int i = 0; i < 5; ++i)
    EXPECT_FALSE(guard.refusal(asked, now + std::chrono::milliseconds(1001))) << i;
  EXPECT_TRUE(guard.refusal(asked, now + std::chrono::milliseconds(1001)));
}

}  // namespace
}  // namespace marketgen
