// Recorded exchanges: what was answered once is answered again with the server gone, byte for byte,
// and no key is in the files.
#include <gtest/gtest.h>

#include "net/http.h"
#include "support/mock_server.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

net::HttpClient recorder(const fs::path& folder) {
  net::HttpOptions options;
  options.record = folder;
  return net::HttpClient::open(options).value();
}
net::HttpClient player(const fs::path& folder) {
  net::HttpOptions options;
  options.replay = folder;
  return net::HttpClient::open(options).value();
}

net::HttpRequest question(const MockServer& server, const std::string& body) {
  return {"POST", server.url("/ask"), {{"Content-Type", "text/plain"}}, {}, body};
}

void expect_equal(const Result<net::HttpAnswer>& a, const Result<net::HttpAnswer>& b) {
  ASSERT_TRUE(a.ok()) << to_string(a.error());
  ASSERT_TRUE(b.ok()) << to_string(b.error());
  EXPECT_EQ(a->status, b->status);
  EXPECT_EQ(a->body, b->body);
  ASSERT_EQ(a->headers.size(), b->headers.size());
  for (std::size_t i = 0; i < a->headers.size(); ++i) {
    EXPECT_EQ(a->headers[i].name, b->headers[i].name);
    EXPECT_EQ(a->headers[i].value, b->headers[i].value);
  }
}

TEST(HttpTape, PlaysBackBitExactlyWithTheServerGone) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "tape";
  std::string bytes;  // no text
  for (int i = 0; i < 1000; ++i)
    bytes += static_cast<char>(i * 7);
  MockServer server(
      json::array({{{"body", "one \" \\ \n\t\u0001 ü \r\n"}, {"headers", {{"X-A", "1"}}}},
                   {{"base64", net::base64_of(bytes)}},
                   {{"status", 404}, {"body", ""}}}));
  const net::HttpClient live = recorder(folder);
  std::vector<net::HttpRequest> asked = {
      question(server, "a"), question(server, "b"), question(server, bytes)};
  std::vector<Result<net::HttpAnswer>> answered;
  for (const net::HttpRequest& request : asked)
    answered.push_back(live.send(request));
  server.stop();
  ASSERT_EQ(answered[1]->body, bytes);
  const net::HttpClient again = player(folder);
  for (const std::size_t i : {2U, 0U, 1U})  // in any order
    expect_equal(again.send(asked[i]), answered[i]);
}

TEST(HttpTape, EqualRequestsAreToldApartByTheirNumber) {
  const ScratchFolder scratch;
  MockServer server(json::array({{{"body", "first"}}, {{"body", "second"}}}));
  const net::HttpClient live = recorder(scratch.path());
  const net::HttpRequest request = question(server, "same");
  EXPECT_EQ(live.send(request)->body, "first");
  EXPECT_EQ(live.send(request)->body, "second");
  server.stop();
  const net::HttpClient again = player(scratch.path());
  EXPECT_EQ(again.send(request)->body, "first");
  EXPECT_EQ(again.send(request)->body, "second");
  EXPECT_EQ(again.send(request).error().code, "net.not_recorded");
}

TEST(HttpTape, PicturesOfARequestAreToldApartAndNotKept) {
  const ScratchFolder scratch;
  MockServer server(json::array({{{"body", "a wood floor"}}, {{"body", "tiles"}}}));
  const auto asked_about = [&](char pixel) {
    const std::string picture = net::base64_of(std::string(300'000, pixel));
    return question(server,
                    R"({"url": "data:image/png;base64,)" + picture + R"(", "text": "What?"})");
  };
  const net::HttpClient live = recorder(scratch.path());
  const net::HttpRequest one = asked_about('a'), other = asked_about('b');
  ASSERT_EQ(live.send(one)->body, "a wood floor");
  ASSERT_EQ(live.send(other)->body, "tiles");
  server.stop();
  const std::string kept = all_text_in(scratch.path());
  EXPECT_LT(kept.size(), 10'000U);
  EXPECT_NE(kept.find("What?"), std::string::npos);
  EXPECT_NE(kept.find("[400000 characters of base64, "), std::string::npos) << kept;
  const net::HttpClient again = player(scratch.path());
  EXPECT_EQ(again.send(other)->body, "tiles");
  EXPECT_EQ(again.send(one)->body, "a wood floor");
  EXPECT_EQ(again.send(asked_about('c')).error().code, "net.not_recorded");
}

TEST(HttpTape, WhatWasNotRecordedIsAnErrorAndOpensNoSocket) {
  const ScratchFolder scratch;
  const MockServer server(json::array({{{"body", "x"}}}));
  const auto answer = player(scratch.path()).send(question(server, "never asked"));
  ASSERT_FALSE(answer.ok());
  EXPECT_EQ(answer.error().code, "net.not_recorded");
  EXPECT_NE(answer.error().message.find(server.url("/ask")), std::string::npos);
  EXPECT_TRUE(server.requests().empty());
}

// However a server spells it: what reads the answer as JSON, HTML or a URL undoes that.
TEST(HttpTape, NoEscapedKeyIsInAnAnswer) {
  const std::string key = "sk-A/23456789", after = " and more";
  const std::vector<std::string> spellings{
      R"(\u0073k-A/23456789)",
      R"(\u0073\u006B\u002d\u0041\/\u0032\u0033\u0034\u0035\u0036\u0037\u0038\u0039)",
      R"(\\u0073k-A\/23456789)",
      R"(sk%2DA%2F23456789)",
      R"(&#115;k-A&#x2f;23456789)",
      R"(s\x6b-A/23456789)"};
  for (const std::string& spelling : spellings) {
    const ScratchFolder scratch;
    MockServer server(json::array({{{"body", "{\"error\": \"" + spelling + after + "\"}"}}}));
    net::HttpRequest request = question(server, "hello");
    request.secret_headers = {{"x-api-key", key}};
    const auto answer = recorder(scratch.path()).send(request);
    ASSERT_TRUE(answer.ok());
    EXPECT_EQ(answer->body, "{\"error\": \"***" + after + "\"}") << spelling;
  }
}

TEST(HttpTape, NoKeyIsInAFileOrAnAnswer) {
  const ScratchFolder scratch;
  const std::string key = "sk-0123456789abcdef";
  MockServer server(json::array(
      {{{"body", "your key is " + key + ", " + key + "!"}, {"headers", {{"X-Echo", key}}}}}));
  net::HttpRequest request = question(server, "hello");
  request.secret_headers = {{"Authorization", "Bearer " + key}};
  const auto answer = recorder(scratch.path()).send(request);
  ASSERT_TRUE(answer.ok());
  EXPECT_EQ(answer->body, "your key is ***, ***!");
  EXPECT_EQ(answer->header("x-echo"), "***");
  EXPECT_EQ(server.requests().at(0)["headers"]["Authorization"], "Bearer " + key);
  const std::string recorded = all_text_in(scratch.path());
  EXPECT_NE(recorded.find("hello"), std::string::npos);
  EXPECT_EQ(recorded.find(key), std::string::npos);
  EXPECT_EQ(recorded.find("Authorization"), std::string::npos);
  server.stop();
  request.secret_headers.clear();  // who replays needs no key
  expect_equal(player(scratch.path()).send(request), answer);
}

TEST(HttpTape, BrokenRecordsAndFolders) {
  const ScratchFolder scratch;
  MockServer server(json::array({{{"body", "x"}}}));
  const net::HttpRequest request = question(server, "a");
  ASSERT_TRUE(recorder(scratch.path() / "tape").send(request).ok());
  const fs::path file = fs::directory_iterator(scratch.path() / "tape")->path();
  std::ofstream(file) << R"({"schema": "http-exchange/1", "method": "POST"})";
  EXPECT_EQ(player(scratch.path() / "tape").send(request).error().code, "json.missing_field");
  net::HttpOptions nowhere, both;
  nowhere.replay = scratch.path() / "none";
  EXPECT_EQ(net::HttpClient::open(nowhere).error().code, "input.not_found");
  both.record = both.replay = scratch.path();
  EXPECT_EQ(net::HttpClient::open(both).error().code, "usage.bad_flag");
  std::ofstream(scratch.path() / "file") << "x";
  net::HttpOptions blocked;
  blocked.record = scratch.path() / "file" / "tape";
  EXPECT_EQ(net::HttpClient::open(blocked).error().code, "io.cannot_write");
}

}  // namespace
}  // namespace marketgen
