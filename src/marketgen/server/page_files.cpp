#include "server/page_files.h"

#include <cstdlib>
#include <map>
#include <string_view>
#include <system_error>
#include <utility>

#include "io/file.h"
#include "io/installation.h"

namespace marketgen::server {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view first_page = "index.html";
constexpr std::uint64_t max_page_bytes = 64U << 20;

std::string type_of_file(const fs::path& file) {
  static const std::map<std::string, std::string> types{
      {".html", "text/html; charset=utf-8"},
      {".js", "text/javascript; charset=utf-8"},
      {".mjs", "text/javascript; charset=utf-8"},
      {".css", "text/css; charset=utf-8"},
      {".json", "application/json"},
      {".map", "application/json"},
      {".svg", "image/svg+xml"},
      {".png", "image/png"},
      {".jpg", "image/jpeg"},
      {".ico", "image/x-icon"},
      {".webmanifest", "application/manifest+json"},
      {".woff2", "font/woff2"},
      {".wasm", "application/wasm"},
      {".txt", "text/plain; charset=utf-8"}};
  const auto found = types.find(file.extension().string());
  return found == types.end() ? "application/octet-stream" : found->second;
}

bool lies_in(const fs::path& folder, const fs::path& file) {
  const fs::path way = file.lexically_relative(folder);
  return !way.empty() && *way.begin() != "..";
}

}  // namespace

Result<fs::path> page_folder() {
  std::vector<fs::path> places;
  if (const char* named = std::getenv("MARKETGEN_VIEWER"); named != nullptr && *named != '\0') {
    places.emplace_back(named);
  } else {
    for (const fs::path& share : io::share_folders())
      places.push_back(share / "viewer/dist");
  }
  for (const fs::path& place : places) {
    std::error_code failed;
    if (fs::exists(place / first_page, failed)) return place.lexically_normal();
  }
  return Error{"usage.unavailable",
               places.front().lexically_normal().string(),
               "the viewer's page is not there: in a source tree build it with `make viewer`, or "
               "set MARKETGEN_VIEWER to the folder with its index.html"};
}

Result<web::HttpReply> page_file(const fs::path& folder, const std::string& path) {
  const Error nothing{"server.not_found", path, "there is no such page; the first is at /"};
  const std::vector<std::string> parts = web::parts_of(path);
  fs::path file = folder;
  for (const std::string& part : parts) {
    if (part.starts_with('.')) return nothing;
    file /= part;
  }
  if (parts.empty()) file /= first_page;
  std::error_code failed;
  const fs::path real = fs::canonical(file, failed), home = fs::canonical(folder, failed);
  if (failed || !lies_in(home, real) || !fs::is_regular_file(real, failed)) return nothing;
  MARKETGEN_TRY(std::string bytes, io::read_file(real, max_page_bytes));
  web::HttpReply reply{.body = web::make_body(type_of_file(real), std::move(bytes))};
  reply.lasting = parts.size() > 1 && parts[0] == "assets";  // Vite names these by their content
  return reply;
}

}  // namespace marketgen::server
