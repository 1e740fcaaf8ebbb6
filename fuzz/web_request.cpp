// Addresses and queries of the viewer's server: what is taken leads nowhere else, and is decoded
// once.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "web/http_message.h"
#include "web/request_guard.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace marketgen;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  web::HttpAsk ask;
  ask.method = "GET";
  if (const auto path = web::path_of(text); path.ok()) {
    if (path->front() != '/' || path->find("..") == 0) std::abort();
    for (const std::string& part : web::parts_of(*path)) {
      if (part.empty() || part == "." || part == ".." || part.find('/') != std::string::npos)
        std::abort();
    }
    ask.path = *path;
  }
  if (auto query = web::query_of(text); query.ok()) ask.query = std::move(query).value();
  ask.headers["host"] = text;
  static web::RequestGuard guard({.host = "127.0.0.1", .port = 80, .token = ""});
  const bool own = text == "127.0.0.1:80" || text == "localhost:80" || text == "[::1]:80";
  if (!own && text.size() > 15 && !guard.refusal(ask)) std::abort();
  return 0;
}
