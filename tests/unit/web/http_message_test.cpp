#include "web/http_message.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/gzip.h"

namespace marketgen {
namespace {

std::string path_or_code(const std::string& uri) {
  const Result<std::string> path = web::path_of(uri);
  return path.ok() ? *path : path.error().code;
}

TEST(Paths, AreDecodedOnce) {
  EXPECT_EQ(path_or_code("/"), "/");
  EXPECT_EQ(path_or_code("/api/stores/0?q=1"), "/api/stores/0");
  EXPECT_EQ(path_or_code("/a%20b"), "/a b");
  EXPECT_EQ(path_or_code("/%2541"), "/%41");
}

TEST(Paths, ThatLeadElsewhereAreRefused) {
  for (const char* uri : {"",
                          "index.html",
                          "http://localhost/",
                          "/..",
                          "/../etc/passwd",
                          "/%2e%2e/etc/passwd",
                          "/a/%2E%2e/b",
                          "/..%2fetc",
                          "//etc/passwd",
                          "/a%5c..%5cb",
                          "/%00",
                          "/a%0d%0aX: y",
                          "/%ff",
                          "/%",
                          "/%4",
                          "/%zz",
                          "/./a"})
    EXPECT_EQ(path_or_code(uri), "server.bad_request") << uri;
  EXPECT_EQ(path_or_code("/" + std::string(2000, 'a')), "server.bad_request");
}

TEST(Queries, AreDecoded) {
  const auto query = web::query_of("q=oat+milk%21&max=5&&empty&q=tea");
  ASSERT_TRUE(query.ok());
  EXPECT_EQ(query->at("q"), "tea");
  EXPECT_EQ(query->at("max"), "5");
  EXPECT_EQ(query->at("empty"), "");
  EXPECT_EQ(web::query_of("q=oat+milk%21")->at("q"), "oat milk!");
  EXPECT_FALSE(web::query_of("q=%ff").ok());
  EXPECT_FALSE(web::query_of("q=%2").ok());
}

TEST(Bodies, ArePackedWhereItPays) {
  const std::string text(10'000, 'a');
  const auto body = web::make_body("application/json", text);
  EXPECT_TRUE(body->packed);
  EXPECT_EQ(*io::gunzip(body->bytes, "body"), text);
  EXPECT_FALSE(web::make_body("application/json", "{}")->packed);
  EXPECT_FALSE(web::make_body("image/jpeg", text)->packed);
  EXPECT_EQ(web::make_body("text/plain", text)->etag, body->etag);
  EXPECT_NE(web::make_body("text/plain", text + "b")->etag, body->etag);
  EXPECT_EQ(web::made_body(body->type, body->bytes)->etag, body->etag);
}

TEST(Errors, SayEverythingAsJson) {
  const auto reply = web::error_reply(404, {"server.not_found", "/x<b>", "\xff broken"});
  EXPECT_EQ(reply.status, 404);
  const nlohmann::json json = nlohmann::json::parse(reply.body->bytes);
  EXPECT_EQ(json["error"]["code"], "server.not_found");
  EXPECT_EQ(json["error"]["where"], "/x<b>");
  EXPECT_EQ(web::status_of({"server.not_found", "", ""}), 404);
  EXPECT_EQ(web::status_of({"server.bad_request", "", ""}), 400);
  EXPECT_EQ(web::status_of({"io.cannot_read", "", ""}), 500);
}

}  // namespace
}  // namespace marketgen
