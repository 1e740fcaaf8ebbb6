// The HTTP client against a server on this machine: what it sends and returns, when it tries again,
// and where it stops.
#include "net/http.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <thread>

#include "base/interrupt.h"
#include "net/retry.h"
#include "support/mock_server.h"

namespace marketgen {
namespace {

using nlohmann::json;

net::HttpClient client(net::HttpLimits limits = {}) {
  limits.first_wait_s = 0.01;
  net::HttpOptions options;
  options.limits = limits;
  return net::HttpClient::open(options).value();
}

double seconds_between(const json& a, const json& b) {
  return b["time"].get<double>() - a["time"].get<double>();
}

TEST(Http, SendsAndReturnsWhatIsThere) {
  const MockServer server(json::array({{{"status", 201},
                                        {"headers", {{"X-Answer", "a b"}, {"Set-Cookie", "c=1"}}},
                                        {"body", "grüß dich"}}}));
  net::HttpRequest request{
      "POST", server.url("/say?x=1"), {{"X-Question", "why"}}, {}, "body\n\"ü\""};
  request.secret_headers = {{"Authorization", "Bearer secret-key"}};
  const auto answer = client().send(request);
  ASSERT_TRUE(answer.ok()) << to_string(answer.error());
  EXPECT_EQ(answer->status, 201);
  EXPECT_EQ(answer->body, "grüß dich");
  EXPECT_EQ(answer->header("x-answer"), "a b");
  EXPECT_EQ(answer->header("set-cookie"), "");
  const json seen = server.requests().at(0);
  EXPECT_EQ(seen["method"], "POST");
  EXPECT_EQ(seen["path"], "/say?x=1");
  EXPECT_EQ(seen["body"], request.body);
  EXPECT_EQ(seen["headers"]["X-Question"], "why");
  EXPECT_EQ(seen["headers"]["Authorization"], "Bearer secret-key");
}

TEST(Http, WaitsAsLongAsTheServerAsks) {
  const MockServer server(
      json::array({{{"status", 429}, {"headers", {{"Retry-After", "1"}}}}, {{"body", "now"}}}));
  const auto answer = client().send({"GET", server.url(), {}, {}, ""});
  ASSERT_TRUE(answer.ok()) << to_string(answer.error());
  EXPECT_EQ(answer->body, "now");
  const auto seen = server.requests();
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_GE(seconds_between(seen[0], seen[1]), 0.99);
  EXPECT_LT(seconds_between(seen[0], seen[1]), 3);
}

TEST(Http, ReturnsAtOnceWhenTheServerAsksForTooLong) {
  const MockServer server(json::array({{{"status", 503}, {"headers", {{"Retry-After", "3600"}}}}}));
  const auto answer = client().send({"GET", server.url(), {}, {}, ""});
  ASSERT_TRUE(answer.ok());
  EXPECT_EQ(answer->status, 503);
  EXPECT_EQ(server.requests().size(), 1U);
}

TEST(Http, GivesUpAfterItsAttempts) {
  const MockServer server(json::array({{{"status", 500}, {"body", "broken"}}}));
  net::HttpLimits limits;
  limits.attempts = 3;
  const auto answer = client(limits).send({"GET", server.url(), {}, {}, ""});
  ASSERT_TRUE(answer.ok());
  EXPECT_EQ(answer->status, 500);
  EXPECT_EQ(answer->body, "broken");
  EXPECT_EQ(server.requests().size(), 3U);
}

TEST(Http, WhatTheServerRefusesIsNotRepeated) {
  for (const int status : {400, 401, 404, 501}) {
    const MockServer server(json::array({{{"status", status}}}));
    EXPECT_EQ(client().send({"GET", server.url(), {}, {}, ""})->status, status);
    EXPECT_EQ(server.requests().size(), 1U) << status;
  }
}

TEST(Http, TriesAgainWhenTheConnectionBreaks) {
  const MockServer server(json::array({{{"drop", true}}, {{"body", "here"}}}));
  const auto answer = client().send({"POST", server.url(), {}, {}, "x"});
  ASSERT_TRUE(answer.ok()) << to_string(answer.error());
  EXPECT_EQ(answer->body, "here");
  EXPECT_EQ(server.requests().size(), 2U);
}

TEST(Http, StopsWhenTimeIsUp) {
  const MockServer server(json::array({{{"delay_s", 20}}}));
  net::HttpLimits limits;
  limits.total_s = 0.3;
  const auto started = std::chrono::steady_clock::now();
  const auto answer = client(limits).send({"GET", server.url(), {}, {}, ""});
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - started;
  ASSERT_FALSE(answer.ok());
  EXPECT_EQ(answer.error().code, "net.timeout");
  EXPECT_LT(took.count(), 5);
  EXPECT_EQ(server.requests().size(), 1U);
}

TEST(Http, StopsAtTheSizeLimit) {
  const MockServer server(json::array({{{"size", 1001}},
                                       {{"size", 1001}, {"length", false}},
                                       {{"size", 1000}, {"length", false}}}));
  net::HttpLimits limits;
  limits.answer_bytes = 1000;
  for (int i = 0; i < 2; ++i) {
    const auto answer = client(limits).send({"GET", server.url(), {}, {}, ""});
    ASSERT_FALSE(answer.ok()) << i;
    EXPECT_EQ(answer.error().code, "net.too_large");
    EXPECT_NE(answer.error().message.find("1,000 bytes"), std::string::npos);
  }
  EXPECT_EQ(client(limits).send({"GET", server.url(), {}, {}, ""})->body.size(), 1000U);
}

TEST(Http, NobodyThere) {
  std::string url;
  {
    const MockServer server(json::array({json::object()}));
    url = server.url();
  }
  const auto answer = client().send({"GET", url, {}, {{"x-api-key", "very-secret"}}, ""});
  ASSERT_FALSE(answer.ok());
  EXPECT_EQ(answer.error().code, "net.unreachable");
  EXPECT_EQ(to_string(answer.error()).find("very-secret"), std::string::npos);
}

TEST(Http, OnlyPlainWebUrls) {
  for (const char* url : {"ftp://localhost/x",
                          "file:///etc/passwd",
                          "gopher://localhost/",
                          "no url",
                          "",
                          "http://",
                          "http://me:pass-word@localhost/",
                          "http://me:pass-word@",
                          "htp://localhost/?key=pass-word"}) {
    const auto answer = client().send({"GET", url, {}, {}, ""});
    ASSERT_FALSE(answer.ok()) << url;
    EXPECT_EQ(answer.error().code, "net.bad_url") << url;
    EXPECT_EQ(to_string(answer.error()).find("pass-word"), std::string::npos);
  }
}

TEST(Http, Origins) {
  EXPECT_EQ(*net::origin_of("https://API.example.org/v1"),
            (net::HttpOrigin{"https", "api.example.org", 443, false}));
  EXPECT_EQ(*net::origin_of("http://127.0.0.1:8000"),
            (net::HttpOrigin{"http", "127.0.0.1", 8000, true}));
  EXPECT_TRUE(net::origin_of("http://localhost:11434/v1")->loopback);
  EXPECT_TRUE(net::origin_of("http://[::1]:1/")->loopback);
  EXPECT_FALSE(net::origin_of("http://127.0.0.1.example.org/")->loopback);
}

// 127.0.0.1 and localhost are two hosts.
TEST(Http, KeysStayWithTheirHost) {
  const MockServer other(json::array({{{"body", "other"}}}));
  const std::string there = other.url("/x", "localhost");
  const auto sends_on = [](const std::string& to) {
    return json::array({{{"status", 307}, {"headers", {{"Location", to}}}}, {{"body", "same"}}});
  };
  {
    const MockServer server(sends_on("/second"));  // on the same host
    const auto answer = client().send({"POST", server.url(), {}, {{"x-api-key", "secret"}}, "b"});
    ASSERT_TRUE(answer.ok()) << to_string(answer.error());
    EXPECT_EQ(answer->body, "same");
    EXPECT_EQ(server.requests().at(1)["headers"]["x-api-key"], "secret");
    EXPECT_EQ(server.requests().at(1)["body"], "b");
  }
  const MockServer server(sends_on(there));
  const auto refused = client().send({"POST", server.url(), {}, {{"x-api-key", "secret"}}, "b"});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, "net.redirected");
  EXPECT_TRUE(other.requests().empty());
  const MockServer again(sends_on(there));
  EXPECT_EQ(client().send({"POST", again.url(), {}, {}, "b"})->body, "other");
}

TEST(Http, DoesNotRunInCircles) {
  const MockServer server(json::array({{{"status", 302}, {"headers", {{"Location", "/"}}}}}));
  const auto answer = client().send({"GET", server.url(), {}, {}, ""});
  ASSERT_FALSE(answer.ok());
  EXPECT_EQ(answer.error().code, "net.redirected");
  EXPECT_EQ(server.requests().size(), 4U);
  EXPECT_EQ(client().send({"POST", server.url(), {}, {}, ""})->status, 302);  // as it is
}

// Before the program would be ended by force, 0.7 s after the signal.
TEST(Http, AnInterruptEndsIt) {
  using Clock = std::chrono::steady_clock;
  const MockServer server(json::array({{{"delay_s", 20}}}));
  const std::string url = server.url();
  const auto interrupted = [&] {
    watch_for_interrupts();
    std::atomic<Clock::time_point> sent{};
    std::thread([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(300));
      sent = Clock::now();
      std::raise(SIGINT);
    }).detach();
    const auto answer = client().send({"GET", url, {}, {}, ""});
    const std::chrono::duration<double> took = Clock::now() - sent.load();
    const bool broken_off = !answer.ok() && answer.error().code == "internal.interrupted";
    _exit(broken_off && took.count() < 0.7 ? 7 : 1);
  };
  EXPECT_EXIT(interrupted(), testing::ExitedWithCode(7), "");
}

TEST(HttpRetry, PausesDoubleAndDependOnTheRequestAlone) {
  net::HttpLimits limits;
  limits.first_wait_s = 1;
  limits.longest_wait_s = 5;
  const net::HttpRequest one{"POST", "http://h/", {}, {}, "one"},
      two{"POST", "http://h/", {}, {}, "two"};
  const double full[] = {1, 2, 4, 5, 5};
  for (int next = 1; next <= 5; ++next) {
    const double pause = net::retry_pause_s(next, one, limits);
    EXPECT_GE(pause, full[next - 1] / 2);
    EXPECT_LE(pause, full[next - 1]);
    EXPECT_EQ(pause, net::retry_pause_s(next, one, limits));
    EXPECT_NE(pause, net::retry_pause_s(next, two, limits));
  }
}

TEST(Base64, TheVectorsOfRfc4648) {
  const std::pair<const char*, const char*> vectors[] = {{"", ""},
                                                         {"f", "Zg=="},
                                                         {"fo", "Zm8="},
                                                         {"foo", "Zm9v"},
                                                         {"foob", "Zm9vYg=="},
                                                         {"fooba", "Zm9vYmE="},
                                                         {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : vectors) {
    EXPECT_EQ(net::base64_of(bytes), text);
    EXPECT_EQ(net::bytes_of_base64(text, "").value(), bytes);
  }
  EXPECT_EQ(net::bytes_of_base64("Zg=", "here").error().code, "net.bad_record");
  EXPECT_EQ(net::bytes_of_base64("Z!==", "here").error().code, "net.bad_record");
}

}  // namespace
}  // namespace marketgen
